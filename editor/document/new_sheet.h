// The sheets that a new model can start from.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/model/model.h"
#include "editor/base/phrase.h"

namespace kiri {

/// A sheet of the start page.
struct SheetPreset {
  std::string id;  ///< "square", "a4", "disc", "leaf"
  Phrase name;
  Phrase size;  ///< "150 x 150 mm"
  Model model;  ///< without steps
};

/// In the order in which they are shown, the one to begin with first.
std::vector<SheetPreset> sheetPresets();

/// Limits of the sides of a sheet that is asked for in the window, mm.
inline constexpr double kSmallestSheet = 5;
inline constexpr double kLargestSheet = 10000;

/// A model without steps on a rectangle of any size. Errors: BadValue - a side beyond the limits.
Result<Model> rectangleModel(double width, double height);

}  // namespace kiri
