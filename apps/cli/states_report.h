// What kiri states says: for people and for programs.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "apps/cli/states_search.h"

namespace kiri::cli {

/// One line or more for people, each ended.
std::string statesText(const PatternInput& input, const StatesAnswer& answer);

/// One JSON object. `seconds`: since the command began.
std::string statesJson(const PatternInput& input, const StatesAnswer& answer, double seconds);

/// Which choice every component has in state `number` of all: the first changes slowest. Requires
/// counted states, more of them than `number`.
std::vector<StateCount> choicesOf(const LayerStates& states, StateCount number);

}  // namespace kiri::cli
