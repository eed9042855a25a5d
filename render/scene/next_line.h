// The line that a step is about to be done along, as it lies on the model.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "core/geometry/cubic.h"
#include "core/model/step.h"
#include "core/paper/folded_state.h"
#include "render/scene/line_looks.h"
#include "render/visibility/view_frame.h"

namespace kiri {

/// Chains of arcs in view coordinates, and how they are meant. No chains: the step is not drawn as
/// a line, or its line is not on the paper.
struct NextLine {
  LineKind kind = LineKind::Flat;
  std::vector<std::vector<Arc>> chains;
};

/// What `step`, to be applied to `state`, draws on the model. A valley fold is a mountain seen from
/// behind.
NextLine nextLine(const FoldedState& state, const Step& step, const ViewFrame& view);

/// A few words for a step without a title, like "valley fold".
std::string wordsFor(const Step& step);

}  // namespace kiri
