// One way to make a formula true: a short search by hand, then CaDiCaL.
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "core/flatfold/formula_search.h"

namespace kiri {

/// Solves one formula again and again under different assumptions. Deterministic.
class FormulaSolver {
 public:
  FormulaSolver(const OrderFormula& formula, WorkMeter& meter);
  ~FormulaSolver();
  FormulaSolver(const FormulaSolver&) = delete;
  FormulaSolver& operator=(const FormulaSolver&) = delete;

  /// Looks for values under which the formula and all assumptions hold, trying those of `near`
  /// first (by unknown; empty: no wish). None: the meter stopped. False: there are none.
  std::optional<bool> solve(const std::vector<Term>& assumptions,
                            const std::vector<std::uint8_t>& near);
  /// Makes a term true from now on. Requires that it is true in some way; returns that it can be.
  bool fix(Term t);
  /// The values that were found last, by unknown.
  const std::vector<std::uint8_t>& found() const { return found_; }

 private:
  enum class Outcome { Found, None, Unsure };
  struct Cadical;

  Outcome solveByHand(const std::vector<Term>& assumptions, const std::vector<std::uint8_t>& near);
  std::optional<bool> solveByCadical(const std::vector<Term>& assumptions,
                                     const std::vector<std::uint8_t>& near);

  const OrderFormula& formula_;
  WorkMeter& meter_;
  FormulaSearch search_;
  bool areUnitsFine_;
  int patience_ = 300;  ///< contradictions after which the search by hand gives up
  std::vector<Term> fixed_;
  std::unique_ptr<Cadical> cadical_;
  std::vector<std::uint8_t> found_;
};

}  // namespace kiri
