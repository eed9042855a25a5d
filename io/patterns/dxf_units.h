// The units of length that DXF files name ($INSUNITS).
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <optional>
#include <utility>

namespace kiri {

inline constexpr int kDxfUnitless = 0;

inline constexpr std::array<std::pair<int, double>, 10> kDxfUnits = {{{1, 25.4},
                                                                      {2, 304.8},
                                                                      {4, 1},
                                                                      {5, 10},
                                                                      {6, 1000},
                                                                      {9, 0.0254},
                                                                      {10, 914.4},
                                                                      {12, 0.000001},
                                                                      {13, 0.001},
                                                                      {14, 100}}};

/// Millimetres of a unit; none for those without a size and those that no paper is measured in.
constexpr std::optional<double> mmOfDxfUnit(double code) {
  for (const auto& [known, size] : kDxfUnits) {
    if (code == known) return size;
  }
  return std::nullopt;
}

/// The unit of that size; kDxfUnitless when there is none.
constexpr int dxfUnitOf(double mmPerUnit) {
  for (const auto& [known, size] : kDxfUnits) {
    if (mmPerUnit == size) return known;
  }
  return kDxfUnitless;
}

}  // namespace kiri
