// SPDX-License-Identifier: MIT
#include "core/flatfold/formula_search.h"

namespace kiri {

FormulaSearch::FormulaSearch(const OrderFormula& formula)
    : formula_(formula), index_(formula), values_(formula.unknowns, kOpen) {}

bool FormulaSearch::assumeUnits() {
  for (const Clause& clause : formula_.clauses) {
    if (sizeOf(clause) == 1 && !set(clause[0])) return false;
  }
  return followUp();
}

bool FormulaSearch::assume(Term t) { return set(t) && followUp(); }

void FormulaSearch::takeBackTo(std::size_t mark) {
  while (trail_.size() > mark) {
    values_[unknownOf(trail_.back())] = kOpen;
    trail_.pop_back();
  }
  followed_ = mark;
}

bool FormulaSearch::set(Term t) {
  std::uint8_t& value = values_[unknownOf(t)];
  const std::uint8_t wanted = static_cast<std::uint8_t>((t & 1) ^ 1);
  if (value != kOpen) return value == wanted;
  value = wanted;
  trail_.push_back(t);
  return true;
}

bool FormulaSearch::followUp() {
  while (followed_ < trail_.size()) {
    const Term gone = opposite(trail_[followed_++]);
    const std::uint32_t* end = index_.end(gone);
    for (const std::uint32_t* c = index_.begin(gone); c != end; ++c) {
      if (!follow(formula_.clauses[*c])) return false;
    }
    steps_ += 10 + 4 * static_cast<std::size_t>(end - index_.begin(gone));
  }
  return true;
}

bool FormulaSearch::follow(const Clause& clause) {
  Term left = kNoTerm;
  for (const Term t : clause) {
    if (t == kNoTerm) break;
    const std::uint8_t value = values_[unknownOf(t)];
    if (value == kOpen) {
      if (left != kNoTerm) return true;
      left = t;
    } else if (value == ((t & 1) ^ 1)) {
      return true;
    }
  }
  return left != kNoTerm && set(left);
}

}  // namespace kiri
