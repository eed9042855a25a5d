// A state as text with every bit in it, to tell whether two states are identical.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "core/paper/folded_state.h"

namespace kiri::test {

/// Every field of the state, numbers in hexadecimal: equal texts mean equal states, bit by bit.
std::string textOf(const FoldedState& state);

/// The first line in which two texts differ, with both versions; empty when they are equal.
std::string firstDifference(const std::string& a, const std::string& b);

}  // namespace kiri::test
