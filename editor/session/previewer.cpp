// Applying proposals beside the window.
// SPDX-License-Identifier: MIT
#include "editor/session/previewer.h"

#include <utility>

#include "core/model/apply.h"
#include "editor/session/moved_facets.h"

namespace kiri {

Preview previewOf(const std::shared_ptr<const FoldedState>& state, const Step& step, int number) {
  Preview preview;
  preview.step = step;
  preview.before = state;
  Result<FoldedState> after = apply(*state, step, number);
  if (!after) {
    preview.error = after.error();
    return preview;
  }
  preview.after = std::make_shared<const FoldedState>(std::move(*after));
  const auto& all = preview.after->collisions;
  const std::size_t known = std::min(state->collisions.size(), all.size());
  preview.collisions.assign(all.begin() + static_cast<std::ptrdiff_t>(known), all.end());
  return preview;
}

Previewer::Previewer(TaskRunner& runner, std::function<void()> changed)
    : changed_(std::move(changed)), task_(runner) {}

void Previewer::ask(const std::shared_ptr<const FoldedState>& state, const Step& step, int number) {
  if (asked_ && asked_->state == state && asked_->step == step && asked_->number == number) return;
  asked_ = Asked{state, step, number};
  struct Found {
    Preview preview;
    std::vector<FacetTint> tints;
  };
  const auto found = std::make_shared<Found>();
  Task task;
  task.work = [asked = *asked_, found](const Progress& progress) {
    if (!goesOn(progress, 0)) return;
    found->preview = previewOf(asked.state, asked.step, asked.number);
    if (!found->preview.after || !goesOn(progress, 0.5)) return;
    const std::vector<bool> moved = movedFacets(*asked.state, *found->preview.after);
    found->tints.assign(moved.size(), FacetTint::None);
    for (std::size_t i = 0; i < moved.size(); ++i) {
      if (moved[i]) found->tints[i] = FacetTint::Pale;
    }
  };
  task.done = [this, found] {
    preview_ = std::move(found->preview);
    tints_ = std::move(found->tints);
    changed_();
  };
  task_.ask(std::move(task));
}

void Previewer::clear() {
  task_.clear();
  asked_.reset();
  preview_.reset();
  tints_.clear();
}

}  // namespace kiri
