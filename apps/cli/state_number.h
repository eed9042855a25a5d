// Numbers of folded states as people write them: decimal, of any length.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "core/flatfold/layer_states.h"

namespace kiri::cli {

/// True for decimal digits, not more than any count of states has.
bool isStateNumber(const std::string& text);
/// Leading zeros mean nothing. Requires isStateNumber.
StateCount stateNumber(const std::string& digits);

}  // namespace kiri::cli
