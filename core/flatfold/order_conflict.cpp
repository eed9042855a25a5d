// SPDX-License-Identifier: MIT
#include "core/flatfold/order_conflict.h"

#include <algorithm>

#include "core/flatfold/free_parts.h"
#include "core/flatfold/open_orders.h"

namespace kiri {

namespace {

constexpr std::uint32_t kGone = 0xFFFFFFFF;

/// Old literals in the numbers of a smaller problem.
class Renumbering {
 public:
  Renumbering(const OrderProblem& problem, const std::vector<FacetId>& facets)
      : facets_(problem.facetCount, kGone), pairs_(problem.pairs.size(), kGone) {
    for (std::size_t i = 0; i < facets.size(); ++i) {
      facets_[facets[i].index] = static_cast<std::uint32_t>(i);
    }
  }
  std::uint32_t facet(FacetId f) const { return facets_[f.index]; }
  void addPair(std::size_t old, std::size_t now) { pairs_[old] = static_cast<std::uint32_t>(now); }
  bool has(Literal l) const { return pairs_[l.pair()] != kGone; }
  Literal operator()(Literal l) const { return {pairs_[l.pair()], l.isNegated()}; }

 private:
  std::vector<std::uint32_t> facets_;
  std::vector<std::uint32_t> pairs_;
};

void restrictStacks(const FacetSets& stacks, const Renumbering& now, OrderProblem& result) {
  std::vector<std::vector<FacetId>> kept;
  for (std::size_t s = 0; s < stacks.size(); ++s) {
    std::vector<FacetId> stack;
    for (const FacetId* f = stacks.begin(s); f != stacks.end(s); ++f) {
      if (now.facet(*f) != kGone) stack.push_back(FacetId(now.facet(*f)));
    }
    if (stack.size() > 1) kept.push_back(std::move(stack));
  }
  std::sort(kept.begin(), kept.end());
  kept.erase(std::unique(kept.begin(), kept.end()), kept.end());
  for (const std::vector<FacetId>& stack : kept) result.stacks.add(stack);
}

}  // namespace

OrderProblem restrictedTo(const OrderProblem& problem, const std::vector<FacetId>& facets) {
  Renumbering now(problem, facets);
  OrderProblem result;
  result.facetCount = facets.size();
  for (std::size_t p = 0; p < problem.pairs.size(); ++p) {
    const std::uint32_t a = now.facet(problem.pairs[p].a);
    const std::uint32_t b = now.facet(problem.pairs[p].b);
    if (a == kGone || b == kGone) continue;
    now.addPair(p, result.pairs.size());
    result.pairs.push_back({FacetId(a), FacetId(b)});
  }
  restrictStacks(problem.stacks, now, result);
  for (const SameOrder& same : problem.same) {
    if (now.has(same.first) && now.has(same.second)) {
      result.same.push_back({now(same.first), now(same.second)});
    }
  }
  for (const Interleaving& i : problem.interleavings) {
    if (now.has(i.ac) && now.has(i.bc) && now.has(i.ad) && now.has(i.bd)) {
      result.interleavings.push_back({now(i.ac), now(i.bc), now(i.ad), now(i.bd)});
    }
  }
  for (const Literal l : problem.known) {
    if (now.has(l)) result.known.push_back(now(l));
  }
  return result;
}

std::optional<bool> canBeOrdered(const OrderProblem& problem, WorkMeter& meter) {
  const FacetRelation relation(problem);
  KnownOrders known(problem, relation);
  meter.spend(problem.pairs.size() * 20);
  if (!known.propagate(meter)) {
    if (meter.isStopped()) return std::nullopt;
    return false;
  }
  const Result<OpenOrders> open = openOrdersOf(problem, relation, known, meter);
  if (!open.isOk()) return std::nullopt;
  if (open->isContradicted) return false;
  const Result<FreeParts> parts = freePartsOf(open->formula, true, meter);
  if (!parts.isOk()) return std::nullopt;
  return parts->areThere;
}

namespace {

/// Leaves out facets in ever smaller bunches as long as no order comes into being.
class ConflictReducer {
 public:
  ConflictReducer(OrderProblem problem, std::vector<FacetId> names, WorkMeter& meter)
      : problem_(std::move(problem)), names_(std::move(names)), meter_(meter) {}

  /// The names of the facets that are left.
  std::vector<FacetId> reduce() {
    for (std::size_t bunch = (names_.size() + 1) / 2; bunch > 0;
         bunch = bunch == 1 ? 0 : (bunch + 1) / 2) {
      for (std::size_t at = 0; at < names_.size();) {
        if (tries_++ > kTries || meter_.isStopped()) return names_;
        if (!leaveOut(at, bunch)) at += bunch;
      }
    }
    return names_;
  }

 private:
  bool leaveOut(std::size_t at, std::size_t bunch) {
    std::vector<FacetId> kept;
    std::vector<FacetId> keptNames;
    for (std::size_t i = 0; i < names_.size(); ++i) {
      if (i >= at && i < at + bunch) continue;
      kept.push_back(FacetId(i));
      keptNames.push_back(names_[i]);
    }
    OrderProblem smaller = restrictedTo(problem_, kept);
    const std::optional<bool> isOrdered = canBeOrdered(smaller, meter_);
    if (!isOrdered || *isOrdered) return false;
    problem_ = std::move(smaller);
    names_ = std::move(keptNames);
    return true;
  }

  static constexpr int kTries = 2000;
  OrderProblem problem_;
  std::vector<FacetId> names_;
  WorkMeter& meter_;
  int tries_ = 0;
};

}  // namespace

Result<OrderConflict> conflictOf(const OrderProblem& problem, std::vector<FacetId> suspects,
                                 WorkMeter& meter) {
  OrderProblem part = restrictedTo(problem, suspects);
  if (canBeOrdered(part, meter).value_or(true)) {
    suspects.clear();
    for (std::size_t f = 0; f < problem.facetCount; ++f) suspects.push_back(FacetId(f));
    part = problem;
  }
  OrderConflict conflict;
  conflict.facets = ConflictReducer(std::move(part), std::move(suspects), meter).reduce();
  if (meter.isStopped()) return meter.error("it was found that no layer order exists");
  conflict.message = "the " + std::to_string(conflict.facets.size()) +
                     " facets marked cannot lie on each other in any order; change the direction "
                     "or the place of a crease between them";
  return conflict;
}

}  // namespace kiri
