// The steps of a model as frames of a FOLD file.
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <vector>

#include "core/model/model.h"
#include "io/fold_writer.h"

namespace kiri {

/// A frame for the state after each of the model's first steps, with the step's title and notes.
/// `between`: a state on the way through the step that follows, or none. Requires no more states
/// than the model has steps.
std::vector<FoldFrame> foldHistoryOf(const Model& model,
                                     const std::vector<std::shared_ptr<const FoldedState>>& after,
                                     std::shared_ptr<const FoldedState> between = nullptr);

}  // namespace kiri
