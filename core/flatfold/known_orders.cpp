// SPDX-License-Identifier: MIT
#include "core/flatfold/known_orders.h"

#include <array>
#include <bit>

namespace kiri {

KnownOrders::KnownOrders(const OrderProblem& problem, const FacetRelation& relation)
    : problem_(problem),
      relation_(relation),
      values_(problem.pairs.size(), kOpen),
      reasons_(problem.pairs.size()),
      above_(problem.facetCount * relation.words()),
      below_(problem.facetCount * relation.words()) {
  indexTies();
}

namespace {

std::array<Literal, 4> membersOf(const Interleaving& i) { return {i.ac, i.bc, i.ad, i.bd}; }

}  // namespace

void KnownOrders::indexTies() {
  tieStarts_.assign(problem_.pairs.size() + 1, 0);
  for (const SameOrder& same : problem_.same) {
    ++tieStarts_[same.first.pair() + 1];
    ++tieStarts_[same.second.pair() + 1];
  }
  for (const Interleaving& i : problem_.interleavings) {
    for (const Literal l : membersOf(i)) ++tieStarts_[l.pair() + 1];
  }
  for (std::size_t p = 0; p < problem_.pairs.size(); ++p) tieStarts_[p + 1] += tieStarts_[p];
  ties_.resize(tieStarts_.back());
  std::vector<std::uint32_t> next(tieStarts_.begin(), tieStarts_.end() - 1);
  std::uint32_t number = 0;
  for (const SameOrder& same : problem_.same) {
    ties_[next[same.first.pair()]++] = number;
    ties_[next[same.second.pair()]++] = number;
    ++number;
  }
  for (const Interleaving& i : problem_.interleavings) {
    for (const Literal l : membersOf(i)) ties_[next[l.pair()]++] = number;
    ++number;
  }
}

bool KnownOrders::propagate(WorkMeter& meter) {
  for (const Literal l : problem_.known) {
    if (!set(l, {})) return false;
  }
  // Ties of a pair with itself speak without anything being known.
  for (std::uint32_t i = 0; i < problem_.same.size(); ++i) {
    const SameOrder& same = problem_.same[i];
    if (same.first == !same.second) {
      isContradicted_ = true;
      contradictedPair_ = same.first.pair();
      contradictedBy_ = {ReasonKind::Same, i};
      return false;
    }
  }
  while (followed_ < queue_.size()) {
    if (!followPair(queue_[followed_++])) return false;
    if (!meter.spend(4 * relation_.words() + 50)) return false;
  }
  return true;
}

bool KnownOrders::set(Literal literal, Reason reason) {
  const std::uint32_t pair = literal.pair();
  const std::uint8_t value = literal.isNegated() ? kFalse : kTrue;
  if (values_[pair] == value) return true;
  if (values_[pair] != kOpen) {
    isContradicted_ = true;
    contradictedPair_ = pair;
    contradictedBy_ = reason;
    return false;
  }
  values_[pair] = value;
  reasons_[pair] = reason;
  std::size_t upper = problem_.pairs[pair].a.index;
  std::size_t lower = problem_.pairs[pair].b.index;
  if (literal.isNegated()) std::swap(upper, lower);
  above_[lower * relation_.words() + (upper >> 6)] |= std::uint64_t{1} << (upper & 63);
  below_[upper * relation_.words() + (lower >> 6)] |= std::uint64_t{1} << (lower & 63);
  queue_.push_back(pair);
  return true;
}

bool KnownOrders::followPair(std::uint32_t pair) {
  for (std::uint32_t t = tieStarts_[pair]; t < tieStarts_[pair + 1]; ++t) {
    const std::uint32_t number = ties_[t];
    const std::uint32_t sames = static_cast<std::uint32_t>(problem_.same.size());
    if (!(number < sames ? followSame(number) : followInterleaving(number - sames))) return false;
  }
  const FacetPair& facets = problem_.pairs[pair];
  return values_[pair] == kTrue ? followCircles(facets.a.index, facets.b.index)
                                : followCircles(facets.b.index, facets.a.index);
}

bool KnownOrders::followSame(std::uint32_t index) {
  const SameOrder& same = problem_.same[index];
  const Reason reason{ReasonKind::Same, index};
  if (isKnown(same.first.pair())) {
    return set(isTrue(same.first) ? same.second : !same.second, reason);
  }
  return set(isTrue(same.second) ? same.first : !same.first, reason);
}

bool KnownOrders::followInterleaving(std::uint32_t index) {
  bool isOdd = false;
  Literal open;
  int opens = 0;
  Literal last;
  for (const Literal l : membersOf(problem_.interleavings[index])) {
    if (isKnown(l.pair())) {
      isOdd ^= isTrue(l);
      last = l;
    } else {
      open = l;
      ++opens;
    }
  }
  if (opens > 1) return true;
  const Reason reason{ReasonKind::Interleaving, index};
  if (opens == 1) return set(isOdd ? open : !open, reason);
  return !isOdd || set(isTrue(last) ? !last : last, reason);
}

bool KnownOrders::followCircles(std::uint32_t upper, std::uint32_t lower) {
  const std::size_t words = relation_.words();
  const std::uint64_t* overUpper = above_.data() + upper * words;
  const std::uint64_t* overLower = above_.data() + lower * words;
  const std::uint64_t* underUpper = below_.data() + upper * words;
  const std::uint64_t* underLower = below_.data() + lower * words;
  const std::uint64_t* nearUpper = relation_.overlapping(upper);
  const std::uint64_t* nearLower = relation_.overlapping(lower);
  for (std::size_t w = 0; w < words; ++w) {
    // Above the upper one, so above the lower one; below the lower one, so below the upper one.
    std::uint64_t higher = overUpper[w] & nearLower[w] & ~overLower[w];
    std::uint64_t deeper = underLower[w] & nearUpper[w] & ~underUpper[w];
    for (; higher != 0; higher &= higher - 1) {
      const std::uint32_t z =
          static_cast<std::uint32_t>(w * 64) + static_cast<std::uint32_t>(std::countr_zero(higher));
      if (relation_.haveCommonStack(upper, lower, z) &&
          !set(relation_.above(z, lower), {ReasonKind::Circle, upper})) {
        return false;
      }
    }
    for (; deeper != 0; deeper &= deeper - 1) {
      const std::uint32_t z =
          static_cast<std::uint32_t>(w * 64) + static_cast<std::uint32_t>(std::countr_zero(deeper));
      if (relation_.haveCommonStack(upper, lower, z) &&
          !set(relation_.above(upper, z), {ReasonKind::Circle, lower})) {
        return false;
      }
    }
  }
  return true;
}

void KnownOrders::addSources(std::uint32_t pair, Reason reason,
                             std::vector<std::uint32_t>& sources) const {
  switch (reason.kind) {
    case ReasonKind::Given:
      return;
    case ReasonKind::Same:
      sources.push_back(problem_.same[reason.index].first.pair());
      sources.push_back(problem_.same[reason.index].second.pair());
      return;
    case ReasonKind::Interleaving:
      for (const Literal l : membersOf(problem_.interleavings[reason.index])) {
        sources.push_back(l.pair());
      }
      return;
    case ReasonKind::Circle:
      sources.push_back(relation_.above(reason.index, problem_.pairs[pair].a.index).pair());
      sources.push_back(relation_.above(reason.index, problem_.pairs[pair].b.index).pair());
      return;
  }
}

std::vector<FacetId> KnownOrders::contradiction() const {
  std::vector<std::uint32_t> pairs{contradictedPair_};
  addSources(contradictedPair_, contradictedBy_, pairs);
  return reasonsOf(pairs);
}

std::vector<FacetId> KnownOrders::reasonsOf(const std::vector<std::uint32_t>& pairs) const {
  std::vector<bool> isSeen(problem_.pairs.size(), false);
  std::vector<bool> isPart(problem_.facetCount, false);
  std::vector<std::uint32_t> open = pairs;
  std::vector<std::uint32_t> sources;
  while (!open.empty()) {
    const std::uint32_t pair = open.back();
    open.pop_back();
    if (isSeen[pair]) continue;
    isSeen[pair] = true;
    isPart[problem_.pairs[pair].a.index] = true;
    isPart[problem_.pairs[pair].b.index] = true;
    if (!isKnown(pair)) continue;
    sources.clear();
    addSources(pair, reasons_[pair], sources);
    open.insert(open.end(), sources.begin(), sources.end());
  }
  std::vector<FacetId> facets;
  for (std::size_t f = 0; f < isPart.size(); ++f) {
    if (isPart[f]) facets.push_back(FacetId(f));
  }
  return facets;
}

std::size_t KnownOrders::memoryFor(const OrderProblem& problem) {
  const std::size_t words = (problem.facetCount + 63) / 64;
  return problem.facetCount * words * 16 + problem.pairs.size() * 20 + problem.same.size() * 8 +
         problem.interleavings.size() * 16;
}

}  // namespace kiri
