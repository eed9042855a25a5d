// The units of length that FOLD files name.
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace kiri {

/// Our own key for a size of the unit that FOLD has no name for, in mm.
inline constexpr const char* kMmPerUnitKey = "kiri:mmPerUnit";

/// Millimetres of a frame_unit; none for names that FOLD does not know, and for "unit".
std::optional<double> mmOfFoldUnit(std::string_view name);

/// The frame_unit of that size; empty when FOLD has none.
std::string foldUnitOf(double mmPerUnit);

}  // namespace kiri
