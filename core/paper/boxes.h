// The boxes that hold the paper: at rest and as it lies.
// SPDX-License-Identifier: MIT
#pragma once

#include "core/paper/folded_state.h"

namespace kiri {

/// A box of the model frame, mm.
struct ModelBox {
  Vec3 low;
  Vec3 high;

  Vec3 middle() const { return (low + high) / 2; }
};

/// The box of the model as it lies, exact for curved borders too.
ModelBox modelBoxOf(const FoldedState& state);

/// The box of the paper that is left, in the paper frame, exact for curved borders too.
Box paperBoxOf(const CreasePattern& pattern);

}  // namespace kiri
