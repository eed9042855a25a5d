// SPDX-License-Identifier: MIT
#include "core/flatfold/free_parts.h"

#include <algorithm>

#include "core/flatfold/formula_solver.h"

namespace kiri {

namespace {

class FreePartsFinder {
 public:
  FreePartsFinder(std::uint32_t unknowns, bool isOneEnough, WorkMeter& meter)
      : isOneEnough_(isOneEnough), meter_(meter) {
    out_.fixed.assign(unknowns, FormulaSearch::kOpen);
  }

  Result<FreeParts> find(const OrderFormula& formula) {
    FormulaPart whole{formula, {}};
    for (std::uint32_t u = 0; u < formula.unknowns; ++u) whole.origin.push_back(u);
    divide(whole, {});
    if (meter_.isStopped()) {
      return meter_.error(std::to_string(out_.parts.size()) + " independent parts were found");
    }
    std::sort(out_.parts.begin(), out_.parts.end(),
              [](const FreePart& a, const FreePart& b) { return a.origin[0] < b.origin[0]; });
    return std::move(out_);
  }

 private:
  /// Divides a part after some of its unknowns got values. `first`: a way of the part, if known.
  void divide(const FormulaPart& part, const std::vector<Term>& fixed,
              const std::vector<std::uint8_t>& first = {}) {
    FormulaSearch search(part.formula);
    bool isFine = search.assumeUnits();
    for (const Term t : fixed) isFine = isFine && search.assume(t);
    if (!isFine) return block(part);
    for (std::uint32_t u = 0; u < part.formula.unknowns; ++u) {
      out_.fixed[part.origin[u]] = search.valueOf(u);
    }
    for (FormulaPart& piece : partsOf(part.formula, search.values())) {
      std::vector<std::uint8_t> pieceFirst;
      for (std::uint32_t& u : piece.origin) {
        if (!first.empty()) pieceFirst.push_back(first[u]);
        u = part.origin[u];
      }
      solve(std::move(piece), std::move(pieceFirst));
      if (!out_.areThere || meter_.isStopped()) return;
    }
  }

  void block(const FormulaPart& part) {
    out_.areThere = false;
    out_.blocked = part.origin;
  }

  /// A part without clauses of one term. With `first` all its unknowns are known to be free.
  void solve(FormulaPart part, std::vector<std::uint8_t> first) {
    if (!first.empty()) return keep(std::move(part), std::move(first));
    if (part.formula.unknowns == 1) return keep(std::move(part), {FormulaSearch::kTrue});
    FormulaSolver solver(part.formula, meter_);
    const std::optional<bool> isSolved = solver.solve({}, {});
    if (!isSolved) return;
    if (!*isSolved) return block(part);
    if (isOneEnough_) return;
    first = solver.found();
    const std::optional<std::vector<Term>> fixed = fixedTerms(part.formula, first, solver);
    if (!fixed) return;
    if (fixed->empty()) return keep(std::move(part), std::move(first));
    divide(part, *fixed, first);
  }

  /// Terms that hold in every way. None: the meter stopped.
  std::optional<std::vector<Term>> fixedTerms(const OrderFormula& formula,
                                              const std::vector<std::uint8_t>& first,
                                              FormulaSolver& solver) {
    std::vector<bool> isFree(formula.unknowns, false);
    std::vector<Term> fixed;
    std::vector<std::uint8_t> other = first;
    for (std::uint8_t& value : other) value ^= 1;
    for (std::uint32_t u = 0; u < formula.unknowns; ++u) {
      if (isFree[u]) continue;
      const Term now = 2 * u + (first[u] == FormulaSearch::kTrue ? 0 : 1);
      const std::optional<bool> isSolved = solver.solve({opposite(now)}, other);
      if (!isSolved) return std::nullopt;
      if (!*isSolved) {
        fixed.push_back(now);
        KIRI_CHECK(solver.fix(now), "what holds in every way can hold");
        continue;
      }
      for (std::uint32_t v = 0; v < formula.unknowns; ++v) {
        if (solver.found()[v] != first[v]) isFree[v] = true;
      }
    }
    return fixed;
  }

  void keep(FormulaPart part, std::vector<std::uint8_t> first) {
    for (const std::uint32_t u : part.origin) out_.fixed[u] = FormulaSearch::kOpen;
    out_.parts.push_back({std::move(part.formula), std::move(part.origin), std::move(first)});
  }

  bool isOneEnough_;
  WorkMeter& meter_;
  FreeParts out_;
};

}  // namespace

Result<FreeParts> freePartsOf(const OrderFormula& formula, bool isOneEnough, WorkMeter& meter) {
  return FreePartsFinder(formula.unknowns, isOneEnough, meter).find(formula);
}

}  // namespace kiri
