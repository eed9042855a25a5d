// A formula in clauses of up to four terms, and its division into parts that share no unknown.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace kiri {

/// An unknown of a formula or its opposite: 2 * unknown + 1 when negated.
using Term = std::uint32_t;
constexpr Term kNoTerm = 0xFFFFFFFF;

constexpr std::uint32_t unknownOf(Term t) { return t >> 1; }
constexpr Term opposite(Term t) { return t ^ 1; }

/// One of the terms holds. Terms are sorted and name different unknowns; kNoTerm stands last.
using Clause = std::array<Term, 4>;

constexpr std::size_t sizeOf(const Clause& clause) {
  std::size_t size = 0;
  while (size < clause.size() && clause[size] != kNoTerm) ++size;
  return size;
}

struct OrderFormula {
  std::uint32_t unknowns = 0;
  std::vector<Clause> clauses;  ///< sorted, none twice
};

/// The clauses in which a term or its opposite stands, by term.
class ClauseIndex {
 public:
  explicit ClauseIndex(const OrderFormula& formula);

  const std::uint32_t* begin(Term t) const { return clauses_.data() + starts_[t]; }
  const std::uint32_t* end(Term t) const { return clauses_.data() + starts_[t + 1]; }

 private:
  std::vector<std::uint32_t> starts_;
  std::vector<std::uint32_t> clauses_;
};

/// A formula over some of the unknowns of another: unknown i is `origin[i]` of that.
struct FormulaPart {
  OrderFormula formula;
  std::vector<std::uint32_t> origin;
};

/// What is left when `values` (by unknown: 0 false, 1 true, 2 open) are put in: one part for each
/// set of open unknowns that hang together, ordered by their first. No clause may be false, none
/// may have one term left.
std::vector<FormulaPart> partsOf(const OrderFormula& formula,
                                 const std::vector<std::uint8_t>& values);

}  // namespace kiri
