// SPDX-License-Identifier: MIT
#include "core/flatfold/layer_states.h"

#include <algorithm>

#include "core/flatfold/formula_counter.h"
#include "core/flatfold/formula_solver.h"
#include "core/flatfold/free_parts.h"
#include "core/flatfold/open_orders.h"
#include "core/flatfold/order_conflict.h"

namespace kiri {

/// What is known of a problem, piece by piece more.
struct LayerStates::Found {
  OrderProblem problem;
  SearchLimits limits;
  OrderConflict conflict;
  bool exist = false;
  LayerValues first;
  std::vector<StateComponent> components;
  std::vector<FreePart> parts;  ///< by component
  /// By open pair: its component and its term there; kNoTerm when its order is fixed.
  std::vector<std::uint32_t> componentOf;
  std::vector<Term> termOf;

  void putIn(std::size_t index, const std::vector<std::uint8_t>& way, LayerValues& values) const {
    for (const std::uint32_t pair : components[index].pairs) {
      const Term t = termOf[pair];
      values[pair] = way[unknownOf(t)] == ((t & 1) ^ 1);
    }
  }
  void readParts(const OpenOrders& open, FreeParts found);
  Status searchOpen(const FacetRelation& relation, const KnownOrders& known, WorkMeter& meter);
  Status explain(const std::vector<FacetId>& suspects, WorkMeter& meter) {
    Result<OrderConflict> found = conflictOf(problem, suspects, meter);
    if (!found.isOk()) return found.error();
    conflict = std::move(*found);
    return std::monostate{};
  }
};

void LayerStates::Found::readParts(const OpenOrders& open, FreeParts found) {
  std::vector<std::uint32_t> partOf(open.formula.unknowns, kNoTerm);
  std::vector<std::uint32_t> placeOf(open.formula.unknowns, 0);
  for (std::uint32_t c = 0; c < found.parts.size(); ++c) {
    const std::vector<std::uint32_t>& origin = found.parts[c].origin;
    for (std::uint32_t i = 0; i < origin.size(); ++i) {
      partOf[origin[i]] = c;
      placeOf[origin[i]] = i;
    }
  }
  components.resize(found.parts.size());
  for (std::size_t i = 0; i < open.pairs.size(); ++i) {
    const std::uint32_t pair = open.pairs[i];
    const std::uint32_t unknown = unknownOf(open.terms[i]);
    const Term sign = open.terms[i] & 1;
    if (partOf[unknown] == kNoTerm) {
      first[pair] = found.fixed[unknown] == (sign ^ 1);
      continue;
    }
    componentOf[pair] = partOf[unknown];
    termOf[pair] = 2 * placeOf[unknown] + sign;
    components[partOf[unknown]].pairs.push_back(pair);
  }
  parts = std::move(found.parts);
  for (std::size_t c = 0; c < parts.size(); ++c) putIn(c, parts[c].first, first);
}

Status LayerStates::Found::searchOpen(const FacetRelation& relation, const KnownOrders& known,
                                      WorkMeter& meter) {
  Result<OpenOrders> open = openOrdersOf(problem, relation, known, meter);
  if (!open.isOk()) return open.error();
  std::vector<std::uint32_t> blocked = open->pairs;
  if (!open->isContradicted) {
    Result<FreeParts> found = freePartsOf(open->formula, false, meter);
    if (!found.isOk()) return found.error();
    exist = found->areThere;
    if (exist) {
      readParts(*open, std::move(*found));
      return std::monostate{};
    }
    std::vector<bool> isBlocked(open->formula.unknowns, false);
    for (const std::uint32_t u : found->blocked) isBlocked[u] = true;
    blocked.clear();
    for (std::size_t i = 0; i < open->pairs.size(); ++i) {
      if (isBlocked[unknownOf(open->terms[i])]) blocked.push_back(open->pairs[i]);
    }
  }
  return explain(known.reasonsOf(blocked), meter);
}

Result<LayerStates> LayerStates::find(OrderProblem problem, const SearchLimits& limits,
                                      const Progress& progress) {
  WorkMeter meter(progress, limits.memory);
  LayerStates states;
  states.found_ = std::make_shared<Found>();
  Found& found = *states.found_;
  found.problem = std::move(problem);
  found.limits = limits;
  const OrderProblem& p = found.problem;
  if (FacetRelation::memoryFor(p) + KnownOrders::memoryFor(p) > limits.memory) {
    meter.meetMemoryLimit();
    return meter.error("nothing was searched yet");
  }
  const FacetRelation relation(p);
  KnownOrders known(p, relation);
  meter.ask();
  if (!known.propagate(meter)) {
    if (meter.isStopped()) return meter.error("mountains and valleys were being followed");
    const Status status = found.explain(known.contradiction(), meter);
    if (!status.isOk()) return status.error();
    return states;
  }
  found.first.resize(p.pairs.size());
  found.componentOf.assign(p.pairs.size(), kNoTerm);
  found.termOf.assign(p.pairs.size(), kNoTerm);
  for (std::uint32_t pair = 0; pair < p.pairs.size(); ++pair) {
    found.first[pair] = known.isKnown(pair) && known.isTrue(Literal(pair, false));
  }
  const Status status = found.searchOpen(relation, known, meter);
  if (!status.isOk()) return status.error();
  return states;
}

const OrderProblem& LayerStates::problem() const { return found_->problem; }

bool LayerStates::exist() const { return found_->exist; }

const OrderConflict& LayerStates::conflict() const {
  KIRI_CHECK(!exist(), "a conflict is asked for only where no state exists");
  return found_->conflict;
}

std::size_t LayerStates::componentCount() const { return found_->components.size(); }

const StateComponent& LayerStates::component(std::size_t index) const {
  return found_->components[index];
}

Status LayerStates::count(const Progress& progress) {
  WorkMeter meter(progress, found_->limits.memory);
  const std::size_t all = found_->components.size();
  for (std::size_t c = 0; c < all; ++c) {
    StateComponent& component = found_->components[c];
    if (component.count) continue;
    meter.setDone(static_cast<double>(c) / static_cast<double>(all));
    CountCache cache(meter.memory());
    const FreePart& part = found_->parts[c];
    component.count = FormulaCounter(part.formula, part.first, cache, meter).count();
    if (!component.count) {
      return meter.error(std::to_string(c) + " of " + std::to_string(all) +
                         " components were counted");
    }
  }
  return std::monostate{};
}

StateCount LayerStates::total() const {
  if (!exist()) return 0;
  StateCount product = 1;
  for (const StateComponent& component : found_->components) {
    KIRI_CHECK(component.count.has_value(), "all components were counted");
    product *= *component.count;
  }
  return product;
}

Status LayerStates::choose(std::size_t index, const StateCount& number, LayerValues& values,
                           const Progress& progress) const {
  WorkMeter meter(progress, found_->limits.memory);
  CountCache cache(meter.memory());
  const FreePart& part = found_->parts[index];
  StateCount left = number;
  const auto way = FormulaCounter(part.formula, part.first, cache, meter).way(left);
  if (!way) return meter.error("the states before it were being counted");
  if (way->empty()) {
    return Error{ErrorCode::NotFound, "component " + std::to_string(index) + " has only " +
                                          left.str() + " states, numbered from 0; there is no " +
                                          number.str()};
  }
  found_->putIn(index, *way, values);
  return std::monostate{};
}

const LayerValues& LayerStates::first() const {
  KIRI_CHECK(exist(), "a state is asked for only where one exists");
  return found_->first;
}

Result<LayerValues> LayerStates::state(const StateCount& number, const Progress& progress) const {
  if (!exist()) return Error{ErrorCode::NotFound, "the pattern has no layer order at all"};
  WorkMeter meter(progress, found_->limits.memory);
  LayerValues values = found_->first;
  StateCount left = number;
  StateCount ways = 1;
  for (std::size_t c = componentCount(); c-- > 0 && !left.is_zero();) {
    const FreePart& part = found_->parts[c];
    CountCache cache(meter.memory());
    FormulaCounter counter(part.formula, part.first, cache, meter);
    std::optional<StateCount> count = found_->components[c].count;
    if (!count) count = counter.count(left + 1);
    if (!count) return meter.error("the states before it were being counted");
    StateCount digit = left % *count;
    left /= *count;
    ways *= *count;
    const auto way = counter.way(digit);
    if (!way) return meter.error("the states before it were being counted");
    found_->putIn(c, *way, values);
  }
  if (left.is_zero()) return values;
  return Error{ErrorCode::NotFound, "there are only " + ways.str() +
                                        " layer orders, numbered from 0; there is no " +
                                        number.str()};
}

Result<LayerValues> LayerStates::stateWith(const std::vector<Literal>& wanted,
                                           const LayerValues& near,
                                           const Progress& progress) const {
  const Error none{ErrorCode::NotFound, "no layer order has facets on each other in this way"};
  if (!exist()) return none;
  WorkMeter meter(progress, found_->limits.memory);
  std::vector<std::vector<Term>> terms(componentCount());
  LayerValues values = found_->first;
  for (const Literal l : wanted) {
    const Term t = found_->termOf[l.pair()];
    if (t != kNoTerm) {
      terms[found_->componentOf[l.pair()]].push_back(t ^ (l.isNegated() ? 1 : 0));
    } else if (values[l.pair()] == l.isNegated()) {
      return none;
    }
  }
  for (std::size_t c = 0; c < componentCount(); ++c) {
    const FreePart& part = found_->parts[c];
    std::vector<std::uint8_t> wish = part.first;
    for (const std::uint32_t pair : found_->components[c].pairs) {
      const Term t = found_->termOf[pair];
      wish[unknownOf(t)] = static_cast<std::uint8_t>((near[pair] ? 1U : 0U) ^ (t & 1));
    }
    FormulaSolver solver(part.formula, meter);
    const std::optional<bool> isSolved = solver.solve(terms[c], wish);
    if (!isSolved) return meter.error("a layer order with the wanted facets was being looked for");
    if (!*isSolved) return none;
    found_->putIn(c, solver.found(), values);
  }
  return values;
}

}  // namespace kiri
