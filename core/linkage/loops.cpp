// Loops are the faces of the graph of facets and hinges, found by walking around the paper's ends.
// SPDX-License-Identifier: MIT
#include "core/linkage/loops.h"

#include <cstdint>
#include <map>

#include "core/paper/folded_state.h"

namespace kiri {
namespace {

/// Follows vertices and contours around: from use to use, with the paper on the left.
class LoopWalk {
 public:
  explicit LoopWalk(const CreasePattern& pattern)
      : pattern_(pattern), next_(2 * pattern.edges.size()), isSeen_(2 * pattern.edges.size()) {
    for (const Facet& facet : pattern.facets) linkBorder(facet);
  }

  std::vector<HingeLoop> run() {
    for (const Facet& facet : pattern_.facets) {
      for (const EdgeUse use : facet.border) {
        if (!isSeen_[slot(use)]) walk(use);
      }
    }
    dropOneContourOfEachPiece();
    std::vector<HingeLoop> loops;
    for (HingeLoop& loop : vertices_) loops.push_back(std::move(loop));
    for (HingeLoop& loop : contours_) {
      if (!loop.crossings.empty()) loops.push_back(std::move(loop));
    }
    return loops;
  }

 private:
  static std::size_t slot(EdgeUse use) { return 2 * use.edge.index + (use.isReversed ? 1 : 0); }

  void linkBorder(const Facet& facet) {
    std::size_t start = 0;
    for (std::size_t hole = 0; hole <= facet.holeStarts.size(); ++hole) {
      const std::size_t end =
          hole < facet.holeStarts.size() ? facet.holeStarts[hole] : facet.border.size();
      for (std::size_t i = start; i < end; ++i)
        next_[slot(facet.border[i])] = facet.border[i + 1 < end ? i + 1 : start];
      start = end;
    }
  }

  /// From one use around until it comes again: all hinges meet in one vertex when none but hinges
  /// are passed.
  void walk(EdgeUse start) {
    HingeLoop loop;
    loop.centre = pattern_[endOf(pattern_, start)];
    loop.isVertex = true;
    FacetId facet;
    EdgeUse use = start;
    do {
      isSeen_[slot(use)] = true;
      const EdgeUse next = next_[slot(use)];
      const Edge& edge = pattern_[next.edge];
      facet = next.isReversed ? edge.right : edge.left;
      if (edge.kind == EdgeKind::Hinge) {
        cross(loop, next);
        use = {next.edge, !next.isReversed};
      } else {
        loop.isVertex = false;
        use = next;
      }
    } while (!(use == start));
    closeUp(loop);
    if (loop.isVertex) {
      vertices_.push_back(std::move(loop));
    } else {
      contours_.push_back(std::move(loop));
      contourFacets_.push_back(facet);
    }
  }

  void cross(HingeLoop& loop, EdgeUse use) {
    std::vector<Crossing>& crossings = loop.crossings;
    if (!crossings.empty() && crossings.back().hinge == use.edge) {
      crossings.pop_back();  // forth and back
      return;
    }
    const Edge& edge = pattern_[use.edge];
    const Vec2 a = pattern_[edge.from];
    crossings.push_back({use.edge, use.isReversed ? 1.0 : -1.0, a - loop.centre,
                         normalized(pattern_[edge.to] - a)});
  }

  static void closeUp(HingeLoop& loop) {
    std::vector<Crossing>& crossings = loop.crossings;
    std::size_t cut = 0;
    while (crossings.size() >= 2 * (cut + 1) &&
           crossings[cut].hinge == crossings[crossings.size() - 1 - cut].hinge)
      ++cut;
    crossings.erase(crossings.end() - static_cast<std::ptrdiff_t>(cut), crossings.end());
    crossings.erase(crossings.begin(), crossings.begin() + static_cast<std::ptrdiff_t>(cut));
  }

  /// The outermost contour goes around everything: it closes when the others do. The one with the
  /// most crossings costs most.
  void dropOneContourOfEachPiece() {
    const std::vector<std::uint32_t> piece = piecesOf(pattern_);
    std::map<std::uint32_t, std::size_t> longest;
    for (std::size_t i = 0; i < contours_.size(); ++i) {
      const auto [at, isNew] = longest.emplace(piece[contourFacets_[i].index], i);
      if (!isNew && contours_[i].crossings.size() > contours_[at->second].crossings.size())
        at->second = i;
    }
    for (const auto& [p, i] : longest) contours_[i].crossings.clear();
  }

  const CreasePattern& pattern_;
  std::vector<EdgeUse> next_;  ///< the use that follows in the facet's border
  std::vector<bool> isSeen_;
  std::vector<HingeLoop> vertices_;
  std::vector<HingeLoop> contours_;
  std::vector<FacetId> contourFacets_;
};

}  // namespace

std::vector<HingeLoop> loopsOf(const CreasePattern& pattern) { return LoopWalk(pattern).run(); }

Rigid turnOf(const Crossing& crossing, const FoldAngles& angles) {
  return rotationAbout({crossing.point.x, crossing.point.y, 0},
                       {crossing.direction.x, crossing.direction.y, 0},
                       crossing.sign * angles[crossing.hinge.index]);
}

Rigid turnOf(const HingeLoop& loop, const FoldAngles& angles) {
  Rigid turn;
  for (const Crossing& crossing : loop.crossings) turn = compose(turn, turnOf(crossing, angles));
  return turn;
}

}  // namespace kiri
