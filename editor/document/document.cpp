// SPDX-License-Identifier: MIT
#include "editor/document/document.h"

#include "core/model/apply.h"
#include "editor/document/step_fields.h"

namespace kiri {
namespace {

/// A change that asks the history for something that may fail.
template <class Ask>
Change asking(Ask ask) {
  return [ask = std::move(ask)](const History& from, const Progress& progress) -> Result<History> {
    History next = from;
    const Status done = ask(next, progress);
    if (!done) return done.error();
    return next;
  };
}

std::size_t facetsIn(const std::vector<StepOutcome>& outcomes) {
  std::size_t facets = 0;
  for (const StepOutcome& outcome : outcomes)
    facets += outcome.state ? outcome.state->pattern.facets.size() : 0;
  return facets;
}

}  // namespace

Document::Document(History history) : history_(std::move(history)) {
  const std::vector<Step>& steps = history_.model().steps;
  for (std::size_t i = 0; i < steps.size(); ++i)
    past_.push_back({summaryOf(steps[i], i + 1), std::nullopt});
}

Result<Document> Document::create(Model model, const Progress& progress) {
  Result<History> history = History::open(std::move(model), progress);
  if (!history) return history.error();
  Document document(std::move(*history));
  document.noteSaved();
  return document;
}

Result<Document> Document::recovered(Model model, std::size_t count, const Progress& progress) {
  Result<History> history = History::open(std::move(model), progress);
  if (!history) return history.error();
  Document document(std::move(*history));
  while (document.count() > count) document.undo();
  return document;
}

Model Document::modelToSave() const {
  Model model = history_.model();
  model.steps.resize(history_.count());
  return model;
}

std::shared_ptr<const FoldedState> Document::stateAfter(std::size_t count) const {
  return history_.stateAfter(count);
}

void Document::become(History next, Phrase what) {
  history_.dropUndone();
  future_.clear();
  ++revision_;
  if (!(next.model() == history_.model())) {
    HistoryDifference back = next.differenceTo(history_);
    const bool hasOneMore = next.model().steps.size() == history_.model().steps.size() + 1;
    Turn turn{std::move(what), std::nullopt};
    const bool isAddedAtCursor = next.count() == history_.cursor() + 1 && !back.head;
    if (isAddedAtCursor && turn.what.isEmpty())
      turn.what = summaryOf(next.model().steps.back(), next.model().steps.size());
    if (!hasOneMore || !back.steps.empty() || back.head) turn.other = std::move(back);
    past_.push_back(std::move(turn));
  }
  history_ = std::move(next);
  forgetFarStates();
}

bool Document::isLong(const std::vector<Turn>& turns) {
  if (turns.empty() || !turns.back().other) return false;
  return turns.back().other->outcomes.size() < turns.back().other->steps.size();
}

void Document::keepFacets(std::size_t most) {
  facetsKept_ = most;
  forgetFarStates();
}

void Document::forgetFarStates() {
  for (std::vector<Turn>* turns : {&past_, &future_}) {
    std::size_t kept = 0;
    for (auto turn = turns->rbegin(); turn != turns->rend(); ++turn) {
      if (!turn->other) continue;
      kept += facetsIn(turn->other->outcomes);
      if (kept > facetsKept_) turn->other->outcomes = {};
    }
  }
}

bool Document::canUndo() const { return cursor() < count() || !past_.empty(); }

bool Document::undo() {
  if (!canUndo()) return false;
  ++revision_;
  if (cursor() < count()) return history_.moveTo(count());
  Turn turn = std::move(past_.back());
  past_.pop_back();
  if (turn.other) {
    turn.other = history_.exchange(std::move(*turn.other));
  } else {
    history_.undo();
  }
  future_.push_back(std::move(turn));
  forgetFarStates();
  return true;
}

bool Document::redo() {
  if (!canRedo()) return false;
  ++revision_;
  Turn turn = std::move(future_.back());
  future_.pop_back();
  if (turn.other) {
    turn.other = history_.exchange(std::move(*turn.other));
  } else {
    history_.redo();
  }
  past_.push_back(std::move(turn));
  forgetFarStates();
  return true;
}

bool Document::jumpTo(std::size_t count) {
  if (count > model().steps.size() || count == cursor()) return false;
  while (this->count() < count) redo();
  history_.moveTo(count);
  ++revision_;
  return true;
}

Phrase Document::undoPhrase() const {
  if (cursor() < count()) return {KIRI_TEXT("editor/document", "look at an earlier step"), {}};
  return past_.empty() ? Phrase{} : past_.back().what;
}

Phrase Document::redoPhrase() const { return future_.empty() ? Phrase{} : future_.back().what; }

bool Document::isModified() const { return !saved_ || !(modelToSave() == *saved_); }

Change addStep(Step step) {
  return [step = std::move(step)](const History& from, const Progress&) -> Result<History> {
    History next = from;
    const int number = static_cast<int>(from.cursor()) + 1;
    Step added = step;
    // Where an earlier step does not apply, `add` says which and why.
    if (const auto before = from.stateAfter(from.cursor())) {
      Result<Step> resolved = resolve(*before, step, number);
      if (!resolved) return resolved.error();
      added = std::move(*resolved);
    }
    const Status done = next.add(std::move(added));
    if (!done) return done.error();
    return next;
  };
}

Change editStep(std::size_t index, Step step) {
  return asking([index, step = std::move(step)](History& history, const Progress& progress) {
    return history.edit(index, step, progress);
  });
}

Change removeStep(std::size_t index) {
  return asking([index](History& history, const Progress& progress) {
    return history.remove(index, progress);
  });
}

Change setSheet(SheetSpec sheet) {
  return asking([sheet = std::move(sheet)](History& history, const Progress& progress) {
    return history.setSheet(sheet, progress);
  });
}

Change setSides(PaperSide front, PaperSide back) {
  return asking([front = std::move(front), back = std::move(back)](History& history,
                                                                   const Progress&) -> Status {
    history.setSides(front, back);
    return std::monostate{};
  });
}

Change setTitle(std::string title, std::string notes) {
  return asking([title = std::move(title), notes = std::move(notes)](History& history,
                                                                     const Progress&) -> Status {
    history.setTitle(title, notes);
    return std::monostate{};
  });
}

Change setOpening(Sequence opening) {
  return asking([opening](History& history, const Progress&) -> Status {
    history.setOpening(opening);
    return std::monostate{};
  });
}

}  // namespace kiri
