// What propagation leaves open, in few unknowns: orders that go together are one.
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <unordered_set>
#include <vector>

#include "core/flatfold/known_orders.h"
#include "core/flatfold/order_formula.h"

namespace kiri {

/// The open orders of a problem as a formula. Classes of orders that are tied to each other, equal
/// or opposite, are its unknowns, numbered by their first pair; ties that a circle makes of two
/// others count too. Circles that cannot close whatever follows are left out.
struct OpenOrders {
  OrderFormula formula;
  std::vector<std::uint32_t> pairs;  ///< the open ones, ascending
  std::vector<Term> terms;           ///< by place in `pairs`: what the pair is in the formula
  bool isContradicted = false;       ///< two orders are tied to be equal and opposite
};

/// Errors: those of the meter.
Result<OpenOrders> openOrdersOf(const OrderProblem& problem, const FacetRelation& relation,
                                const KnownOrders& known, WorkMeter& meter);

}  // namespace kiri
