// The cells between the pieces of an arrangement.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "core/flatfold/arrangement.h"

namespace kiri {

/// Connected parts of the plane between pieces. Cell 0 is what lies outside; it has no corners.
struct PlanarCells {
  std::vector<std::vector<std::uint32_t>> corners;  ///< by cell, counter-clockwise; holes joined in
  std::vector<std::uint32_t> leftOf;                ///< by code of a piece run along
  std::uint32_t rightOf(std::uint32_t code) const { return leftOf[code ^ 1U]; }
};

/// None when the pieces do not form a planar map: Euler's formula fails.
std::optional<PlanarCells> cellsOf(const Arrangement& arrangement);

double areaOf(const Arrangement& arrangement, const std::vector<std::uint32_t>& corners);

}  // namespace kiri
