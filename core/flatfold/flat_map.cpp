// Facets are placed outward along the longest creases; all other hinges then say how well it fits.
// SPDX-License-Identifier: MIT
#include "core/flatfold/flat_map.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

#include "core/base/disjoint_sets.h"
#include "core/base/text.h"
#include "core/flatfold/vertex_fan.h"

namespace kiri {
namespace {

/// What two facets disagree by may be this part of the sheet: small misses at many vertices add up.
constexpr double kMisfitOfSheet = 1.0 / 200;
/// Hinges named in an error.
constexpr std::size_t kNamedHinges = 8;

/// The pose of the facet across a straight hinge.
FlatPose poseAcross(const FlatPose& pose, Vec2 from, Vec2 to, bool isFolded) {
  if (!isFolded) return pose;
  // The reflection in the line maps p to M p + t with M = [[c, s], [s, -c]].
  const Vec2 d = normalized(to - from);
  const double c = d.x * d.x - d.y * d.y;
  const double s = 2 * d.x * d.y;
  const Vec2 shift = from - Vec2{c * from.x + s * from.y, s * from.x - c * from.y};
  FlatPose across;
  across.x = pose.x * c + pose.y * s;
  across.y = pose.x * s - pose.y * c;
  across.origin = pose.apply(shift);
  across.isFlipped = !pose.isFlipped;
  return across;
}

std::vector<EdgeId> hingesByLength(const CreasePattern& pattern) {
  std::vector<std::pair<double, EdgeId>> hinges;
  for (std::size_t e = 0; e < pattern.edges.size(); ++e) {
    const Edge& edge = pattern.edges[e];
    if (edge.kind != EdgeKind::Hinge) continue;
    hinges.emplace_back(-distance(pattern[edge.from], pattern[edge.to]), EdgeId(e));
  }
  std::sort(hinges.begin(), hinges.end());
  std::vector<EdgeId> sorted;
  sorted.reserve(hinges.size());
  for (const auto& [length, e] : hinges) sorted.push_back(e);
  return sorted;
}

std::vector<double> areasOf(const CreasePattern& pattern) {
  std::vector<double> areas(pattern.facets.size(), 0);
  for (std::size_t f = 0; f < areas.size(); ++f) {
    const Facet& facet = pattern.facets[f];
    if (facet.border.empty()) continue;
    const Vec2 start = pattern[startOf(pattern, facet.border.front())];
    for (const EdgeUse use : facet.border) {
      areas[f] +=
          cross(pattern[startOf(pattern, use)] - start, pattern[endOf(pattern, use)] - start);
    }
  }
  return areas;
}

/// Places facets piece by piece, the largest of each piece as on the paper.
class Placing {
 public:
  explicit Placing(const AssignedPattern& creases)
      : creases_(creases), pattern_(creases.pattern), next_(pattern_.facets.size()) {
    DisjointSets joined(pattern_.facets.size());
    for (const EdgeId e : hingesByLength(pattern_)) {
      const Edge& edge = pattern_[e];
      if (!joined.join(edge.left.index, edge.right.index)) continue;
      next_[edge.left.index].push_back(e);
      next_[edge.right.index].push_back(e);
    }
  }

  FlatMap place() {
    const std::vector<double> areas = areasOf(pattern_);
    std::vector<FacetId> order;
    for (std::size_t f = 0; f < areas.size(); ++f) order.push_back(FacetId(f));
    std::stable_sort(order.begin(), order.end(),
                     [&](FacetId a, FacetId b) { return areas[a.index] > areas[b.index]; });
    map_.poses.resize(areas.size());
    map_.vertices = pattern_.vertices;
    isPlaced_.assign(areas.size(), false);
    isVertexPlaced_.assign(pattern_.vertices.size(), false);
    for (const FacetId root : order) {
      if (!isPlaced_[root.index]) placePiece(root);
    }
    return std::move(map_);
  }

 private:
  void placePiece(FacetId root) {
    std::vector<FacetId> queue{root};
    isPlaced_[root.index] = true;
    for (std::size_t i = 0; i < queue.size(); ++i) {
      const FacetId f = queue[i];
      placeVertices(f);
      for (const EdgeId e : next_[f.index]) {
        const Edge& edge = pattern_[e];
        const FacetId g = across(edge, f);
        if (isPlaced_[g.index]) continue;
        isPlaced_[g.index] = true;
        map_.poses[g.index] = poseAcross(map_.poses[f.index], pattern_[edge.from],
                                         pattern_[edge.to], creases_.isFolded(e));
        queue.push_back(g);
      }
    }
  }

  void placeVertices(FacetId f) {
    for (const EdgeUse use : pattern_[f].border) {
      const VertexId v = startOf(pattern_, use);
      if (isVertexPlaced_[v.index]) continue;
      isVertexPlaced_[v.index] = true;
      map_.vertices[v.index] = map_.poses[f.index].apply(pattern_[v]);
    }
  }

