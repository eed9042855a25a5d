// SPDX-License-Identifier: MIT
#include "core/flatfold/formula_counter.h"

#include <algorithm>
#include <numeric>

namespace kiri {

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
      clauseSeen_(formula.clauses.size(), 0) {}

std::optional<FormulaCounter::Count> FormulaCounter::count(const Count& limit) {
  Unknowns all(search_.formula().unknowns);
  std::iota(all.begin(), all.end(), 0U);
  const Count result = countParts(partsOfOpen(all), &limit);
  if (meter_.isStopped()) return std::nullopt;
  return result;
}

std::optional<FormulaCounter::Count> FormulaCounter::count() {
  Unknowns all(search_.formula().unknowns);
  std::iota(all.begin(), all.end(), 0U);
  const Count result = countParts(partsOfOpen(all), nullptr);
  if (meter_.isStopped()) return std::nullopt;
  return result;
}

std::optional<std::vector<std::uint8_t>> FormulaCounter::way(Count& number) {
  Unknowns all(search_.formula().unknowns);
  std::iota(all.begin(), all.end(), 0U);
  const bool isThere = goTo(partsOfOpen(all), number);
  if (meter_.isStopped()) return std::nullopt;
  std::vector<std::uint8_t> values;
  if (isThere) values = search_.values();
  search_.takeBackTo(0);
  return values;
}

std::vector<FormulaCounter::Unknowns> FormulaCounter::partsOfOpen(const Unknowns& unknowns) {
  ++round_;
  std::vector<Unknowns> parts;
  for (const std::uint32_t u : unknowns) {
    if (!search_.isOpen(u) || unknownSeen_[u] == round_) continue;
    parts.emplace_back();
    reach(u, parts.back());
  }
  return parts;
}

void FormulaCounter::reach(std::uint32_t unknown, Unknowns& part) {
  unknownSeen_[unknown] = round_;
  part.push_back(unknown);
  std::size_t steps = 0;
  for (std::size_t next = 0; next < part.size(); ++next) {
    for (const Term t : {2 * part[next], 2 * part[next] + 1}) {
      const std::uint32_t* end = search_.index().end(t);
      for (const std::uint32_t* c = search_.index().begin(t); c != end; ++c) {
        ++steps;
        if (clauseSeen_[*c] == round_) continue;
        clauseSeen_[*c] = round_;
        const Clause& clause = search_.formula().clauses[*c];
        const bool isDone = std::any_of(clause.begin(), clause.end(), [&](Term other) {
          return other != kNoTerm && search_.isTrue(other);
        });
        if (isDone) continue;
        for (const Term other : clause) {
          if (other == kNoTerm) break;
          const std::uint32_t u = unknownOf(other);
          if (!search_.isOpen(u) || unknownSeen_[u] == round_) continue;
          unknownSeen_[u] = round_;
          part.push_back(u);
        }
      }
    }
  }
  std::sort(part.begin(), part.end());
  meter_.spend(8 * steps);
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

}  // namespace

/// The open unknowns and the clauses that have lost terms but are not yet true say all about a
/// part.
std::string FormulaCounter::keyOf(const Unknowns& part) {
  ++round_;
  std::string key;
  std::uint32_t last = 0;
  std::vector<std::uint32_t> shortened;
  for (const std::uint32_t u : part) {
    appendNumber(key, u - last);
    last = u;
    for (const Term t : {2 * u, 2 * u + 1}) {
      const std::uint32_t* end = search_.index().end(t);
      for (const std::uint32_t* c = search_.index().begin(t); c != end; ++c) {
        if (clauseSeen_[*c] == round_) continue;
        clauseSeen_[*c] = round_;
        const Clause& clause = search_.formula().clauses[*c];
        bool isTrue = false;
        bool isWhole = true;
        for (const Term other : clause) {
          if (other == kNoTerm) break;
          isTrue = isTrue || search_.isTrue(other);
          isWhole = isWhole && search_.isOpen(unknownOf(other));
        }
        if (!isTrue && !isWhole) shortened.push_back(*c);
      }
    }
  }
  appendNumber(key, 0);
  std::sort(shortened.begin(), shortened.end());
  last = 0;
  for (const std::uint32_t c : shortened) {
    appendNumber(key, c - last);
    last = c;
  }
  return key;
}

/// The unknown in most clauses, short ones first; of equal ones the first.
std::uint32_t FormulaCounter::branchOf(const Unknowns& part) const {
  std::uint32_t best = part.front();
  std::size_t bestScore = 0;
  for (const std::uint32_t u : part) {
    std::size_t score = 0;
    for (const Term t : {2 * u, 2 * u + 1}) {
      const std::uint32_t* end = search_.index().end(t);
      for (const std::uint32_t* c = search_.index().begin(t); c != end; ++c) {
        std::size_t opens = 0;
        bool isTrue = false;
        for (const Term other : search_.formula().clauses[*c]) {
          if (other == kNoTerm) break;
          opens += search_.isOpen(unknownOf(other)) ? 1U : 0U;
          isTrue = isTrue || search_.isTrue(other);
        }
        if (!isTrue) score += std::size_t{64} >> (2 * opens);
      }
    }
    if (score > bestScore) {
      bestScore = score;
      best = u;
    }
  }
  return best;
}

void FormulaCounter::spendSteps() { meter_.spend(search_.takeSteps()); }

FormulaCounter::Count FormulaCounter::countPart(const Unknowns& part, const Count* limit) {
  if (part.size() == 1) return 2;  // a clause of one term would have given it a value
  const std::string key = keyOf(part);
  if (const Count* known = cache_.find(key)) return *known;
  Count count = countSplit(part, limit);
  if (!meter_.isStopped() && (limit == nullptr || count < *limit)) cache_.keep(key, count);
  return count;
}

FormulaCounter::Count FormulaCounter::countSplit(const Unknowns& part, const Count* limit) {
  const std::uint32_t u = branchOf(part);
  const Term t = 2 * u + (first_[u] == FormulaSearch::kTrue ? 0 : 1);
  Count count = countBranch(part, t, limit);
  if (meter_.isStopped() || (limit != nullptr && count >= *limit)) return count;
  if (limit == nullptr) return count + countBranch(part, opposite(t), nullptr);
  const Count rest = *limit - count;
  return count + countBranch(part, opposite(t), &rest);
}

FormulaCounter::Count FormulaCounter::countBranch(const Unknowns& part, Term t,
                                                  const Count* limit) {
  const std::size_t mark = search_.mark();
  Count count = 0;
  if (search_.assume(t)) count = countParts(partsOfOpen(part), limit);
  search_.takeBackTo(mark);
  spendSteps();
  return count;
}

FormulaCounter::Count FormulaCounter::countParts(const std::vector<Unknowns>& parts,
                                                 const Count* limit) {
  // Small parts first: the sooner one is found that has no way.
  std::vector<const Unknowns*> order;
  for (const Unknowns& part : parts) order.push_back(&part);
  std::stable_sort(order.begin(), order.end(),
                   [](const Unknowns* a, const Unknowns* b) { return a->size() < b->size(); });
  Count product = 1;
  for (const Unknowns* part : order) {
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
bool FormulaCounter::goTo(const std::vector<Unknowns>& parts, Count& number) {
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
void FormulaCounter::goToPart(const Unknowns& part, Count number) {
  if (meter_.isStopped()) return;
  const std::uint32_t u = part.size() == 1 ? part.front() : branchOf(part);
  Term t = 2 * u + (first_[u] == FormulaSearch::kTrue ? 0 : 1);
  const Count limit = number + 1;
  const Count count = countBranch(part, t, &limit);
  if (meter_.isStopped()) return;
  if (number >= count) {
    number -= count;
    t = opposite(t);
  }
  KIRI_CHECK(search_.assume(t), "a way that was counted is there");
  spendSteps();
  goTo(partsOfOpen(part), number);
}

}  // namespace kiri
