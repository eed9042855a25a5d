// SPDX-License-Identifier: MIT
#include "core/sweep/facet_shapes.h"

#include <algorithm>
#include <cmath>

#include "core/geometry/hull.h"

namespace kiri {
namespace {

constexpr double kCut = 0.25;  // of the distance from a corner to the sides that do not meet in it

double distanceToSegment(Vec2 p, Vec2 a, Vec2 b) {
  const Vec2 u = b - a;
  const double t = std::clamp(dot(p - a, u) / dot(u, u), 0.0, 1.0);
  return distance(p, a + u * t);
}

/// The corner of a polygon at a point, or its number of corners.
std::size_t cornerAt(const std::vector<Vec2>& polygon, Vec2 p, double near) {
  std::size_t i = 0;
  while (i < polygon.size() && distance(polygon[i], p) > near) ++i;
  return i;
}

/// How far a piece is nothing but the angle of its corner; HUGE_VAL when it has no corner there.
double angleRadius(const std::vector<Vec2>& polygon, Vec2 p, double near) {
  const std::size_t n = polygon.size();
  const std::size_t corner = cornerAt(polygon, p, near);
  double radius = HUGE_VAL;
  if (corner == n) return radius;
  for (std::size_t k = 1; k + 1 < n; ++k) {
    radius = std::min(
        radius, distanceToSegment(p, polygon[(corner + k) % n], polygon[(corner + k + 1) % n]));
  }
  return radius;
}

void cutCorner(std::vector<Vec2>& polygon, Vec2 p, double length, double near) {
  const std::size_t n = polygon.size();
  const std::size_t corner = cornerAt(polygon, p, near);
  if (corner == n) return;
  const Vec2 before = polygon[(corner + n - 1) % n];
  const Vec2 after = polygon[(corner + 1) % n];
  polygon[corner] = p + normalized(before - p) * length;
  polygon.insert(polygon.begin() + static_cast<std::ptrdiff_t>(corner) + 1,
                 p + normalized(after - p) * length);
}

std::vector<Vec2> hullOf(const Pieces& pieces) {
  std::vector<Vec2> points;
  for (const std::vector<Vec2>& piece : pieces)
    points.insert(points.end(), piece.begin(), piece.end());
  return convexHull(std::move(points));
}

}  // namespace

FacetShapes::FacetShapes(const CreasePattern& pattern, FacetDetail detail)
    : pattern_(pattern), pieces_(pattern.facets.size()), fans_(pattern.facets.size()) {
  for (std::size_t f = 0; f < pieces_.size(); ++f) {
    for (ConvexPart& part : convexParts(regionOf(pattern, FacetId(f)), pattern.tolerance))
      pieces_[f].push_back(std::move(part.points));
    if (detail == FacetDetail::Hull && pieces_[f].size() > 1) pieces_[f] = {hullOf(pieces_[f])};
  }
  std::vector<std::vector<EdgeId>> hinges(pattern.vertices.size());
  for (std::size_t e = 0; e < pattern.edges.size(); ++e) {
    const Edge& edge = pattern.edges[e];
    if (edge.kind != EdgeKind::Hinge) continue;
    hinges[edge.from.index].push_back(EdgeId(e));
    hinges[edge.to.index].push_back(EdgeId(e));
  }
  for (std::size_t v = 0; v < hinges.size(); ++v) joinAround(VertexId(v), hinges[v]);
}

void FacetShapes::joinAround(VertexId vertex, const std::vector<EdgeId>& hinges) {
  std::map<FacetId, FacetId> lowest;
  for (const EdgeId e : hinges) {
    lowest.emplace(pattern_[e].left, pattern_[e].left);
    lowest.emplace(pattern_[e].right, pattern_[e].right);
  }
  // As often as there are hinges: then the lowest facet has gone around.
  for (std::size_t i = 0; i < hinges.size(); ++i) {
    for (const EdgeId e : hinges) {
      FacetId& left = lowest[pattern_[e].left];
      FacetId& right = lowest[pattern_[e].right];
      left = right = std::min(left, right);
    }
  }
  for (const auto& [facet, root] : lowest) fans_[facet.index].push_back({vertex, root});
}

bool FacetShapes::shareHinge(FacetId a, FacetId b) const {
  const std::vector<EdgeUse>& border = pattern_[a].border;
  return std::any_of(border.begin(), border.end(), [&](EdgeUse use) {
    const Edge& edge = pattern_[use.edge];
    return edge.kind == EdgeKind::Hinge && across(edge, a) == b;
  });
}

std::vector<VertexId> FacetShapes::commonVertices(FacetId a, FacetId b) const {
  std::vector<VertexId> common;
  for (const auto& fan : fans_[a.index]) {
    const auto& other = fans_[b.index];
    if (std::find(other.begin(), other.end(), fan) != other.end()) common.push_back(fan.first);
  }
  return common;
}

const std::pair<Pieces, Pieces>& FacetShapes::pairOf(FacetId a, FacetId b) const {
  const auto known = pairs_.find({a, b});
  if (known != pairs_.end()) return known->second;
  std::pair<Pieces, Pieces> pair{piecesOf(a), piecesOf(b)};
  const double near = pattern_.tolerance.length();
  for (const VertexId v : commonVertices(a, b)) {
    const Vec2 p = pattern_[v];
    double radius = HUGE_VAL;
    for (const Pieces* pieces : {&pair.first, &pair.second}) {
      for (const std::vector<Vec2>& piece : *pieces)
        radius = std::min(radius, angleRadius(piece, p, near));
    }
    if (radius == HUGE_VAL) continue;
    for (Pieces* pieces : {&pair.first, &pair.second}) {
      for (std::vector<Vec2>& piece : *pieces) cutCorner(piece, p, kCut * radius, near);
    }
  }
  return pairs_.emplace(std::pair{a, b}, std::move(pair)).first->second;
}

}  // namespace kiri
