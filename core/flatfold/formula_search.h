// Trying values for the unknowns of a formula: what follows at once, and taking it back.
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "core/flatfold/order_formula.h"
#include "core/flatfold/work_meter.h"

namespace kiri {

/// Values of the unknowns and what follows from them by clauses with one term left. The formula
/// must outlive it.
class FormulaSearch {
 public:
  static constexpr std::uint8_t kFalse = 0;
  static constexpr std::uint8_t kTrue = 1;
  static constexpr std::uint8_t kOpen = 2;

  explicit FormulaSearch(const OrderFormula& formula);

  const OrderFormula& formula() const { return formula_; }
  const ClauseIndex& index() const { return index_; }
  const std::vector<std::uint8_t>& values() const { return values_; }
  std::uint8_t valueOf(std::uint32_t unknown) const { return values_[unknown]; }
  bool isOpen(std::uint32_t unknown) const { return values_[unknown] == kOpen; }
  bool isTrue(Term t) const { return values_[unknownOf(t)] == ((t & 1) ^ 1); }

  /// What clauses of one term say. False: they contradict each other.
  bool assumeUnits();
  /// Makes a term true and follows it up. False: it cannot be; take it back then.
  bool assume(Term t);
  /// How many unknowns have values; a place to go back to.
  std::size_t mark() const { return trail_.size(); }
  void takeBackTo(std::size_t mark);
  /// Steps done since this was asked last.
  std::size_t takeSteps() { return std::exchange(steps_, 0); }

 private:
  bool set(Term t);
  bool followUp();
  bool follow(const Clause& clause);

  const OrderFormula& formula_;
  ClauseIndex index_;
  std::vector<std::uint8_t> values_;
  std::vector<Term> trail_;
  std::size_t followed_ = 0;
  std::size_t steps_ = 0;
};

}  // namespace kiri
