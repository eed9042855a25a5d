// Which facets overlap, as rows of bits: pairs and common stacks are found at once.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "core/flatfold/order_problem.h"

namespace kiri {

/// Answers about an OrderProblem, which must outlive it.
class FacetRelation {
 public:
  explicit FacetRelation(const OrderProblem& problem);

  /// Words in a row of bits that has one bit a facet.
  std::size_t words() const { return words_; }
  /// The facets that overlap one.
  const std::uint64_t* overlapping(std::uint32_t facet) const {
    return overlaps_.data() + facet * words_;
  }
  bool doOverlap(std::uint32_t a, std::uint32_t b) const {
    return (overlapping(a)[b >> 6] >> (b & 63) & 1) != 0;
  }
  /// "upper lies above lower". Requires two facets that overlap.
  Literal above(std::uint32_t upper, std::uint32_t lower) const {
    return upper < lower ? Literal(indexOf(upper, lower), false)
                         : Literal(indexOf(lower, upper), true);
  }
  /// True when some stack holds all three.
  bool haveCommonStack(std::uint32_t a, std::uint32_t b, std::uint32_t c) const;

  /// Bytes that the answers will take up, about.
  static std::size_t memoryFor(const OrderProblem& problem);

 private:
  /// Stacks of one facet: the words between its first and its last.
  struct StackRow {
    std::size_t start = 0;   ///< of its words in stackBits_
    std::uint32_t low = 0;   ///< number of its first word
    std::uint32_t high = 0;  ///< one after its last
  };

  std::uint32_t indexOf(std::uint32_t a, std::uint32_t b) const;
  void readStacks(const FacetSets& stacks);

  std::size_t words_;
  std::vector<std::uint64_t> overlaps_;
  std::vector<std::uint32_t> ranks_;  ///< by row and word: pair index of its first bit
  std::vector<StackRow> stackRows_;
  std::vector<std::uint64_t> stackBits_;
};

}  // namespace kiri
