// SPDX-License-Identifier: MIT
#include "core/flatfold/order_formula.h"

#include <algorithm>
#include <optional>

#include "core/base/disjoint_sets.h"

namespace kiri {

ClauseIndex::ClauseIndex(const OrderFormula& formula)
    : starts_(std::size_t{2} * formula.unknowns + 1, 0) {
  for (const Clause& clause : formula.clauses) {
    for (const Term t : clause) {
      if (t != kNoTerm) ++starts_[t + 1];
    }
  }
  std::partial_sum(starts_.begin(), starts_.end(), starts_.begin());
  clauses_.resize(starts_.back());
  std::vector<std::uint32_t> next(starts_.begin(), starts_.end() - 1);
  for (std::uint32_t c = 0; c < formula.clauses.size(); ++c) {
    for (const Term t : formula.clauses[c]) {
      if (t != kNoTerm) clauses_[next[t]++] = c;
    }
  }
}

namespace {

constexpr std::uint8_t kOpenValue = 2;

/// The clause without its false terms; none when it is true.
std::optional<Clause> whatIsLeft(const Clause& clause, const std::vector<std::uint8_t>& values) {
  Clause left;
  left.fill(kNoTerm);
  std::size_t size = 0;
  for (const Term t : clause) {
    if (t == kNoTerm) break;
    const std::uint8_t value = values[unknownOf(t)];
    if (value == kOpenValue) {
      left[size++] = t;
    } else if ((value ^ (t & 1)) != 0) {
      return std::nullopt;
    }
  }
  return left;
}

}  // namespace

std::vector<FormulaPart> partsOf(const OrderFormula& formula,
                                 const std::vector<std::uint8_t>& values) {
  DisjointSets joined(formula.unknowns);
  std::vector<Clause> clauses;
  for (const Clause& clause : formula.clauses) {
    const std::optional<Clause> left = whatIsLeft(clause, values);
    if (!left) continue;
    clauses.push_back(*left);
    for (const Term t : *left) {
      if (t == kNoTerm) break;
      joined.join(unknownOf((*left)[0]), unknownOf(t));
    }
  }
  std::vector<FormulaPart> parts;
  std::vector<std::uint32_t> partOf(formula.unknowns);
  std::vector<std::uint32_t> placeOf(formula.unknowns);
  for (std::uint32_t u = 0; u < formula.unknowns; ++u) {
    if (values[u] != kOpenValue) continue;
    const std::uint32_t root = joined.find(u);
    if (root == u) {
      partOf[u] = static_cast<std::uint32_t>(parts.size());
      parts.emplace_back();
    }
    FormulaPart& part = parts[partOf[u] = partOf[root]];
    placeOf[u] = part.formula.unknowns++;
    part.origin.push_back(u);
  }
  for (Clause clause : clauses) {
    FormulaPart& part = parts[partOf[unknownOf(clause[0])]];
    for (Term& t : clause) {
      if (t != kNoTerm) t = 2 * placeOf[unknownOf(t)] + (t & 1);
    }
    part.formula.clauses.push_back(clause);
  }
  for (FormulaPart& part : parts) {
    std::vector<Clause>& list = part.formula.clauses;
    std::sort(list.begin(), list.end());
    list.erase(std::unique(list.begin(), list.end()), list.end());
  }
  return parts;
}

}  // namespace kiri
