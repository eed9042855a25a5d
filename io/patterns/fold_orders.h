// Which face lies above which, from the faceOrders of a FOLD file.
// SPDX-License-Identifier: MIT
#pragma once

#include "io/patterns/fold_frames.h"
#include "io/patterns/fold_graph.h"
#include "io/patterns/pattern_file.h"

namespace kiri {

/// Puts the face orders of the pattern's frame, or else of the first frame with the same faces,
/// into file.drawing.orders, faces named by points inside them. Requires file.drawing.faces as made
/// from the frame's faces (one for each, or none).
void addOrders(const JsonValue& document, const FoldFrameView& frame, const FoldGraph& graph,
               PatternFile& file);

}  // namespace kiri