  const AssignedPattern& creases_;
  const CreasePattern& pattern_;
  std::vector<std::vector<EdgeId>> next_;  ///< by facet, hinges of the spanning trees
  FlatMap map_;
  std::vector<bool> isPlaced_;
  std::vector<bool> isVertexPlaced_;
};

/// By how much the facets of a hinge disagree about where it lies, mm.
double misfitOf(const CreasePattern& pattern, const FlatMap& map, const Edge& edge) {
  const FlatPose& left = map.poses[edge.left.index];
  const FlatPose& right = map.poses[edge.right.index];
  double worst = 0;
  for (const VertexId v : {edge.from, edge.to})
    worst = std::max(worst, distance(left.apply(pattern[v]), right.apply(pattern[v])));
  return worst;
}

void addHinge(const CreasePattern& pattern, EdgeId e, Witness& witness) {
  witness.segments.emplace_back(pattern[pattern[e].from], pattern[pattern[e].to]);
}

std::string placeOf(const CreasePattern& pattern, EdgeId e) {
  return "the crease from " + text(pattern[pattern[e].from]) + " to " +
         text(pattern[pattern[e].to]) + " mm";
}

/// A vertex, away from borders and cuts, at which an odd number of folded creases meet.
std::optional<VertexId> oddVertex(const std::vector<VertexFan>& fans) {
  const auto odd = std::find_if(fans.begin(), fans.end(),
                                [](const VertexFan& f) { return f.creases.size() % 2 == 1; });
  if (odd == fans.end()) return std::nullopt;
  return odd->vertex;
}

/// A vertex that misses Kawasaki's condition by more than ends explain that were meant for other
/// places within reach of a drawing hand.
std::optional<Error> bentVertex(const CreasePattern& pattern, const std::vector<VertexFan>& fans) {
  const VertexFan* worst = nullptr;
  double most = 0;
  for (const VertexFan& fan : fans) {
    const double miss = fan.kawasakiMiss();
    if (miss <= fan.explainedBy(pattern.tolerance.pick()) || miss <= most) continue;
    most = miss;
    worst = &fan;
  }
  if (worst == nullptr) return std::nullopt;
  Error error{ErrorCode::WouldStretch, {}, {}};
  error.witness.points.push_back(pattern[worst->vertex]);
  for (const EdgeId e : worst->creases) addHinge(pattern, e, error.witness);
  error.message = "the pattern does not fold flat: at " + text(pattern[worst->vertex]) +
                  " mm alternate angles add up to 180 degrees but for " + text(most) +
                  "; turn one of the creases there";
  return error;
}

Error flippedBothWays(const AssignedPattern& creases, const std::vector<VertexFan>& fans,
                      const std::vector<EdgeId>& hinges) {
  Error error{ErrorCode::WouldStretch, {}, {}};
  for (std::size_t i = 0; i < std::min(hinges.size(), kNamedHinges); ++i)
    addHinge(creases.pattern, hinges[i], error.witness);
  if (const std::optional<VertexId> v = oddVertex(fans)) {
    error.witness.points.push_back(creases.pattern[*v]);
    error.message = "the pattern does not fold flat: an odd number of folded creases meet at " +
                    text(creases.pattern[*v]) + " mm; add or remove a crease there";
  } else {
    error.message = "the pattern does not fold flat: going around a hole or slit, " +
                    placeOf(creases.pattern, hinges.front()) +
                    " has the wrong side of the paper up; an even number of folded creases must "
                    "lead around a hole";
  }
  return error;
}

Error apart(const AssignedPattern& creases, const FlatMap& map, EdgeId worst) {
  const CreasePattern& pattern = creases.pattern;
  Error error{ErrorCode::WouldStretch, {}, {}};
  addHinge(pattern, worst, error.witness);
  error.message = "the pattern does not fold flat: folded, the two sides of " +
                  placeOf(pattern, worst) + " lie " + text(misfitOf(pattern, map, pattern[worst])) +
                  " mm apart; see where alternate angles do not add up to 180 degrees";
  return error;
}

}  // namespace

Result<FlatMap> flatMapOf(const AssignedPattern& creases) {
  const CreasePattern& pattern = creases.pattern;
  FlatMap map = Placing(creases).place();
  std::vector<EdgeId> mirrored;
  EdgeId worst;
  for (std::size_t e = 0; e < pattern.edges.size(); ++e) {
    const Edge& edge = pattern.edges[e];
    if (edge.kind != EdgeKind::Hinge) continue;
    const bool turns =
        map.poses[edge.left.index].isFlipped != map.poses[edge.right.index].isFlipped;
    if (turns != creases.isFolded(EdgeId(e))) mirrored.push_back(EdgeId(e));
    const double misfit = misfitOf(pattern, map, edge);
    if (misfit <= map.error && worst.isValid()) continue;
    map.error = misfit;
    worst = EdgeId(e);
  }
  const std::vector<VertexFan> fans = fansInside(creases);
  if (!mirrored.empty()) return flippedBothWays(creases, fans, mirrored);
  if (std::optional<Error> bent = bentVertex(pattern, fans)) return *bent;
  if (map.error > kMisfitOfSheet * pattern.tolerance.sheetSize()) return apart(creases, map, worst);
  return map;
}

}  // namespace kiri
