// Corners of facets that share a hinge share their points; where they disagree, the mean is taken.
// SPDX-License-Identifier: MIT
#include "core/flatfold/folded_lines.h"

#include "core/base/disjoint_sets.h"

namespace kiri {
namespace {

constexpr std::uint32_t kNoPoint = 0xFFFFFFFF;

class Corners {
 public:
  Corners(const AssignedPattern& creases, const FlatMap& map)
      : pattern_(creases.pattern), map_(map), firstCorner_{0} {
    for (const Facet& facet : pattern_.facets)
      firstCorner_.push_back(firstCorner_.back() + static_cast<std::uint32_t>(facet.border.size()));
    joined_ = DisjointSets(firstCorner_.back());
    uses_.assign(pattern_.edges.size(), {kNoPoint, kNoPoint, kNoPoint, kNoPoint});
    for (std::size_t f = 0; f < pattern_.facets.size(); ++f) noteUses(f);
    joinAtHinges();
  }

  FoldedLines lines() {
    FoldedLines made;
    placePoints(made);
    for (std::size_t e = 0; e < pattern_.edges.size(); ++e) {
      const Edge& edge = pattern_.edges[e];
      const std::array<std::uint32_t, 4>& u = uses_[e];
      const bool leftIsLeft = edge.left.isValid() && !map_.poses[edge.left.index].isFlipped;
      const bool rightIsLeft = edge.right.isValid() && map_.poses[edge.right.index].isFlipped;
      if (edge.kind == EdgeKind::Hinge) {
        add(made, u[0], u[1], {EdgeId(e), edge.left, edge.right, leftIsLeft, rightIsLeft});
        continue;
      }
      if (edge.left.isValid())
        add(made, u[0], u[1], {EdgeId(e), edge.left, FacetId(), leftIsLeft, false});
      if (edge.right.isValid())
        add(made, u[2], u[3], {EdgeId(e), edge.right, FacetId(), rightIsLeft, false});
    }
    return made;
  }

 private:
  /// For each edge the corners at its start and end, as its left facet has them, then its right.
  void noteUses(std::size_t f) {
    const Facet& facet = pattern_.facets[f];
    const std::size_t loops = facet.holeStarts.size() + 1;
    for (std::size_t loop = 0; loop < loops; ++loop) {
      const std::size_t first = loop == 0 ? 0 : facet.holeStarts[loop - 1];
      const std::size_t last = loop + 1 < loops ? facet.holeStarts[loop] : facet.border.size();
      for (std::size_t i = first; i < last; ++i) {
        const auto here = static_cast<std::uint32_t>(firstCorner_[f] + i);
        const auto next =
            static_cast<std::uint32_t>(firstCorner_[f] + (i + 1 < last ? i + 1 : first));
        const EdgeUse use = facet.border[i];
        std::array<std::uint32_t, 4>& u = uses_[use.edge.index];
        if (use.isReversed) {
          u[2] = next;
          u[3] = here;
        } else {
          u[0] = here;
          u[1] = next;
        }
      }
    }
  }

  void joinAtHinges() {
    for (std::size_t e = 0; e < pattern_.edges.size(); ++e) {
      if (pattern_.edges[e].kind != EdgeKind::Hinge) continue;
      joined_.join(uses_[e][0], uses_[e][2]);
      joined_.join(uses_[e][1], uses_[e][3]);
    }
  }

  void placePoints(FoldedLines& made) {
    pointOf_.assign(joined_.count(), kNoPoint);
    std::vector<double> counts;
    for (std::size_t f = 0; f < pattern_.facets.size(); ++f) {
      const Facet& facet = pattern_.facets[f];
      for (std::size_t i = 0; i < facet.border.size(); ++i) {
        const auto corner = static_cast<std::uint32_t>(firstCorner_[f] + i);
        const Vec2 place = map_.poses[f].apply(pattern_[startOf(pattern_, facet.border[i])]);
        const std::uint32_t root = joined_.find(corner);
        if (root == corner) {
          pointOf_[corner] = static_cast<std::uint32_t>(made.points.size());
          made.points.push_back(place);
          counts.push_back(1);
          continue;
        }
        const std::uint32_t point = pointOf_[corner] = pointOf_[root];
        counts[point] += 1;
        made.points[point] = made.points[point] + (place - made.points[point]) / counts[point];
      }
    }
  }

  /// Curved borders and cuts become chords.
  void add(FoldedLines& made, std::uint32_t from, std::uint32_t to, FoldedLine line) const {
    std::uint32_t at = pointOf_[from];
    if (pattern_[line.edge].isCurved()) {
      const Arc arc = arcOf(pattern_, line.edge);
      for (const double t : flatteningParameters(arc, pattern_.tolerance.flattening())) {
        if (t <= 0 || t >= 1) continue;
        const auto next = static_cast<std::uint32_t>(made.points.size());
        made.points.push_back(map_.poses[line.first.index].apply(pointAt(arc, t)));
        made.ends.push_back({at, next});
        made.lines.push_back(line);
        at = next;
      }
    }
    made.ends.push_back({at, pointOf_[to]});
    made.lines.push_back(line);
  }

  const CreasePattern& pattern_;
  const FlatMap& map_;
  std::vector<std::uint32_t> firstCorner_;  ///< by facet, into the corners of all facets
  DisjointSets joined_{0};
  std::vector<std::array<std::uint32_t, 4>> uses_;
  std::vector<std::uint32_t> pointOf_;  ///< by corner
};

}  // namespace

FoldedLines foldedLinesOf(const AssignedPattern& creases, const FlatMap& map) {
  return Corners(creases, map).lines();
}

}  // namespace kiri
