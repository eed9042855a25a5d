// SPDX-License-Identifier: MIT
#include "core/model/pattern_sheet.h"

#include <algorithm>
#include <cmath>

#include "core/paper/contours.h"
#include "core/paper/pattern_edit.h"

namespace kiri {
namespace {

double distanceFromLine(Vec2 p, Vec2 from, Vec2 to) {
  const double span = distance(from, to);
  return span == 0 ? distance(p, from) : std::abs(cross(to - from, p - from)) / span;
}

/// True when all corners strictly between two of them lie on the straight way.
bool isStraight(const std::vector<Vec2>& corners, std::size_t from, std::size_t to, double near) {
  const std::size_t n = corners.size();
  const Vec2 a = corners[from % n];
  const Vec2 b = corners[to % n];
  for (std::size_t i = from + 1; i < to; ++i) {
    const Vec2 p = corners[i % n];
    if (distanceFromLine(p, a, b) > near || dot(p - a, b - a) <= 0 || dot(p - b, a - b) <= 0)
      return false;
  }
  return true;
}

/// The corners without those on straight sides.
std::vector<Vec2> trueCorners(const std::vector<Vec2>& corners, double near) {
  const std::size_t n = corners.size();
  // The corner farthest from another is a true one.
  std::size_t first = 0;
  for (std::size_t i = 0; i < n; ++i) {
    if (distance(corners[i], corners[0]) > distance(corners[first], corners[0])) first = i;
  }
  std::vector<Vec2> kept{corners[first]};
  std::size_t last = first;
  for (std::size_t i = first + 1; i <= first + n; ++i) {
    if (i < first + n && isStraight(corners, last, i + 1, near)) continue;
    if (i == first + n) break;
    kept.push_back(corners[i % n]);
    last = i;
  }
  // The file's own first corner goes first where it is still there.
  for (std::size_t i = 0; i < n; ++i) {
    const auto at = std::find(kept.begin(), kept.end(), corners[i]);
    if (at == kept.end()) continue;
    std::rotate(kept.begin(), at, kept.end());
    break;
  }
  return kept;
}

/// A rectangle with a corner at the origin, as SheetSpec means one.
bool takeRectangle(const std::vector<Vec2>& corners, SheetSpec& spec) {
  if (corners.size() != 4) return false;
  const auto at = std::find(corners.begin(), corners.end(), Vec2{0, 0});
  if (at == corners.end()) return false;
  std::vector<Vec2> c = corners;
  std::rotate(c.begin(), c.begin() + (at - corners.begin()), c.end());
  const bool isUpright = c[1].y == 0 && c[3].x == 0 && c[2] == Vec2{c[1].x, c[3].y};
  if (!isUpright || c[1].x <= 0 || c[3].y <= 0) return false;
  spec.width = c[1].x;
  spec.height = c[3].y;
  spec.shape = spec.width == spec.height ? SheetSpec::Shape::Square : SheetSpec::Shape::Rectangle;
  return true;
}

double areaWithin(const std::vector<Vec2>& corners) {
  double doubled = 0;
  for (std::size_t i = 1; i + 1 < corners.size(); ++i)
    doubled += cross(corners[i] - corners[0], corners[i + 1] - corners[0]);
  return doubled / 2;
}

/// Numbers of the pieces that hang together by edges with paper on both sides.
std::vector<std::uint32_t> groupsOf(const CreasePattern& pattern) {
  std::vector<std::uint32_t> group(pattern.facets.size(), FacetId::kNone);
  for (std::size_t first = 0; first < group.size(); ++first) {
    if (group[first] != FacetId::kNone) continue;
    std::vector<FacetId> queue{FacetId(first)};
    group[first] = static_cast<std::uint32_t>(first);
    for (std::size_t i = 0; i < queue.size(); ++i) {
      const FacetId here = queue[i];
      for (const EdgeUse use : pattern[here].border) {
        const FacetId next = across(pattern[use.edge], here);
        if (!next.isValid() || group[next.index] != FacetId::kNone) continue;
        group[next.index] = static_cast<std::uint32_t>(first);
        queue.push_back(next);
      }
    }
  }
  return group;
}

}  // namespace

SheetSpec sheetOfOutline(const CreasePattern& pattern) {
  SheetSpec spec;
  spec.shape = SheetSpec::Shape::Polygon;
  // Below what the step's vertices may lie beside the side that they are on.
  const double near = pattern.tolerance.length() / 4;
  double most = 0;
  for (const std::vector<EdgeUse>& contour : contoursOf(pattern)) {
    std::vector<Vec2> corners;
    for (const EdgeUse use : contour) corners.push_back(pattern[startOf(pattern, use)]);
    corners = trueCorners(corners, near);
    const double area = areaWithin(corners);
    if (area > most) {
      most = area;
      spec.outline = std::move(corners);
    } else if (area < 0) {
      spec.holes.push_back(std::move(corners));
    }
  }
  if (spec.holes.empty() && takeRectangle(spec.outline, spec)) spec.outline.clear();
  return spec;
}

PatternStep stepOfCreases(const AssignedPattern& creases) {
  const CreasePattern& pattern = creases.pattern;
  PatternStep step;
  std::vector<bool> isUsed(pattern.vertices.size(), false);
  const auto isCrease = [](const Edge& edge) { return edge.kind != EdgeKind::Border; };
  for (const Edge& edge : pattern.edges) {
    if (!isCrease(edge)) continue;
    isUsed[edge.from.index] = true;
    isUsed[edge.to.index] = true;
  }
  std::vector<std::uint32_t> place(pattern.vertices.size(), 0);
  for (std::size_t v = 0; v < isUsed.size(); ++v) {
    if (!isUsed[v]) continue;
    place[v] = static_cast<std::uint32_t>(step.vertices.size());
    step.vertices.push_back(pattern.vertices[v]);
  }
  for (std::size_t e = 0; e < pattern.edges.size(); ++e) {
    const Edge& edge = pattern.edges[e];
    if (!isCrease(edge)) continue;
    const bool isHinge = edge.kind == EdgeKind::Hinge;
    step.creases.push_back({place[edge.from.index], place[edge.to.index],
                            isHinge ? creases.assignments[e] : Assignment::Cut,
                            isHinge ? edge.angle : 0});
  }
  return step;
}

LargestPiece largestPieceOf(const AssignedPattern& creases) {
  const CreasePattern& pattern = creases.pattern;
  const std::vector<std::uint32_t> group = groupsOf(pattern);
  std::vector<double> area(group.size(), 0);
  for (std::size_t f = 0; f < group.size(); ++f)
    area[group[f]] += areaOf(regionOf(pattern, FacetId(f)));
  const auto best =
      static_cast<std::uint32_t>(std::max_element(area.begin(), area.end()) - area.begin());
  LargestPiece piece{creases, 0};
  std::vector<bool> keep(group.size());
  for (std::size_t f = 0; f < group.size(); ++f) {
    keep[f] = group[f] == best;
    if (group[f] == f && !keep[f]) ++piece.dropped;
  }
  if (piece.dropped == 0) return piece;
  Kept kept = keepFacets(pattern, keep);
  piece.creases = AssignedPattern(std::move(kept.pattern));
  for (std::size_t e = 0; e < pattern.edges.size(); ++e) {
    const Edge& edge = pattern.edges[e];
    const FacetId beside = edge.left.isValid() ? edge.left : edge.right;
    if (beside.isValid() && keep[beside.index])
      piece.creases.assignments.push_back(creases.assignments[e]);
  }
  return piece;
}

}  // namespace kiri
