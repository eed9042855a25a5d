// SPDX-License-Identifier: MIT
#include "core/flatfold/formula_counter.h"

#include <algorithm>
#include <array>
#include <numeric>

namespace kiri {

namespace {

/// Unknowns of parts that are searched without asking a solver first.
constexpr std::size_t kSmall = 40;
/// Lower bounds that are remembered at once.
constexpr std::size_t kBoundsKept = 20000;

}  // namespace

const CountCache::Count* CountCache::find(const std::string& key) {
  const auto young = young_.find(key);
  if (young != young_.end()) return &young->second;
  const auto old = old_.find(key);
  if (old == old_.end()) return nullptr;
  const Count count = old->second;
  keep(key, count);
  return &young_.find(key)->second;
}

void CountCache::keep(std::string key, const Count& count) {
  constexpr std::size_t kNode = 100;  // node, string and number besides their digits
  const std::size_t bytes = kNode + key.size() + (count.is_zero() ? 0 : msb(count) / 8);
  if (used_ + bytes > memory_ / 2) {
    old_ = std::move(young_);
    young_.clear();
    used_ = 0;
  }
  used_ += bytes;
  young_.insert_or_assign(std::move(key), count);
}

FormulaCounter::FormulaCounter(const OrderFormula& formula, const std::vector<std::uint8_t>& first,
                               CountCache& cache, WorkMeter& meter)
    : search_(formula),
      first_(first),
      cache_(cache),
      meter_(meter),
      unknownSeen_(formula.unknowns, 0),
      clauseSeen_(formula.clauses.size(), 0),
      weights_(formula.unknowns, 0),
      model_(first) {}

std::optional<FormulaCounter::Count> FormulaCounter::count(const Count& limit) {
  const Count result = countParts(partsOfAll(), &limit);
  if (meter_.isStopped()) return std::nullopt;
  return result;
}

std::optional<FormulaCounter::Count> FormulaCounter::count() {
  const Count result = countParts(partsOfAll(), nullptr);
  if (meter_.isStopped()) return std::nullopt;
  return result;
}

std::optional<std::vector<std::uint8_t>> FormulaCounter::way(Count& number) {
  const bool isThere = goTo(partsOfAll(), number);
  std::vector<std::uint8_t> values;
  if (isThere) values = search_.values();
  search_.takeBackTo(0);
  decisions_.clear();
  if (meter_.isStopped()) return std::nullopt;
  return values;
}

std::vector<FormulaCounter::Part> FormulaCounter::partsOfAll() {
  std::vector<std::uint32_t> all(search_.formula().unknowns);
  std::iota(all.begin(), all.end(), 0U);
  return partsOfOpen(all);
}

std::vector<FormulaCounter::Part> FormulaCounter::partsOfOpen(
    const std::vector<std::uint32_t>& unknowns) {
  ++round_;
  std::vector<Part> parts;
  for (const std::uint32_t u : unknowns) {
    if (!search_.isOpen(u) || unknownSeen_[u] == round_) continue;
    parts.emplace_back();
    reach(u, parts.back());
  }
  return parts;
}

void FormulaCounter::reach(std::uint32_t unknown, Part& part) {
  unknownSeen_[unknown] = round_;
  weights_[unknown] = 0;
  part.unknowns.push_back(unknown);
  std::size_t steps = 0;
  for (std::size_t next = 0; next < part.unknowns.size(); ++next) {
    const Term t = 2 * part.unknowns[next];
    // The clauses of a term and those of its opposite stand one after the other.
    const std::uint32_t* end = search_.index().end(t + 1);
    for (const std::uint32_t* c = search_.index().begin(t); c != end; ++c) {
      ++steps;
      if (clauseSeen_[*c] == round_) continue;
      clauseSeen_[*c] = round_;
      weigh(search_.formula().clauses[*c], *c, part);
    }
  }
  std::sort(part.unknowns.begin(), part.unknowns.end());
  std::sort(part.shortened.begin(), part.shortened.end());
  // The unknown in most clauses, short ones first; of equal ones the first.
  part.branch = part.unknowns.front();
  for (const std::uint32_t u : part.unknowns) {
    if (weights_[u] > weights_[part.branch]) part.branch = u;
  }
  meter_.spend(8 * steps);
}

/// Adds what a clause ties together, unless it is true.
void FormulaCounter::weigh(const Clause& clause, std::uint32_t index, Part& part) {
  std::array<std::uint32_t, 4> open{};
  std::size_t opens = 0;
  std::size_t size = 0;
  for (const Term t : clause) {
    if (t == kNoTerm) break;
    ++size;
    if (search_.isOpen(unknownOf(t))) {
      open[opens++] = unknownOf(t);
    } else if (search_.isTrue(t)) {
      return;
    }
  }
  if (opens < size) part.shortened.push_back(index);
  for (std::size_t i = 0; i < opens; ++i) {
    const std::uint32_t u = open[i];
    if (unknownSeen_[u] != round_) {
      unknownSeen_[u] = round_;
      weights_[u] = 0;
      part.unknowns.push_back(u);
    }
    weights_[u] += 64U >> (2 * opens);
  }
}

namespace {

/// Ascending numbers, as few bytes as their distances want.
void appendNumber(std::string& key, std::uint32_t number) {
  while (number >= 0x80) {
    key.push_back(static_cast<char>(number | 0x80));
    number >>= 7;
  }
  key.push_back(static_cast<char>(number));
}

void appendAscending(std::string& key, const std::vector<std::uint32_t>& numbers) {
  appendNumber(key, static_cast<std::uint32_t>(numbers.size()));
  std::uint32_t last = 0;
  for (const std::uint32_t number : numbers) {
    appendNumber(key, number - last);
    last = number;
  }
}

}  // namespace

FormulaCounter::Count FormulaCounter::countPart(const Part& part, const Count* limit) {
  if (part.unknowns.size() == 1) return 2;  // a clause of one term would have given it a value
  // The open unknowns and the clauses that have lost terms but are not yet true say all.
  std::string key;
  appendAscending(key, part.unknowns);
  appendAscending(key, part.shortened);
  if (const Count* known = cache_.find(key)) return *known;
  if (limit != nullptr) {
    const auto known = atLeast_.find(key);
    if (known != atLeast_.end() && known->second >= *limit) return known->second;
  }
  Count count = countSplit(part, limit);
  if (meter_.isStopped()) return count;
  if (limit == nullptr || count < *limit) {
    cache_.keep(std::move(key), count);
  } else {
    if (atLeast_.size() == kBoundsKept) atLeast_.clear();
    atLeast_.insert_or_assign(std::move(key), count);
  }
  return count;
}

/// The value that the first way has, where that is still possible.
Term FormulaCounter::firstBranch(const Part& part) const {
  return 2 * part.branch + (first_[part.branch] == FormulaSearch::kTrue ? 0 : 1);
}

FormulaCounter::Count FormulaCounter::countSplit(const Part& part, const Count* limit) {
  const Term t = firstBranch(part);
  Count count = countBranch(part, t, limit);
  if (meter_.isStopped() || (limit != nullptr && count >= *limit)) return count;
  if (limit == nullptr) return count + countBranch(part, opposite(t), nullptr);
  const Count rest = *limit - count;
  return count + countBranch(part, opposite(t), &rest);
}

FormulaCounter::Count FormulaCounter::countBranch(const Part& part, Term t, const Count* limit) {
  const std::size_t mark = search_.mark();
  Count count = 0;
  decisions_.push_back(t);
  // Small parts are sooner searched than asked about. What is above a branch has a way (else it
  // would not have been entered), so have all other parts: a branch without one is this part's.
  const bool isAsked = limit != nullptr && part.unknowns.size() > kSmall;
  if (search_.assume(t) && (!isAsked || canGoOn())) {
    count = countParts(partsOfOpen(part.unknowns), limit);
  }
  decisions_.pop_back();
  search_.takeBackTo(mark);
  meter_.spend(search_.takeSteps());
  return count;
}

/// Whether any way follows the branches taken.
bool FormulaCounter::canGoOn() {
  const bool isModel = std::all_of(decisions_.begin(), decisions_.end(),
                                   [&](Term t) { return model_[unknownOf(t)] == ((t & 1) ^ 1); });
  if (isModel) return true;
  if (!solver_) solver_ = std::make_unique<FormulaSolver>(search_.formula(), meter_);
  if (!solver_->solve(decisions_, first_).value_or(false)) return false;
  model_ = solver_->found();
  return true;
}

FormulaCounter::Count FormulaCounter::countParts(const std::vector<Part>& parts,
                                                 const Count* limit) {
  // Small parts first: the sooner one is found that has no way.
  std::vector<const Part*> order;
  for (const Part& part : parts) order.push_back(&part);
  std::stable_sort(order.begin(), order.end(), [](const Part* a, const Part* b) {
    return a->unknowns.size() < b->unknowns.size();
  });
  Count product = 1;
  for (const Part* part : order) {
    if (limit == nullptr) {
      product *= countPart(*part, nullptr);
    } else {
      const Count rest = product < *limit ? Count((*limit + product - 1) / product) : Count(1);
      product *= countPart(*part, &rest);
    }
    if (product.is_zero() || meter_.isStopped()) break;
  }
  return product;
}

/// Gives the parts the values of way `number`, the first part changing slowest.
bool FormulaCounter::goTo(const std::vector<Part>& parts, Count& number) {
  std::vector<Count> digits(parts.size());
  Count ways = 1;
  Count left = number;
  for (std::size_t i = parts.size(); i-- > 0;) {
    const Count limit = left + 1;
    const Count count = countPart(parts[i], &limit);
    if (meter_.isStopped()) return false;
    ways *= count;
    if (count.is_zero()) break;
    digits[i] = left % count;
    left /= count;
  }
  if (!left.is_zero() || ways.is_zero()) {
    number = ways;
    return false;
  }
  for (std::size_t i = 0; i < parts.size(); ++i) goToPart(parts[i], digits[i]);
  return !meter_.isStopped();
}

/// Requires that the part has way `number`.
void FormulaCounter::goToPart(const Part& part, Count number) {
  if (meter_.isStopped()) return;
  Term t = firstBranch(part);
  const Count limit = number + 1;
  const Count count = countBranch(part, t, &limit);
  if (meter_.isStopped()) return;
  if (number >= count) {
    number -= count;
    t = opposite(t);
  }
  KIRI_CHECK(search_.assume(t), "a way that was counted is there");
  decisions_.push_back(t);
  meter_.spend(search_.takeSteps());
  goTo(partsOfOpen(part.unknowns), number);
}

}  // namespace kiri
