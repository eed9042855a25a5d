// The units of length that FOLD files name.
// SPDX-License-Identifier: MIT
#include "io/patterns/fold_units.h"

#include <array>
#include <utility>

namespace kiri {

namespace {

constexpr double kInch = 25.4;
constexpr double kPointsPerInch = 72;
constexpr std::array<std::pair<const char*, double>, 7> kFoldUnits = {
    {{"in", kInch},
     {"pt", kInch / kPointsPerInch},
     {"m", 1000},
     {"cm", 10},
     {"mm", 1},
     {"um", 0.001},
     {"nm", 0.000001}}};

}  // namespace

std::optional<double> mmOfFoldUnit(std::string_view name) {
  for (const auto& [known, size] : kFoldUnits) {
    if (name == known) return size;
  }
  return std::nullopt;
}

std::string foldUnitOf(double mmPerUnit) {
  for (const auto& [known, size] : kFoldUnits) {
    if (mmPerUnit == size) return known;
  }
  return "";
}

}  // namespace kiri
