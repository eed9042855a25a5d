// SPDX-License-Identifier: MIT
#include "core/flatfold/formula_solver.h"

#include <cadical.hpp>

namespace kiri {

/// The library's solver; made when the search by hand first gives up.
struct FormulaSolver::Cadical : CaDiCaL::Terminator {
  explicit Cadical(WorkMeter& m) : meter(m) { solver.connect_terminator(this); }
  Cadical(const Cadical&) = delete;
  Cadical& operator=(const Cadical&) = delete;
  ~Cadical() override { solver.disconnect_terminator(); }

  bool terminate() override { return !meter.spend(kStepsBetweenAsks); }
  static int literalOf(Term t) {
    const int number = static_cast<int>(unknownOf(t)) + 1;
    return (t & 1) != 0 ? -number : number;
  }

  static constexpr std::size_t kStepsBetweenAsks = 10000;
  WorkMeter& meter;
  CaDiCaL::Solver solver;
};

FormulaSolver::FormulaSolver(const OrderFormula& formula, WorkMeter& meter)
    : formula_(formula), meter_(meter), search_(formula), areUnitsFine_(search_.assumeUnits()) {}

FormulaSolver::~FormulaSolver() = default;

std::optional<bool> FormulaSolver::solve(const std::vector<Term>& assumptions,
                                         const std::vector<std::uint8_t>& near) {
  if (!areUnitsFine_) return false;
  const Outcome outcome = solveByHand(assumptions, near);
  if (meter_.isStopped()) return std::nullopt;
  if (outcome != Outcome::Unsure) return outcome == Outcome::Found;
  return solveByCadical(assumptions, near);
}

/// Unknown after unknown in their order, back to the last choice at a contradiction; a few hundred
/// of those are enough for most, and cheaper than a library that prepares for millions.
FormulaSolver::Outcome FormulaSolver::solveByHand(const std::vector<Term>& assumptions,
                                                  const std::vector<std::uint8_t>& near) {
  struct Choice {
    std::uint32_t unknown;
    std::size_t mark;
    Term term;
    bool isSecond;
  };
  const std::size_t start = search_.mark();
  for (const Term t : assumptions) {
    if (search_.assume(t)) continue;
    search_.takeBackTo(start);
    return Outcome::None;
  }
  std::vector<Choice> choices;
  Outcome outcome = Outcome::Unsure;
  int contradictions = 0;
  for (std::uint32_t u = 0;;) {
    while (u < formula_.unknowns && !search_.isOpen(u)) ++u;
    if (u == formula_.unknowns) {
      found_ = search_.values();
      outcome = Outcome::Found;
      break;
    }
    const bool isWanted = near.empty() || near[u] == FormulaSearch::kTrue;
    choices.push_back({u, search_.mark(), 2 * u + (isWanted ? 0 : 1), false});
    bool isFine = search_.assume(choices.back().term);
    while (!isFine && !choices.empty()) {
      ++contradictions;
      search_.takeBackTo(choices.back().mark);
      if (choices.back().isSecond) {
        choices.pop_back();
        continue;
      }
      choices.back().isSecond = true;
      isFine = search_.assume(opposite(choices.back().term));
    }
    if (!isFine) outcome = Outcome::None;
    if (!isFine || contradictions > patience_ || !meter_.spend(search_.takeSteps())) break;
    u = choices.back().unknown;
  }
  search_.takeBackTo(start);
  // Where it gave up once it will do so again.
  if (outcome == Outcome::Unsure) patience_ /= 4;
  return outcome;
}

bool FormulaSolver::fix(Term t) {
  if (cadical_) {
    cadical_->solver.add(Cadical::literalOf(t));
    cadical_->solver.add(0);
  }
  fixed_.push_back(t);
  return search_.assume(t);
}

std::optional<bool> FormulaSolver::solveByCadical(const std::vector<Term>& assumptions,
                                                  const std::vector<std::uint8_t>& near) {
  constexpr int kSatisfiable = 10;
  constexpr int kUnsatisfiable = 20;
  if (!cadical_) {
    cadical_ = std::make_unique<Cadical>(meter_);
    for (const Clause& clause : formula_.clauses) {
      for (const Term t : clause) {
        if (t != kNoTerm) cadical_->solver.add(Cadical::literalOf(t));
      }
      cadical_->solver.add(0);
    }
    for (const Term t : fixed_) {
      cadical_->solver.add(Cadical::literalOf(t));
      cadical_->solver.add(0);
    }
    cadical_->solver.reserve(static_cast<int>(formula_.unknowns));
  }
  CaDiCaL::Solver& solver = cadical_->solver;
  for (std::uint32_t u = 0; u < near.size(); ++u) {
    solver.phase(Cadical::literalOf(2 * u + (near[u] == FormulaSearch::kTrue ? 0 : 1)));
  }
  for (const Term t : assumptions) solver.assume(Cadical::literalOf(t));
  const int answer = solver.solve();
  if (answer == kUnsatisfiable) return false;
  if (answer != kSatisfiable) return std::nullopt;
  found_.resize(formula_.unknowns);
  for (std::uint32_t u = 0; u < formula_.unknowns; ++u) {
    found_[u] =
        solver.val(Cadical::literalOf(2 * u)) > 0 ? FormulaSearch::kTrue : FormulaSearch::kFalse;
  }
  return true;
}

}  // namespace kiri
