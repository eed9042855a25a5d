// Crease patterns drawn as SVG (docs/formats/svg.md).
// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

#include "core/base/result.h"
#include "io/patterns/pattern_file.h"

namespace kiri {

/// The lines that the drawing shows, in user units of its root, y mirrored about 0 (so that nothing
/// is rounded): mountains and valleys stay what they are on the screen. Colour, opacity,
/// data-assignment and data-foldAngle say what a line is (meaningOf); curves become lines no
/// farther from them than 1/2000 of the drawing's diagonal. Filled shapes without a stroke are
/// faces: where no line is a border, they say where the paper is. `notes` say what was left out,
/// guessed or changed. Never throws. Errors: BadFile - no SVG, no lines, or too many.
Result<PatternFile> readSvgPattern(std::string_view text, std::string_view fileName);

}  // namespace kiri
