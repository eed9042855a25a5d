// Crease patterns as SVG for other origami programs (docs/formats/svg.md).
// SPDX-License-Identifier: MIT
#pragma once

#include "io/patterns/pattern_file.h"

namespace kiri {

/// The lines in groups by assignment, in the colours of kSvgLineLooks, with data-assignment and,
/// where the drawing gives an angle, data-foldAngle and the stroke-opacity that Origami Simulator
/// takes it from. User units are those of the drawing, x as it is and y with the other sign, so
/// that readSvgPattern gives back the same lines to the last bit (in the order of the groups); the
/// page has its true size where mmPerUnit is known. Losses: orders of faces, keys of others, faces
/// that do not follow from the lines.
WrittenPattern writeSvgDrawing(const PatternFile& file);

}  // namespace kiri
