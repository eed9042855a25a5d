// The lines in which the picture changes from one facet to another, or to nothing.
// SPDX-License-Identifier: MIT
#include "render/visibility/seams.h"

#include <utility>

namespace kiri {
namespace {

constexpr std::uint32_t kNoFacet = HalfSeam::kNoFacet;
constexpr std::uint32_t kNobody = SeenBeside::kNothing;
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
  Seams(const FacetViews& views, const Arrangement& map) : views_(views), map_(map) {}

  std::vector<HalfSeam> run(const std::vector<SeenBeside>& seen) {
    for (std::size_t i = 0; i < map_.sides.size(); ++i) {
      if (seen[i].left != seen[i].right) addSide(map_.sides[i], seen[i]);
    }
    countEnds();
    return merged();
  }

 private:
  /// Where on an arc of a facet a half lies, in the half's own direction.
  struct Source {
    std::uint32_t facet = kNoFacet;
    std::uint32_t arc = 0;
    double from = 0;
    double to = 1;
  };

  void addSide(const Side& side, SeenBeside seen) {
    const bool isForward = seen.left != kNobody;
    if (!isForward) std::swap(seen.left, seen.right);
    addHalf(side, isForward, seen.left, seen.right);
    if (seen.right != kNobody) {
      addHalf(side, !isForward, seen.right, seen.left);
    } else {
      halves_.push_back({halves_.back().to, halves_.back().from, kNoFacet, {}});
      sources_.push_back({});
    }
  }

  void addHalf(const Side& side, bool isForward, std::uint32_t facet, std::uint32_t other) {
    HalfSeam half;
    half.from = isForward ? side.from : side.to;
    half.to = isForward ? side.to : side.from;
    half.facet = facet;
    half.piece.arc = isForward ? side.arc : reversed(side.arc);
    if (other != kNobody) half.piece.beyond = views_.all()[other].id;
    Source source;
    const std::uint32_t u = sourceOf(map_, side, facet, other);
    if (u != SideUse::kEnd) {
      const SideUse& use = map_.uses[u];
      const FacetView& owner = views_.all()[use.facet];
      source = {use.facet, use.arc, isForward ? use.t0 : use.t1, isForward ? use.t1 : use.t0};
      half.piece.facet = owner.id;
      half.piece.edge = owner.uses[use.arc].edge;
      half.piece.from = owner.onEdge(use.arc, source.from);
      half.piece.to = owner.onEdge(use.arc, source.to);
    }
    halves_.push_back(half);
    sources_.push_back(source);
  }

  void countEnds() {
    degree_.assign(map_.vertices.size(), 0);
    leaving_.assign(map_.vertices.size(), 0);
    for (std::uint32_t h = 0; h < halves_.size(); ++h) {
      ++degree_[halves_[h].from];
      leaving_[halves_[h].from] += h;
    }
  }

  bool continues(std::uint32_t first, std::uint32_t second) const {
    const BoundaryPiece& a = halves_[first].piece;
    const BoundaryPiece& b = halves_[second].piece;
    if (a.facet != b.facet || a.edge != b.edge || a.beyond != b.beyond || !a.edge.isValid())
      return false;
    if (a.arc.isCurved && sources_[first].arc != sources_[second].arc) return false;
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
    if (halves_[h].facet != kNoFacet && !continues(h, n)) return kNoHalf;
    if (otherOfH.facet != kNoFacet && !continues(n ^ 1U, h ^ 1U)) return kNoHalf;
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
    whole.piece.arc = Arc::line(map_.vertices[whole.from], map_.vertices[whole.to]);
    if (halves_[first].piece.arc.isCurved) {
      const Source& source = sources_[first];
      const Arc& all = views_.all()[source.facet].arcs[source.arc];
      const double to = sources_[last].to;
      const Arc curve =
          source.from < to ? part(all, source.from, to) : reversed(part(all, to, source.from));
      whole.piece.arc =
          Arc::cubic(whole.piece.arc.start, curve.control1, curve.control2, whole.piece.arc.end);
    }
    return whole;
  }

  const FacetViews& views_;
  const Arrangement& map_;
  std::vector<HalfSeam> halves_;
  std::vector<Source> sources_;        ///< for each half
  std::vector<std::uint32_t> degree_;  ///< for each vertex: the seams that end there
  std::vector<std::uint32_t>
      leaving_;  ///< for each vertex: sum of the halves that leave it; of two, gives the other
};

}  // namespace

std::vector<HalfSeam> seamsOf(const FacetViews& views, const Arrangement& map,
                              const std::vector<SeenBeside>& seen) {
  return Seams(views, map).run(seen);
}

}  // namespace kiri
