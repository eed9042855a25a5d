// A model folded, half way, and unfolded: what galleries show of it.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <functional>
#include <optional>

#include "core/model/model.h"
#include "core/model/timeline.h"

namespace kiri {

/// How the half unfolded model came to be.
enum class HalfWay {
  Unfolding,  ///< half of the way from folded to unfolded
  LastFold,   ///< the paper would have to bend to unfold; half of the last movement before
  None,       ///< nothing moves
};

/// The state after so many steps of a model.
using StateAfter = std::function<const FoldedState&(std::size_t)>;

/// After how many steps the model is folded: at its end, or before a step that unfolds all of it,
/// where most fold lines are folded; the later of equals. None when it is never folded there.
std::optional<std::size_t> stepsUntilFolded(const Model& model, const StateAfter& stateAfter);

struct Moments {
  std::size_t folded = 0;       ///< after so many steps the model is folded
  bool isOpenAtTheEnd = false;  ///< the finished model lies unfolded
  HalfWay halfWay = HalfWay::None;
  std::optional<FoldedState> half;
  FoldedState unfolded;  ///< all of the paper that is left at the end, at rest
};

/// `timeline` holds all steps of the model. Folded is the model after stepsUntilFolded, or at its
/// end.
Moments momentsOf(const Model& model, const Timeline& timeline);

}  // namespace kiri
