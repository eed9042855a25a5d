// The planar map's queries.
// SPDX-License-Identifier: MIT
#include "core/paper/crease_pattern.h"
#include "core/paper/facet_bounds.h"

#include <algorithm>

namespace kiri {
namespace {

bool isStraightConvex(const CreasePattern& pattern, const Facet& facet) {
  if (!facet.holeStarts.empty()) return false;
  const std::size_t n = facet.border.size();
  const double tol = pattern.tolerance.length();
  for (std::size_t i = 0; i < n; ++i) {
    if (pattern[facet.border[i].edge].isCurved()) return false;
    const Vec2 a = pattern[startOf(pattern, facet.border[i])];
    const Vec2 b = pattern[endOf(pattern, facet.border[i])];
    const Vec2 c = pattern[endOf(pattern, facet.border[(i + 1) % n])];
    if (cross(b - a, c - b) < -tol * (length(b - a) + length(c - b))) return false;
    if (dot(b - a, c - b) < 0 && cross(b - a, c - b) <= 0) return false;
  }
  return true;
}

Vec2 meanOfCorners(const CreasePattern& pattern, const Facet& facet) {
  Vec2 sum;
  for (const EdgeUse use : facet.border) sum = sum + pattern[startOf(pattern, use)];
  return sum / static_cast<double>(facet.border.size());
}

}  // namespace

CreasePattern patternOf(const Sheet& sheet) {
  CreasePattern pattern(sheet.tolerance());
  Facet facet;
  for (const Loop& loop : sheet.outline.loops) {
    if (!facet.border.empty()) {
      facet.holeStarts.push_back(static_cast<std::uint32_t>(facet.border.size()));
    }
    const std::size_t first = pattern.vertices.size();
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const std::size_t next = i + 1 < loop.size() ? first + i + 1 : first;
      pattern.vertices.push_back(loop[i].start);
      Edge edge;
      edge.from = VertexId(first + i);
      edge.to = VertexId(next);
      edge.left = FacetId(0);
      if (loop[i].isCurved) {
        edge.curve = static_cast<std::uint32_t>(pattern.curves.size());
        pattern.curves.push_back({loop[i].control1, loop[i].control2});
      }
      facet.border.push_back({EdgeId(pattern.edges.size()), false});
      pattern.edges.push_back(edge);
    }
  }
  pattern.facets.push_back(std::move(facet));
  return pattern;
}

VertexId startOf(const CreasePattern& pattern, EdgeUse use) {
  const Edge& edge = pattern[use.edge];
  return use.isReversed ? edge.to : edge.from;
}

VertexId endOf(const CreasePattern& pattern, EdgeUse use) {
  const Edge& edge = pattern[use.edge];
  return use.isReversed ? edge.from : edge.to;
}

FacetId across(const Edge& edge, FacetId facet) {
  return edge.left == facet ? edge.right : edge.left;
}

Arc arcOf(const CreasePattern& pattern, EdgeId id) {
  const Edge& edge = pattern[id];
  const Vec2 from = pattern[edge.from];
  const Vec2 to = pattern[edge.to];
  if (!edge.isCurved()) return Arc::line(from, to);
  const CurveControls& c = pattern.curves[edge.curve];
  return Arc::cubic(from, c.control1, c.control2, to);
}

Arc arcOf(const CreasePattern& pattern, EdgeUse use) {
  const Arc arc = arcOf(pattern, use.edge);
  return use.isReversed ? reversed(arc) : arc;
}

Region regionOf(const CreasePattern& pattern, FacetId id) {
  const Facet& facet = pattern[id];
  Region region;
  region.loops.emplace_back();
  std::size_t hole = 0;
  for (std::size_t i = 0; i < facet.border.size(); ++i) {
    if (hole < facet.holeStarts.size() && facet.holeStarts[hole] == i) {
      region.loops.emplace_back();
      ++hole;
    }
    region.loops.back().push_back(arcOf(pattern, facet.border[i]));
  }
  return region;
}

Vec2 interiorPointOf(const CreasePattern& pattern, FacetId id) {
  const Facet& facet = pattern[id];
  if (isStraightConvex(pattern, facet)) return meanOfCorners(pattern, facet);
  return interiorPoint(regionOf(pattern, id), pattern.tolerance);
}

std::optional<FacetId> facetAt(const CreasePattern& pattern, Vec2 paper) {
  const double tol = pattern.tolerance.length();
  const double pick = pattern.tolerance.pick();
  std::optional<FacetId> onBorder;
  std::optional<FacetId> near;
  for (std::size_t i = 0; i < pattern.facets.size(); ++i) {
    if (!holds(boundsOf(pattern, pattern.facets[i]), paper, pick)) continue;
    const Region region = regionOf(pattern, FacetId(i));
    const Where where = locate(region, paper, tol);
    if (where == Where::Inside) return FacetId(i);
    if (where == Where::OnBorder && !onBorder) onBorder = FacetId(i);
    if (!near && locate(region, paper, pick) != Where::Outside) near = FacetId(i);
  }
  return onBorder ? onBorder : near;
}

double areaOf(const CreasePattern& pattern) {
  double sum = 0;
  for (const Facet& facet : pattern.facets) {
    double twice = 0;
    for (const EdgeUse use : facet.border) twice += doubleArea(arcOf(pattern, use));
    sum += twice / 2;
  }
  return sum;
}

}  // namespace kiri
