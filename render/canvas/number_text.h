// Numbers as text for files: the same everywhere, in any locale.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace kiri {

/// `value` rounded to `decimals` (at most 9) places, without zeros at the end; no exponent, no
/// minus zero.
std::string numberText(double value, int decimals);

}  // namespace kiri
