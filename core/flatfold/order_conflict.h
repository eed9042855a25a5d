// Why no layer order exists: few facets that cannot be ordered.
// SPDX-License-Identifier: MIT
#pragma once

#include "core/flatfold/layer_states.h"
#include "core/flatfold/work_meter.h"

namespace kiri {

/// The problem as it would be without the other facets. `facets` are sorted; facet i of the result
/// is facets[i].
OrderProblem restrictedTo(const OrderProblem& problem, const std::vector<FacetId>& facets);

/// Whether any order exists. None: the meter stopped.
std::optional<bool> canBeOrdered(const OrderProblem& problem, WorkMeter& meter);

/// A set of facets without an order of which, but for a bounded effort, none can be left out.
/// `suspects` are where to look first; they are all used when they can be ordered.
/// Requires a problem without a state. Errors: those of the meter.
Result<OrderConflict> conflictOf(const OrderProblem& problem, std::vector<FacetId> suspects,
                                 WorkMeter& meter);

}  // namespace kiri
