// What layers and colours of a DXF file mean.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <optional>
#include <string_view>

#include "core/creases/crease_drawing.h"

namespace kiri {

/// A layer as we write it: ORIPA's and Oriedita's names and colours where they have one.
struct DxfLayer {
  const char* name = "";
  int colour = 7;  ///< AutoCAD colour index
};

/// By Assignment.
inline constexpr std::array<DxfLayer, 7> kDxfLayers = {{{"CutLine", 250},
                                                        {"MountainLine", 1},
                                                        {"ValleyLine", 5},
                                                        {"AuxiliaryLine", 4},
                                                        {"Unassigned", 6},
                                                        {"Slit", 3},
                                                        {"Join", 2}}};

constexpr const DxfLayer& dxfLayerOf(Assignment assignment) {
  return kDxfLayers[static_cast<std::size_t>(assignment)];
}

/// What a layer's name says; none when it says nothing of creases.
std::optional<Assignment> assignmentOfLayer(std::string_view name);

/// What a colour index says, as ORIPA takes it: reds mountain, blues valley, greens border, magenta
/// unassigned, black and white border, all else auxiliary.
Assignment assignmentOfColour(int colour);

/// The colour index that a true colour 0xRRGGBB is nearest to in meaning.
int indexOfTrueColour(unsigned colour);

}  // namespace kiri
