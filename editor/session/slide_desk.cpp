// Dragging sliders.
// SPDX-License-Identifier: MIT
#include "editor/session/slide_desk.h"

#include <utility>

namespace kiri {

SlideDesk::SlideDesk(TaskRunner& runner, std::function<void()> changed)
    : changed_(std::move(changed)), task_(runner) {}

void SlideDesk::begin(std::shared_ptr<const FoldedState> from, FoldLineId line) {
  end();
  from_ = std::move(from);
  line_ = line;
}

void SlideDesk::beginAll(std::shared_ptr<const FoldedState> from, Sequence sequence) {
  end();
  from_ = std::move(from);
  const auto found = std::make_shared<std::optional<Result<AllSlider>>>();
  Task task;
  task.what = {KIRI_TEXT("editor/session", "Finding the way"), {}};
  task.work = [start = from_, sequence, found](const Progress& progress) {
    found->emplace(AllSlider::prepare(*start, sequence, progress));
  };
  task.done = [this, found] {
    if (!found->has_value()) return;
    Result<AllSlider>& ready = **found;
    if (ready) {
      all_ = std::move(*ready);
      if (isWanted_) {
        showAll();
      } else {
        wanted_ = all_->openness();
        changed_();
      }
    } else {
      problem_ = ready.error();
      changed_();
    }
  };
  task_.ask(std::move(task));
}

void SlideDesk::slide(double amount) {
  if (!isSliding() || !line_) return;
  wanted_ = amount;
  const auto found = std::make_shared<std::optional<SlideShow>>();
  Task task;
  task.work = [from = from_, line = *line_, amount, found](const Progress&) {
    found->emplace(slideTo(*from, line, amount));
  };
  task.done = [this, found] {
    show_ = std::move(*found);
    changed_();
  };
  task_.ask(std::move(task));
}

void SlideDesk::slideAll(double openness) {
  if (!isSlidingAll()) return;
  wanted_ = openness;
  isWanted_ = true;
  if (all_) showAll();  // else as soon as the way is known
}

void SlideDesk::showAll() {
  const auto found = std::make_shared<std::optional<SlideShow>>();
  Task task;
  task.work = [all = *all_, openness = wanted_, found](const Progress&) {
    found->emplace(SlideShow{all.at(openness), openness, {}, {}});
  };
  task.done = [this, found] {
    show_ = std::move(*found);
    // An end that cannot be reached says why.
    problem_ = wanted_ >= 1   ? all_->whyNotOpen()
               : wanted_ <= 0 ? all_->whyNotFolded()
                              : std::nullopt;
    changed_();
  };
  task_.ask(std::move(task));
}

std::optional<double> SlideDesk::openness() const {
  if (!isSlidingAll() || !all_) return std::nullopt;
  return show_ ? show_->amount : all_->openness();
}

std::optional<Step> SlideDesk::stepOfAll() const {
  if (!isSlidingAll() || !all_ || !isWanted_) return std::nullopt;
  return all_->stepAt(wanted_);
}

void SlideDesk::end() {
  task_.clear();
  from_.reset();
  line_.reset();
  all_.reset();
  show_.reset();
  problem_.reset();
  wanted_ = 0;
  isWanted_ = false;
}

}  // namespace kiri
