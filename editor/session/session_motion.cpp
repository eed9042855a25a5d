// Sliders and the film.
// SPDX-License-Identifier: MIT
#include <utility>

#include "editor/session/session_parts.h"

namespace kiri {

std::vector<FoldSlider> Session::sliders() const { return slidersOf(*parts_->document.state()); }

void Session::beginSlide(FoldLineId line) {
  parts_->dropGesture();
  closePlayer();
  parts_->slides.begin(parts_->document.state(), line);
}

void Session::slide(double amount) {
  parts_->slides.slide(amount);
  parts_->tell();
}

void Session::endSlide(bool keep) {
  SlideDesk& slides = parts_->slides;
  if (!slides.isSliding() || slides.isSlidingAll()) return;
  if (keep) {
    // The hand may have let go before the last place was computed.
    Change change = [from = slides.from(), line = *slides.line(), wanted = slides.wanted()](
                        const History& history, const Progress& progress) -> Result<History> {
      const SlideShow reached = slideTo(*from, line, wanted);
      const std::optional<Step> step = stepOfSlide(*from, line, reached.amount);
      if (!step) return Error{ErrorCode::Cancelled, "nothing has moved", {}};
      return addStep(*step)(history, progress);
    };
    if (slides.show()) parts_->committing = slides.show()->state;
    parts_->ask(std::move(change), {KIRI_TEXT("editor/session", "slide"), {}}, true);
  }
  slides.end();
  parts_->refreshShown();
  parts_->changed.marks = true;
  parts_->tell();
}

const std::optional<SlideShow>& Session::slideShow() const { return parts_->slides.show(); }
const std::optional<Error>& Session::slideProblem() const { return parts_->slides.problem(); }

void Session::beginSlideAll() {
  parts_->dropGesture();
  closePlayer();
  parts_->slides.beginAll(parts_->document.state(), parts_->document.model().opening);
  parts_->tell();
}

void Session::slideAll(double openness) {
  parts_->slides.slideAll(openness);
  parts_->tell();
}

void Session::endSlideAll(bool keep) {
  SlideDesk& slides = parts_->slides;
  if (!slides.isSlidingAll()) return;
  // Paper that is let go half-way springs back: no step says "half of everything".
  const std::optional<Step> step = keep ? slides.stepOfAll() : std::nullopt;
  if (step) {
    if (slides.show()) parts_->committing = slides.show()->state;
    parts_->ask(addStep(*step), {KIRI_TEXT("editor/session", "unfold"), {}}, true);
  }
  slides.end();
  parts_->refreshShown();
  parts_->changed.marks = true;
  parts_->tell();
}

double Session::openness() const {
  return parts_->slides.openness().value_or(opennessOf(*parts_->document.state()));
}

bool Session::isLeaf() const { return parts_->document.model().opening == Sequence::Together; }

void Session::setLeaf(bool isLeaf) {
  change(setOpening(isLeaf ? Sequence::Together : Sequence::InOrder),
         {KIRI_TEXT("editor/session", "how it opens"), {}});
}

Player& Session::player() { return parts_->player; }
bool Session::isPlayerOpen() const { return parts_->isPlayerOpen; }

void Session::playerMoved() {
  if (!parts_->isPlayerOpen) return;
  parts_->showFilm();
  parts_->tell();
}

void Session::openPlayer() {
  Parts& parts = *parts_;
  if (parts.isPlayerOpen) return;
  parts.dropGesture();
  const auto model = std::make_shared<const Model>(parts.document.modelToSave());
  const auto found = std::make_shared<std::optional<Result<Timeline>>>();
  Task task;
  task.what = {KIRI_TEXT("editor/session", "Making the film"), {}};
  task.work = [model, found](const Progress& progress) {
    found->emplace(Timeline::of(*model, {}, progress));
  };
  task.done = [this, found] {
    if (!found->has_value()) return;
    Result<Timeline>& made = **found;
    if (made) {
      parts_->player.load(std::make_shared<const Timeline>(std::move(*made)));
      parts_->isPlayerOpen = true;
      parts_->player.play();
      parts_->showFilm();
    } else {
      parts_->say(Notice::Kind::Refused,
                  {KIRI_TEXT("editor/session", "The film cannot be made"), {}},
                  made.error().message, made.error().witness);
    }
    parts_->changed.busy = true;
    parts_->refreshShown();
    parts_->tell();
  };
  parts.changed.busy = true;
  parts.playerTask.ask(std::move(task));
  parts.tell();
}

void Session::closePlayer() {
  if (!parts_->isPlayerOpen) return;
  parts_->isPlayerOpen = false;
  parts_->player.pause();
  parts_->refreshShown();
  parts_->changed.marks = true;
  parts_->tell();
}

void Session::advance(double seconds) {
  if (!parts_->isPlayerOpen || !parts_->player.advance(seconds)) return;
  parts_->showFilm();
  parts_->tell();
}

}  // namespace kiri
