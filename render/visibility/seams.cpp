// The lines in which the picture changes from one facet to another, or to nothing.
// SPDX-License-Identifier: MIT
#include "render/visibility/seams.h"

#include <utility>

namespace kiri {
namespace {

constexpr std::uint32_t kNoFacet = HalfSeam::kNoFacet;
constexpr std::uint32_t kNothing = SeenBeside::kNothing;
constexpr std::uint32_t kNoHalf = std::numeric_limits<std::uint32_t>::max();

/// The use of a side that tells best where the boundary of `facet` against `other` comes from: its
/// own edge, else one of the other's.
std::uint32_t sourceOf(const Arrangement& map, const Side& side, std::uint32_t facet,
                       std::uint32_t other) {
  std::uint32_t best = SideUse::kEnd;
  int bestWorth = 0;
  for (std::uint32_t u = side.firstUse; u != SideUse::kEnd; u = map.uses[u].next) {
    const std::uint32_t f = map.uses[u].facet;
    const int worth = f == facet ? 3 : f == other ? 2 : 1;
    if (worth > bestWorth || (worth == bestWorth && f < map.uses[best].facet)) {
      best = u;
      bestWorth = worth;
    }
  }
  return best;
}

class Seams {
 public:
  Seams(const FoldedState& state, const ViewFrame& view, const FacetViews& views,
        const Arrangement& map)
      : state_(state), view_(view), views_(views), map_(map) {}

  std::vector<HalfSeam> run(const std::vector<SeenBeside>& seen) {
    for (std::size_t i = 0; i < map_.sides.size(); ++i) {
      if (seen[i].left != seen[i].right) addSide(map_.sides[i], seen[i]);
    }
    countEnds();
    return merged();
  }

 private:
  void addSide(const Side& side, SeenBeside seen) {
    const bool isForward = seen.left != kNothing;
    if (!isForward) std::swap(seen.left, seen.right);
    addHalf(side, isForward, seen.left, seen.right);
    if (seen.right != kNothing) {
      addHalf(side, !isForward, seen.right, seen.left);
    } else {
      halves_.push_back({halves_.back().to, halves_.back().from, kNoFacet, {}});
    }
  }

  void addHalf(const Side& side, bool isForward, std::uint32_t facet, std::uint32_t other) {
    HalfSeam half;
    half.from = isForward ? side.from : side.to;
    half.to = isForward ? side.to : side.from;
    half.facet = facet;
    half.piece.arc = isForward ? side.arc : reversed(side.arc);
    if (other != kNothing) half.piece.beyond = views_.all()[other].id;
    const std::uint32_t u = sourceOf(map_, side, facet, other);
    if (u != SideUse::kEnd) {
      const SideUse& use = map_.uses[u];
      const FacetView& owner = views_.all()[use.facet];
      const EdgeUse edge = owner.uses[use.arc];
      half.piece.facet = owner.id;
      half.piece.edge = edge.edge;
      half.piece.from = edge.isReversed ? 1 - use.t0 : use.t0;
      half.piece.to = edge.isReversed ? 1 - use.t1 : use.t1;
      if (!isForward) std::swap(half.piece.from, half.piece.to);
    }
    halves_.push_back(half);
  }

  void countEnds() {
    degree_.assign(map_.vertices.size(), 0);
    leaving_.assign(map_.vertices.size(), 0);
    for (std::uint32_t h = 0; h < halves_.size(); ++h) {
      ++degree_[halves_[h].from];
      leaving_[halves_[h].from] += h;
    }
  }

  static bool continues(const BoundaryPiece& a, const BoundaryPiece& b) {
    if (a.facet != b.facet || a.edge != b.edge || a.beyond != b.beyond || !a.edge.isValid())
      return false;
    return a.to == b.from && (a.from < a.to) == (b.from < b.to);
  }

  /// The half that continues h along the same edge for both facets that they part; kNoHalf where
  /// something else of the picture ends too.
  std::uint32_t next(std::uint32_t h) const {
    const std::uint32_t v = halves_[h].to;
    if (degree_[v] != 2) return kNoHalf;
    const std::uint32_t n = leaving_[v] - (h ^ 1U);
    const HalfSeam& otherOfH = halves_[h ^ 1U];
    const HalfSeam& otherOfN = halves_[n ^ 1U];
    if (halves_[h].facet != halves_[n].facet || otherOfH.facet != otherOfN.facet) return kNoHalf;
    if (halves_[h].facet != kNoFacet && !continues(halves_[h].piece, halves_[n].piece))
      return kNoHalf;
    if (otherOfH.facet != kNoFacet && !continues(otherOfN.piece, otherOfH.piece)) return kNoHalf;
    return n;
  }

  std::vector<HalfSeam> merged() const {
    std::vector<bool> isDone(halves_.size(), false);
    std::vector<HalfSeam> out;
    for (std::uint32_t h = 0; h < halves_.size(); h += 2) {
      if (isDone[h]) continue;
      std::uint32_t first = h;  // walk back to where the run begins
      for (std::uint32_t b = next(first ^ 1U); b != kNoHalf && (b ^ 1U) != h; b = next(first ^ 1U))
        first = b ^ 1U;
      std::uint32_t last = first;
      isDone[first] = isDone[first ^ 1U] = true;
      for (std::uint32_t n = next(last); n != kNoHalf && n != first; n = next(last)) {
        last = n;
        isDone[n] = isDone[n ^ 1U] = true;
      }
      addRun(first, last, out);
    }
    return out;
  }

  /// The halves from `first` to `last` as one, and the same as seen from the other hand.
  void addRun(std::uint32_t first, std::uint32_t last, std::vector<HalfSeam>& out) const {
    out.push_back(joined(first, last));
    out.push_back(joined(last ^ 1U, first ^ 1U));
  }

  HalfSeam joined(std::uint32_t first, std::uint32_t last) const {
    HalfSeam whole = halves_[first];
    if (first == last || whole.facet == kNoFacet) {
      whole.to = halves_[last].to;
      return whole;
    }
    whole.to = halves_[last].to;
    whole.piece.to = halves_[last].piece.to;
    const Arc straight = Arc::line(map_.vertices[whole.from], map_.vertices[whole.to]);
    whole.piece.arc = whole.piece.arc.isCurved ? curveOf(whole.piece, straight) : straight;
    return whole;
  }

  /// The part of a curved edge that a piece names, in the view, between the ends of `chord`.
  Arc curveOf(const BoundaryPiece& piece, const Arc& chord) const {
    const Arc edge = arcOf(state_.pattern, piece.edge);
    const Arc onPaper = piece.from < piece.to ? part(edge, piece.from, piece.to)
                                              : reversed(part(edge, piece.to, piece.from));
    const Rigid& pose = state_.poseOf(piece.facet);
    return Arc::cubic(chord.start, view_.project(pose.apply(onPaper.control1)),
                      view_.project(pose.apply(onPaper.control2)), chord.end);
  }

  const FoldedState& state_;
  const ViewFrame& view_;
  const FacetViews& views_;
  const Arrangement& map_;
  std::vector<HalfSeam> halves_;
  std::vector<std::uint32_t> degree_;  ///< for each vertex: the seams that end there
  std::vector<std::uint32_t>
      leaving_;  ///< for each vertex: sum of the halves that leave it; of two, gives the other
};

}  // namespace

std::vector<HalfSeam> seamsOf(const FoldedState& state, const ViewFrame& view,
                              const FacetViews& views, const Arrangement& map,
                              const std::vector<SeenBeside>& seen) {
  return Seams(state, view, views, map).run(seen);
}

}  // namespace kiri
