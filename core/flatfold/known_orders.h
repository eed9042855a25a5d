// What follows from mountains, valleys and geometry alone: propagation over all pairs.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "core/flatfold/facet_relation.h"
#include "core/flatfold/work_meter.h"

namespace kiri {

/// The orders that a problem forces by single steps: ties, interleavings with one order left,
/// two sides of a triangle. Circles are looked for among rows of bits (who is known to lie above,
/// below), so a pair costs a few words for each 64 facets, not a step for each third facet.
/// The problem and the relation must outlive it.
class KnownOrders {
 public:
  KnownOrders(const OrderProblem& problem, const FacetRelation& relation);

  /// Follows everything up. False: the known orders contradict each other, or the meter stopped.
  bool propagate(WorkMeter& meter);

  bool isKnown(std::uint32_t pair) const { return values_[pair] != kOpen; }
  /// Truth of a known literal.
  bool isTrue(Literal l) const { return values_[l.pair()] == (l.isNegated() ? kFalse : kTrue); }
  /// Facets known to lie above one, a bit each.
  const std::uint64_t* above(std::uint32_t facet) const {
    return above_.data() + facet * relation_.words();
  }
  const std::uint64_t* below(std::uint32_t facet) const {
    return below_.data() + facet * relation_.words();
  }

  bool isContradicted() const { return isContradicted_; }
  /// All facets that had a part in the contradiction, sorted. Requires one.
  std::vector<FacetId> contradiction() const;
  /// The facets from which the orders of some known pairs follow, with their own.
  std::vector<FacetId> reasonsOf(const std::vector<std::uint32_t>& pairs) const;

  /// Bytes that it will take up, about.
  static std::size_t memoryFor(const OrderProblem& problem);

 private:
  enum class ReasonKind : std::uint8_t { Given, Same, Interleaving, Circle };
  struct Reason {
    ReasonKind kind = ReasonKind::Given;
    std::uint32_t index = 0;  ///< into the problem's list; Circle: the third facet
  };
  static constexpr std::uint8_t kOpen = 2;
  static constexpr std::uint8_t kTrue = 1;
  static constexpr std::uint8_t kFalse = 0;

  void indexTies();
  bool set(Literal literal, Reason reason);
  bool followPair(std::uint32_t pair);
  bool followSame(std::uint32_t index);
  bool followInterleaving(std::uint32_t index);
  bool followCircles(std::uint32_t upper, std::uint32_t lower);
  void addSources(std::uint32_t pair, Reason reason, std::vector<std::uint32_t>& sources) const;

  const OrderProblem& problem_;
  const FacetRelation& relation_;
  std::vector<std::uint8_t> values_;
  std::vector<Reason> reasons_;
  std::vector<std::uint64_t> above_;
  std::vector<std::uint64_t> below_;
  /// For each pair the ties it takes part in: numbers below same.size() are of `same`, the others
  /// of `interleavings`.
  std::vector<std::uint32_t> tieStarts_;
  std::vector<std::uint32_t> ties_;
  std::vector<std::uint32_t> queue_;
  std::size_t followed_ = 0;
  bool isContradicted_ = false;
  std::uint32_t contradictedPair_ = 0;
  Reason contradictedBy_;
};

}  // namespace kiri
