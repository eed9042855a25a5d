// Numbers and places as they stand in sentences.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "core/base/vec.h"

namespace kiri {

/// A number with at most six significant digits: "52.1".
std::string text(double number);
/// A place: "(52.1, 80)". The sentence adds the unit. What is 0 but for rounding is told as 0.
std::string text(Vec2 point);

}  // namespace kiri
