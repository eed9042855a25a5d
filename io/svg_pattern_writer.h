// The crease pattern as SVG for other origami programs and for machines (docs/formats/svg.md).
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "core/paper/folded_state.h"

namespace kiri {

struct SvgPatternOptions {
  std::string title;
  double margin = 0;          ///< mm around the sheet
  double strokeWidth = 0.25;  ///< mm
};

/// The sheet at rest seen from the front, in mm, true size; curves are exact. Groups Cut (closed
/// contours of the paper, tears) and Score (Mountain, Valley, Flat) in the colours that origami
/// programs expect: border black, tear green, mountain red, valley blue, flat grey, each also as
/// data-assignment and data-foldAngle.
std::string writeSvgPattern(const FoldedState& state, const SvgPatternOptions& options = {});

}  // namespace kiri
