// Which facets overlap in the flat folded paper, and what ties their orders together.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "core/base/ids.h"
#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/flatfold/flat_map.h"

namespace kiri {

/// Two facets that overlap, a < b. The unknown: does `a` lie above `b`, seen with the facet of the
/// largest area face up?
struct FacetPair {
  FacetId a;
  FacetId b;
  constexpr auto operator<=>(const FacetPair&) const = default;
};

/// An unknown or its opposite.
struct Literal {
  std::uint32_t code = 0;  ///< 2 * index of the pair, + 1 when negated

  constexpr Literal() = default;
  constexpr Literal(std::uint32_t pair, bool isNegated) : code(2 * pair + (isNegated ? 1 : 0)) {}
  constexpr std::uint32_t pair() const { return code >> 1; }
  constexpr bool isNegated() const { return (code & 1) != 0; }
  constexpr Literal operator!() const {
    Literal l;
    l.code = code ^ 1;
    return l;
  }
  constexpr auto operator<=>(const Literal&) const = default;
};

/// Both or neither: paper that goes on (a flat crease, or both sides of a fold) past other paper
/// keeps its side of it (tortilla-tortilla, taco-tortilla).
struct SameOrder {
  Literal first;
  Literal second;
};

/// Two folds along one line on the same side must not interleave (taco-taco): an even number of
/// "a above c", "b above c", "a above d", "b above d" holds; with the cells' orders being free of
/// rings that is all.
struct Interleaving {
  Literal ac, bc, ad, bd;
};

/// All facets that cover one piece of the ground, sorted; their order there has no ring.
class FacetSets {
 public:
  std::size_t size() const { return starts_.empty() ? 0 : starts_.size() - 1; }
  const FacetId* begin(std::size_t set) const { return facets_.data() + starts_[set]; }
  const FacetId* end(std::size_t set) const { return facets_.data() + starts_[set + 1]; }
  std::size_t depth(std::size_t set) const { return starts_[set + 1] - starts_[set]; }
  void add(const std::vector<FacetId>& sorted);

 private:
  std::vector<FacetId> facets_;
  std::vector<std::size_t> starts_{0};
};

/// Everything that decides which layer orders there are. Made from geometry once; the search knows
/// nothing but this.
struct OrderProblem {
  std::size_t facetCount = 0;
  std::vector<FacetPair> pairs;  ///< sorted; a Literal's pair is a position in this list
  FacetSets stacks;              ///< of the cells of the folded ground; none is part of another
  std::vector<SameOrder> same;
  std::vector<Interleaving> interleavings;
  std::vector<Literal> known;  ///< what mountains and valleys say

  /// Where the pairs of each facet `a` begin in `pairs`, and where the last ones end: speeds
  /// indexOf up. Made by indexPairs; may be empty.
  std::vector<std::uint32_t> pairStarts;

  /// Position of a pair in `pairs` (a < b); kNone when the facets do not overlap.
  std::uint32_t indexOf(FacetId a, FacetId b) const;
  static constexpr std::uint32_t kNone = 0xFFFFFFFF;
  /// "x lies above y". Requires two facets that overlap.
  Literal above(FacetId x, FacetId y) const;
  void indexPairs();
};

}  // namespace kiri
