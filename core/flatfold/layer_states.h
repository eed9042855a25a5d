// All layer orders that an OrderProblem allows: counted, listed, one at a time.
// SPDX-License-Identifier: MIT
#pragma once

#include <boost/multiprecision/cpp_int.hpp>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/flatfold/order_problem.h"

namespace kiri {

using StateCount = boost::multiprecision::cpp_int;

struct SearchLimits {
  std::size_t memory = std::size_t{2} << 30;  ///< bytes, about
};

/// Unknowns that hang together: the orders of one component may be chosen whatever the others are.
struct StateComponent {
  std::vector<std::uint32_t> pairs;  ///< of the problem; all that take both values somewhere in it
  std::optional<StateCount> count;   ///< once it was counted
};

/// Truth of every pair of the problem.
using LayerValues = std::vector<bool>;

/// Why there is no state: facets whose orders contradict each other, few of them.
struct OrderConflict {
  std::vector<FacetId> facets;  ///< sorted
  std::string message;
};

/// The states of a problem. What follows from mountains, valleys and geometry alone is found at
/// once (propagation); the rest falls into components, each searched when it is asked for.
class LayerStates {
 public:
  /// Propagates and finds one order of every component. Errors: Cancelled; BadValue - the memory
  /// limit was met, with what was done till then.
  static Result<LayerStates> find(OrderProblem problem, const SearchLimits& limits = {},
                                  const Progress& progress = {});

  const OrderProblem& problem() const;
  bool exist() const;
  /// Where none exist.
  const OrderConflict& conflict() const;

  /// In an order that depends on the problem only; those with one choice are no components.
  std::size_t componentCount() const;
  const StateComponent& component(std::size_t index) const;

  /// Counts the states of every component, exactly. Errors: Cancelled, BadValue as above; what was
  /// counted till then is kept.
  Status count(const Progress& progress = {});
  /// The product over the components; 0 where no state exists. Requires count() to have succeeded.
  StateCount total() const;

  /// State `number` of component `index`, from 0; sets its pairs in `values`. Any component may be
  /// walked without counting the others. Errors: NotFound - it has not that many, with how many;
  /// Cancelled.
  Status choose(std::size_t index, const StateCount& number, LayerValues& values,
                const Progress& progress = {}) const;
  /// The state that was found first: state 0 of every component. Requires exist().
  const LayerValues& first() const;
  /// State `number` of all, from 0; the first component changes slowest. Errors as choose.
  Result<LayerValues> state(const StateCount& number, const Progress& progress = {}) const;
  /// A state in which `values` of the given pairs hold, as near to `near` as was found; for picking
  /// what lies on top. Errors: NotFound - there is none.
  Result<LayerValues> stateWith(const std::vector<Literal>& wanted, const LayerValues& near,
                                const Progress& progress = {}) const;

 private:
  struct Found;
  std::shared_ptr<Found> found_;
};

/// The first rule that an order breaks, as a sentence; none when it is a state.
std::optional<std::string> brokenRule(const OrderProblem& problem, const LayerValues& values);

}  // namespace kiri
