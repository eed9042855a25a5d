// Crease patterns for tests of the command line.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace kiri::cli {

/// A sheet of 60 x 60 divided into three by two by creases of one letter: a map.
std::string mapAsFold(const std::string& letter);
/// A square of 100 with four creases that meet in its middle, one turned by some degrees: .cp, y
/// down. Three mountains and a valley; at 0 degrees it folds flat.
std::string starAsCp(double degrees);

}  // namespace kiri::cli
