// What is told about the step that a person looks at, as a folding guide tells it.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>

#include "core/model/model.h"
#include "editor/base/phrase.h"

namespace kiri {

class Session;

struct Caption {
  std::size_t step = 0;  ///< 1 is the first; 0: the model as a whole
  std::size_t steps = 0;
  std::string title;  ///< of the model, or of the step; may be empty
  std::string notes;
  Phrase summary;  ///< what the step is in a few words; empty: the model as a whole
};

/// `step`: from 1; 0 is the model. Requires step <= the number of steps.
Caption captionOf(const Model& model, std::size_t step);

/// True when somebody wrote something to be read along with the steps.
bool isTold(const Model& model);

/// The step whose outcome is shown, or that is under way in the film: see captionOf.
std::size_t stepLookedAt(Session& session);

}  // namespace kiri
