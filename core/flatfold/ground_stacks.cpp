// Most sets are part of a neighbour's; the rest are compared with those that share their rarest
// facet. SPDX-License-Identifier: MIT
#include "core/flatfold/ground_stacks.h"

#include <algorithm>
#include <array>

namespace kiri {
namespace {

/// A few bits of a set: of a part, they are a part.
struct Signature {
  std::array<std::uint64_t, 4> bits{};

  explicit Signature(const std::vector<FacetId>& facets) {
    for (const FacetId f : facets) {
      const std::uint32_t bit = f.index % 256;
      bits[bit / 64] |= std::uint64_t{1} << (bit % 64);
    }
  }
  bool mayBePartOf(const Signature& other) const {
    for (std::size_t i = 0; i < bits.size(); ++i) {
      if ((bits[i] & ~other.bits[i]) != 0) return false;
    }
    return true;
  }
};

/// Cells that no neighbour's set holds; of neighbours with the same set, the first.
std::vector<std::uint32_t> summits(const PlanarCells& cells, const CellFacets& facets) {
  std::vector<bool> isPart(facets.of.size(), false);
  for (std::size_t code = 0; code < cells.leftOf.size(); ++code) {
    const std::uint32_t cell = cells.leftOf[code];
    const std::uint32_t other = cells.leftOf[code ^ 1U];
    const std::vector<FacetId>& mine = facets.of[cell];
    const std::vector<FacetId>& theirs = facets.of[other];
    if (isPart[cell] || mine.size() > theirs.size()) continue;
    if (mine.size() == theirs.size() && (cell <= other || mine != theirs)) continue;
    isPart[cell] = std::includes(theirs.begin(), theirs.end(), mine.begin(), mine.end());
  }
  std::vector<std::uint32_t> found;
  for (std::uint32_t cell = 0; cell < isPart.size(); ++cell) {
    if (!isPart[cell] && facets.of[cell].size() > 1) found.push_back(cell);
  }
  return found;
}

/// The sets kept so far, to be found by the facets in them.
class Kept {
 public:
  Kept(const CellFacets& facets, std::size_t facetCount) : facets_(facets), byFacet_(facetCount) {}

  bool holds(std::uint32_t cell) const {
    const std::vector<FacetId>& set = facets_.of[cell];
    const Signature signature(set);
    const FacetId rarest = *std::min_element(set.begin(), set.end(), [&](FacetId a, FacetId b) {
      return byFacet_[a.index].size() < byFacet_[b.index].size();
    });
    const std::vector<std::uint32_t>& candidates = byFacet_[rarest.index];
    return std::any_of(candidates.begin(), candidates.end(), [&](std::uint32_t kept) {
      const std::vector<FacetId>& other = facets_.of[cells_[kept]];
      return signature.mayBePartOf(signatures_[kept]) &&
             std::includes(other.begin(), other.end(), set.begin(), set.end());
    });
  }

  void add(std::uint32_t cell) {
    for (const FacetId f : facets_.of[cell])
      byFacet_[f.index].push_back(static_cast<std::uint32_t>(cells_.size()));
    cells_.push_back(cell);
    signatures_.emplace_back(facets_.of[cell]);
  }

  const std::vector<std::uint32_t>& cells() const { return cells_; }

 private:
  const CellFacets& facets_;
  std::vector<std::uint32_t> cells_;
  std::vector<Signature> signatures_;
  std::vector<std::vector<std::uint32_t>> byFacet_;
};

std::size_t facetBound(const CellFacets& facets) {
  std::size_t bound = 0;
  for (const std::vector<FacetId>& set : facets.of) {
    if (!set.empty()) bound = std::max<std::size_t>(bound, set.back().index + 1);
  }
  return bound;
}

}  // namespace

FacetSets stacksOf(const PlanarCells& cells, const CellFacets& facets) {
  std::vector<std::uint32_t> order = summits(cells, facets);
  // Large sets first: what holds a set is then already kept.
  std::stable_sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    return facets.of[a].size() > facets.of[b].size();
  });
  Kept kept(facets, facetBound(facets));
  for (const std::uint32_t cell : order) {
    if (!kept.holds(cell)) kept.add(cell);
  }
  std::vector<std::uint32_t> chosen = kept.cells();
  std::sort(chosen.begin(), chosen.end());
  FacetSets stacks;
  for (const std::uint32_t cell : chosen) stacks.add(facets.of[cell]);
  return stacks;
}

std::vector<FacetPair> pairsOf(const FacetSets& stacks, std::size_t facetCount) {
  std::vector<std::vector<std::uint32_t>> stacksWith(facetCount);
  for (std::uint32_t s = 0; s < stacks.size(); ++s) {
    for (const FacetId* f = stacks.begin(s); f != stacks.end(s); ++f)
      stacksWith[f->index].push_back(s);
  }
  std::vector<FacetPair> pairs;
  std::vector<std::uint32_t> seenBy(facetCount, FacetId::kNone);
  for (std::uint32_t a = 0; a < facetCount; ++a) {
    const std::size_t first = pairs.size();
    for (const std::uint32_t s : stacksWith[a]) {
      for (const FacetId* b = std::upper_bound(stacks.begin(s), stacks.end(s), FacetId(a));
           b != stacks.end(s); ++b) {
        if (seenBy[b->index] == a) continue;
        seenBy[b->index] = a;
        pairs.push_back({FacetId(a), *b});
      }
    }
    std::sort(pairs.begin() + static_cast<std::ptrdiff_t>(first), pairs.end());
  }
  return pairs;
}

}  // namespace kiri
