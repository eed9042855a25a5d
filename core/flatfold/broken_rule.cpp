// SPDX-License-Identifier: MIT
#include <bit>
#include <string>

#include "core/flatfold/layer_states.h"

namespace kiri {

namespace {

std::string namesOf(const OrderProblem& problem, Literal l) {
  const FacetPair& pair = problem.pairs[l.pair()];
  return std::to_string(pair.a.index) + " and " + std::to_string(pair.b.index);
}

/// One bit a facet: those that lie above each facet.
class RowsAbove {
 public:
  RowsAbove(const OrderProblem& problem, const LayerValues& values)
      : words_((problem.facetCount + 63) / 64), rows_(problem.facetCount * words_) {
    for (std::size_t p = 0; p < problem.pairs.size(); ++p) {
      const FacetPair& pair = problem.pairs[p];
      const std::size_t upper = values[p] ? pair.a.index : pair.b.index;
      const std::size_t lower = values[p] ? pair.b.index : pair.a.index;
      rows_[lower * words_ + (upper >> 6)] |= std::uint64_t{1} << (upper & 63);
    }
  }

  /// An order of all, pair by pair, has no ring when no two of its members have equally many others
  /// above them.
  bool hasRing(const FacetId* begin, const FacetId* end) {
    mask_.assign(words_, 0);
    for (const FacetId* f = begin; f != end; ++f) {
      mask_[f->index >> 6] |= std::uint64_t{1} << (f->index & 63);
    }
    isTaken_.assign(static_cast<std::size_t>(end - begin), false);
    for (const FacetId* f = begin; f != end; ++f) {
      std::size_t above = 0;
      for (std::size_t w = 0; w < words_; ++w) {
        above += static_cast<std::size_t>(std::popcount(rows_[f->index * words_ + w] & mask_[w]));
      }
      if (isTaken_[above]) return true;
      isTaken_[above] = true;
    }
    return false;
  }

 private:
  std::size_t words_;
  std::vector<std::uint64_t> rows_;
  std::vector<std::uint64_t> mask_;
  std::vector<bool> isTaken_;
};

}  // namespace

std::optional<std::string> brokenRule(const OrderProblem& problem, const LayerValues& values) {
  if (values.size() != problem.pairs.size()) return "there is not one order for each pair";
  const auto isTrue = [&](Literal l) { return values[l.pair()] != l.isNegated(); };
  for (const Literal l : problem.known) {
    if (!isTrue(l)) return "facets " + namesOf(problem, l) + " are folded the other way round";
  }
  for (const SameOrder& same : problem.same) {
    if (isTrue(same.first) == isTrue(same.second)) continue;
    return "paper passes through paper: the order of facets " + namesOf(problem, same.first) +
           " changes against that of " + namesOf(problem, same.second) + " along a crease";
  }
  for (const Interleaving& i : problem.interleavings) {
    if (isTrue(i.ac) ^ isTrue(i.bc) ^ isTrue(i.ad) ^ isTrue(i.bd)) {
      return "two folds pass through each other: facets " + namesOf(problem, i.ac) + ", " +
             namesOf(problem, i.bd);
    }
  }
  RowsAbove rows(problem, values);
  for (std::size_t s = 0; s < problem.stacks.size(); ++s) {
    if (rows.hasRing(problem.stacks.begin(s), problem.stacks.end(s))) {
      return "facets that lie on each other go round in a ring; one of them is " +
             std::to_string(problem.stacks.begin(s)->index);
    }
  }
  return std::nullopt;
}

}  // namespace kiri
