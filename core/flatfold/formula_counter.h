// How many ways there are to make a formula true, and which is the n-th.
// SPDX-License-Identifier: MIT
#pragma once

#include <boost/multiprecision/cpp_int.hpp>
#include <memory>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "core/flatfold/formula_search.h"
#include "core/flatfold/formula_solver.h"

namespace kiri {

/// Counts that were found, by what was counted. When full, what was not asked for lately goes.
class CountCache {
 public:
  using Count = boost::multiprecision::cpp_int;

  explicit CountCache(std::size_t memory) : memory_(memory) {}

  const Count* find(const std::string& key);
  void keep(std::string key, const Count& count);

 private:
  using Table = std::unordered_map<std::string, Count>;

  std::size_t memory_;
  std::size_t used_ = 0;  ///< bytes of `young_`, about
  Table young_;
  Table old_;
};

/// A search tree in which open unknowns fall into parts that are counted by themselves, each once.
/// Where only a limited number is wanted, branches without any way are found by a solver, so the
/// first ways of formulas that nobody can count are walked.
/// The tree, and with it the numbers of the ways, depends on the formula and on `first` alone:
/// way 0 is `first`. Requires that `first` makes the formula true.
class FormulaCounter {
 public:
  using Count = CountCache::Count;

  FormulaCounter(const OrderFormula& formula, const std::vector<std::uint8_t>& first,
                 CountCache& cache, WorkMeter& meter);

  /// The number of ways when it is below `limit`, else some number from `limit` up. None: the meter
  /// stopped.
  std::optional<Count> count(const Count& limit);
  std::optional<Count> count();

  /// Values of all unknowns in way `number`; an empty list when there are not so many (`number` is
  /// then lowered to how many there are). None: the meter stopped.
  std::optional<std::vector<std::uint8_t>> way(Count& number);

 private:
  /// Open unknowns that hang together.
  struct Part {
    std::vector<std::uint32_t> unknowns;   ///< ascending
    std::vector<std::uint32_t> shortened;  ///< clauses, ascending, that lost terms but are not true
    std::uint32_t branch = 0;              ///< the unknown to try
  };

  std::vector<Part> partsOfAll();
  std::vector<Part> partsOfOpen(const std::vector<std::uint32_t>& unknowns);
  void reach(std::uint32_t unknown, Part& part);
  void weigh(const Clause& clause, std::uint32_t index, Part& part);
  Count countPart(const Part& part, const Count* limit);
  Count countSplit(const Part& part, const Count* limit);
  Count countBranch(const Part& part, Term t, const Count* limit);
  Count countParts(const std::vector<Part>& parts, const Count* limit);
  bool goTo(const std::vector<Part>& parts, Count& number);
  void goToPart(const Part& part, Count number);
  Term firstBranch(const Part& part) const;
  bool canGoOn();

  FormulaSearch search_;
  const std::vector<std::uint8_t>& first_;
  CountCache& cache_;
  WorkMeter& meter_;
  std::vector<std::uint32_t> unknownSeen_;
  std::vector<std::uint32_t> clauseSeen_;
  std::vector<std::uint32_t> weights_;  ///< by unknown, of the round it was seen in
  std::uint32_t round_ = 0;
  std::unordered_map<std::string, Count> atLeast_;  ///< parts that have no fewer ways than this
  std::vector<Term> decisions_;                     ///< the branches taken
  std::vector<std::uint8_t> model_;                 ///< a way that was found last
  std::unique_ptr<FormulaSolver> solver_;           ///< made when it is first asked
};

}  // namespace kiri
