// The moments of a model's life that a gallery shows.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "core/model/model.h"
#include "core/model/replay.h"
#include "core/model/timeline.h"

namespace kiri::cli {

/// How the half unfolded model came to be.
enum class HalfWay {
  Unfolding,  ///< half of the way from folded to unfolded
  LastFold,   ///< the paper would have to bend to unfold; half of the last movement before
  None,       ///< nothing moves
};

struct GalleryMoments {
  std::size_t folded = 0;       ///< after so many steps the model is folded
  bool isOpenAtTheEnd = false;  ///< the finished model lies unfolded
  HalfWay halfWay = HalfWay::None;
  std::optional<FoldedState> half;
  FoldedState unfolded;  ///< all of the paper that is left at the end, at rest
};

/// `timeline` holds all steps of the model. Folded is the model at its end, or before a step that
/// unfolds all of it, where most fold lines are folded; the later of equals.
GalleryMoments galleryMomentsOf(const Model& model, const Timeline& timeline);

/// The states of a time line as a replay; `timeline` must outlive it.
Replay replayOf(const Timeline& timeline, std::size_t steps);

}  // namespace kiri::cli
