// SPDX-License-Identifier: MIT
#include "core/flatfold/facet_relation.h"

#include <algorithm>
#include <bit>

namespace kiri {

FacetRelation::FacetRelation(const OrderProblem& problem)
    : words_((problem.facetCount + 63) / 64),
      overlaps_(problem.facetCount * words_),
      ranks_(problem.facetCount * words_),
      stackRows_(problem.facetCount) {
  std::vector<std::uint32_t> starts(problem.facetCount + 1, 0);
  for (const FacetPair& pair : problem.pairs) {
    const std::size_t a = pair.a.index;
    const std::size_t b = pair.b.index;
    overlaps_[a * words_ + (b >> 6)] |= std::uint64_t{1} << (b & 63);
    overlaps_[b * words_ + (a >> 6)] |= std::uint64_t{1} << (a & 63);
    ++starts[a + 1];
  }
  for (std::size_t f = 0; f < problem.facetCount; ++f) {
    starts[f + 1] += starts[f];
    // Pairs are listed with the lower facet first: bits up to the facet itself do not count.
    std::uint32_t lower = 0;
    const std::uint64_t* row = overlaps_.data() + f * words_;
    for (std::size_t w = 0; w < f >> 6; ++w)
      lower += static_cast<std::uint32_t>(std::popcount(row[w]));
    const std::uint64_t below = (std::uint64_t{1} << (f & 63)) - 1;
    lower += static_cast<std::uint32_t>(std::popcount(row[f >> 6] & below));
    std::uint32_t rank = starts[f] - lower;
    for (std::size_t w = 0; w < words_; ++w) {
      ranks_[f * words_ + w] = rank;
      rank += static_cast<std::uint32_t>(std::popcount(row[w]));
    }
  }
  readStacks(problem.stacks);
}

void FacetRelation::readStacks(const FacetSets& stacks) {
  for (std::size_t s = 0; s < stacks.size(); ++s) {
    const std::uint32_t word = static_cast<std::uint32_t>(s >> 6);
    for (const FacetId* f = stacks.begin(s); f != stacks.end(s); ++f) {
      StackRow& row = stackRows_[f->index];
      if (row.high == 0) row.low = word;
      row.high = word + 1;
    }
  }
  std::size_t total = 0;
  for (StackRow& row : stackRows_) {
    row.start = total;
    total += row.high - row.low;
  }
  stackBits_.resize(total);
  for (std::size_t s = 0; s < stacks.size(); ++s) {
    for (const FacetId* f = stacks.begin(s); f != stacks.end(s); ++f) {
      const StackRow& row = stackRows_[f->index];
      stackBits_[row.start + (s >> 6) - row.low] |= std::uint64_t{1} << (s & 63);
    }
  }
}

std::uint32_t FacetRelation::indexOf(std::uint32_t a, std::uint32_t b) const {
  const std::size_t place = a * words_ + (b >> 6);
  const std::uint64_t before = overlaps_[place] & ((std::uint64_t{1} << (b & 63)) - 1);
  return ranks_[place] + static_cast<std::uint32_t>(std::popcount(before));
}

bool FacetRelation::haveCommonStack(std::uint32_t a, std::uint32_t b, std::uint32_t c) const {
  const StackRow& ra = stackRows_[a];
  const StackRow& rb = stackRows_[b];
  const StackRow& rc = stackRows_[c];
  const std::uint32_t low = std::max({ra.low, rb.low, rc.low});
  const std::uint32_t high = std::min({ra.high, rb.high, rc.high});
  if (low >= high) return false;
  const std::uint64_t* pa = stackBits_.data() + ra.start + (low - ra.low);
  const std::uint64_t* pb = stackBits_.data() + rb.start + (low - rb.low);
  const std::uint64_t* pc = stackBits_.data() + rc.start + (low - rc.low);
  for (std::uint32_t w = 0; w < high - low; ++w) {
    if ((pa[w] & pb[w] & pc[w]) != 0) return true;
  }
  return false;
}

std::size_t FacetRelation::memoryFor(const OrderProblem& problem) {
  const std::size_t words = (problem.facetCount + 63) / 64;
  const std::size_t stackWords = (problem.stacks.size() + 63) / 64;
  return problem.facetCount * (words * 12 + stackWords * 8);
}

}  // namespace kiri
