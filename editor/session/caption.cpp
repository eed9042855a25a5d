// SPDX-License-Identifier: MIT
#include "editor/session/caption.h"

#include <algorithm>

#include "core/base/check.h"
#include "editor/document/step_fields.h"
#include "editor/session/session.h"

namespace kiri {

Caption captionOf(const Model& model, std::size_t step) {
  KIRI_CHECK(step <= model.steps.size(), "a caption is of a step that is there");
  Caption caption{step, model.steps.size(), model.title, model.notes, {}};
  if (step == 0) return caption;
  const Step& told = model.steps[step - 1];
  caption.title = told.title;
  caption.notes = told.notes;
  caption.summary = summaryOf(told, step);
  return caption;
}

bool isTold(const Model& model) {
  return !model.notes.empty() ||
         std::any_of(model.steps.begin(), model.steps.end(),
                     [](const Step& step) { return !step.title.empty() || !step.notes.empty(); });
}

std::size_t stepLookedAt(Session& session) {
  const Document& document = session.document();
  const std::size_t step = session.isPlayerOpen() ? session.player().stepSeen() : document.cursor();
  return std::min(step, document.model().steps.size());
}

}  // namespace kiri
