// SPDX-License-Identifier: MIT
#include "core/model/history.h"

#include <algorithm>
#include <iterator>

#include "core/model/apply.h"
#include "core/model/numbers.h"
#include "core/model/pattern_step.h"
#include "core/model/requests.h"

namespace kiri {
namespace {

using StatePtr = std::shared_ptr<const FoldedState>;

std::ptrdiff_t offset(std::size_t index) { return static_cast<std::ptrdiff_t>(index); }

/// Why step `index` cannot be changed: `what` says how it was to be.
Error noSuchStep(std::size_t index, std::size_t steps, const char* what) {
  const std::string number = std::to_string(index + 1);
  if (index >= steps)
    return {ErrorCode::NotFound, "there is no step " + number + " to " + what, {}};
  return {ErrorCode::NotFound,
          "step " + number + " was undone; redo it before you " + what + " it",
          {}};
}

/// The name of the fold line that a step makes; none when it makes none.
std::optional<std::string> nameMadeBy(const Step& step, std::size_t index) {
  const FoldStep* fold = std::get_if<FoldStep>(&step.action);
  if (fold == nullptr) return std::nullopt;
  return foldName(*fold, static_cast<int>(index) + 1);
}

/// Errors: BadValue - another step of the model makes a fold line of the name.
Status checkNameIsFree(const std::vector<Step>& steps, std::size_t index, const std::string& name) {
  for (std::size_t i = 0; i < steps.size(); ++i) {
    if (i == index || nameMadeBy(steps[i], i) != name) continue;
    return Error{ErrorCode::BadValue,
                 "there is a fold line named \"" + name + "\" already, of step " +
                     std::to_string(i + 1) + "; give this one another name",
                 {}};
  }
  return std::monostate{};
}

void rename(FoldLineName& line, const std::string& from, const std::string& to) {
  std::string* name = std::get_if<std::string>(&line);
  if (name != nullptr && *name == from) *name = to;
}

/// The lines of a crease pattern, "FROM 1" and so on, get the pattern's new name.
void renameNumbered(FoldLineName& line, const std::string& from, const std::string& to) {
  std::string* name = std::get_if<std::string>(&line);
  if (name == nullptr || name->rfind(from + " ", 0) != 0) return;
  const std::string number = name->substr(from.size() + 1);
  if (number.empty() || number.find_first_not_of("0123456789") != std::string::npos) return;
  *name = to + " " + number;
}

/// Calls rename(name) for every fold line that the step names.
template <class Rename>
void forEachLine(Step& step, Rename rename) {
  if (AngleStep* angle = std::get_if<AngleStep>(&step.action)) rename(angle->line);
  if (UnfoldStep* unfold = std::get_if<UnfoldStep>(&step.action)) {
    for (FoldLineName& line : unfold->lines) rename(line);
  }
  if (RefoldStep* refold = std::get_if<RefoldStep>(&step.action)) {
    for (FoldLineName& line : refold->lines) rename(line);
  }
}

/// Fold lines that `before` made and that have another name from `after` are called by it in the
/// steps from `from` on.
void followRenaming(const Step& before, const Step& after, std::size_t index,
                    std::vector<Step>& steps) {
  const std::optional<std::string> old = nameMadeBy(before, index);
  const std::optional<std::string> now = nameMadeBy(after, index);
  const PatternStep* oldPattern = std::get_if<PatternStep>(&before.action);
  const PatternStep* nowPattern = std::get_if<PatternStep>(&after.action);
  for (std::size_t i = index + 1; i < steps.size(); ++i) {
    forEachLine(steps[i], [&](FoldLineName& line) {
      if (old && now) rename(line, *old, *now);
      if (oldPattern != nullptr && nowPattern != nullptr)
        renameNumbered(line, linesName(*oldPattern), linesName(*nowPattern));
    });
  }
}

/// All of the model but its steps.
Model headOf(const Model& model) {
  Model head = model;
  std::vector<Step>().swap(head.steps);  // clear() would keep the room for them
  return head;
}

bool isSame(const StepOutcome& a, const StepOutcome& b) {
  if (a.state != b.state || a.error.has_value() != b.error.has_value()) return false;
  return !a.error || (a.error->code == b.error->code && a.error->message == b.error->message);
}

}  // namespace

Result<History> History::open(Model model, const Progress& progress) {
  Result<Replay> replayed = replay(model, progress);
  if (!replayed) return replayed.error();
  History history;
  history.model_ = std::move(model);
  history.replay_ = std::move(*replayed);
  history.count_ = history.cursor_ = history.model_.steps.size();
  return history;
}

StatePtr History::sharedState() const {
  for (std::size_t i = cursor_; i > 0; --i) {
    if (replay_.outcomes[i - 1].state) return replay_.outcomes[i - 1].state;
  }
  return replay_.start;
}

StatePtr History::stateAfter(std::size_t count) const {
  KIRI_CHECK(count <= replay_.outcomes.size(), "a state is asked for that the history has");
  return count == 0 ? replay_.start : replay_.outcomes[count - 1].state;
}

std::optional<Error> History::problemOf(std::size_t index) const {
  return replay_.outcomes[index].error;
}

bool History::undo() {
  if (count_ == 0) return false;
  cursor_ = --count_;
  return true;
}

bool History::redo() {
  if (count_ == model_.steps.size()) return false;
  cursor_ = ++count_;
  return true;
}

bool History::moveTo(std::size_t cursor) {
  if (cursor > model_.steps.size() || cursor == cursor_) return false;
  cursor_ = cursor;
  count_ = std::max(count_, cursor_);
  return true;
}

void History::dropUndone() {
  model_.steps.resize(count_);
  replay_.outcomes.resize(count_);
}

Status History::add(Step step) {
  const Result<StatePtr> before = replay_.after(cursor_);
  if (!before) return before.error();
  Result<FoldedState> next = apply(**before, step, static_cast<int>(cursor_) + 1);
  if (!next) return next.error();
  count_ = cursor_;
  dropUndone();
  model_.steps.push_back(std::move(step));
  replay_.outcomes.push_back({std::make_shared<const FoldedState>(std::move(*next)), std::nullopt});
  count_ = ++cursor_;
  return std::monostate{};
}

Status History::replayFrom(std::size_t from, const Progress& progress) {
  return kiri::replayFrom(replay_, model_, from, progress);
}

Status History::edit(std::size_t index, Step step, const Progress& progress) {
  if (index >= count_) return noSuchStep(index, model_.steps.size(), "edit");
  if (const Status checked = checkNumbers(step); !checked) return checked.error();
  History next = *this;
  next.dropUndone();
  std::vector<Step>& steps = next.model_.steps;
  if (const std::optional<std::string> now = nameMadeBy(step, index)) {
    if (const Status free = checkNameIsFree(steps, index, *now); !free) return free.error();
  }
  const bool isSameAction = steps[index].action == step.action;
  followRenaming(steps[index], step, index, steps);
  steps[index] = std::move(step);
  if (!isSameAction) {
    if (const Status done = next.replayFrom(index, progress); !done) return done.error();
  }
  *this = std::move(next);
  return std::monostate{};
}

Status History::remove(std::size_t index, const Progress& progress) {
  if (index >= count_) return noSuchStep(index, model_.steps.size(), "remove");
  History next = *this;
  next.dropUndone();
  std::vector<Step>& steps = next.model_.steps;
  for (std::size_t i = index + 1; i < steps.size(); ++i) {
    if (FoldStep* fold = std::get_if<FoldStep>(&steps[i].action))
      fold->name = *nameMadeBy(steps[i], i);
  }
  steps.erase(steps.begin() + offset(index));
  --next.count_;
  if (next.cursor_ > index) --next.cursor_;
  if (const Status done = next.replayFrom(index, progress); !done) return done.error();
  *this = std::move(next);
  return std::monostate{};
}

Status History::setSheet(SheetSpec sheet, const Progress& progress) {
  Model model = model_;
  model.steps.resize(count_);
  model.sheet = std::move(sheet);
  Result<Replay> replayed = replay(model, progress);
  if (!replayed) return replayed.error();
  model_ = std::move(model);
  replay_ = std::move(*replayed);
  return std::monostate{};
}

void History::setSides(PaperSide front, PaperSide back) {
  dropUndone();
  model_.front = std::move(front);
  model_.back = std::move(back);
}

void History::setTitle(std::string title, std::string notes) {
  dropUndone();
  model_.title = std::move(title);
  model_.notes = std::move(notes);
}

void History::setOpening(Sequence opening) {
  dropUndone();
  model_.opening = opening;
}

HistoryDifference History::differenceTo(const History& other) const {
  HistoryDifference difference;
  const std::size_t most = std::min(model_.steps.size(), other.model_.steps.size());
  std::size_t& first = difference.first;
  while (first < most && isSame(replay_.outcomes[first], other.replay_.outcomes[first]) &&
         model_.steps[first] == other.model_.steps[first]) {
    ++first;
  }
  difference.steps.assign(other.model_.steps.begin() + offset(first), other.model_.steps.end());
  difference.outcomes.assign(other.replay_.outcomes.begin() + offset(first),
                             other.replay_.outcomes.end());
  Model head = headOf(other.model_);
  if (!(head == headOf(model_))) difference.head = std::move(head);
  difference.start = other.replay_.start;
  difference.count = other.count_;
  difference.cursor = other.cursor_;
  return difference;
}

HistoryDifference History::exchange(HistoryDifference difference) {
  HistoryDifference back;
  back.first = difference.first;
  back.steps.assign(std::make_move_iterator(model_.steps.begin() + offset(back.first)),
                    std::make_move_iterator(model_.steps.end()));
  back.outcomes.assign(std::make_move_iterator(replay_.outcomes.begin() + offset(back.first)),
                       std::make_move_iterator(replay_.outcomes.end()));
  back.start = std::move(replay_.start);
  back.count = count_;
  back.cursor = cursor_;
  std::vector<Step> steps = std::move(model_.steps);
  if (difference.head) {
    back.head = std::move(model_);
    model_ = std::move(*difference.head);
    back.head->steps.clear();
  }
  steps.resize(back.first);
  replay_.outcomes.resize(back.first);
  std::move(difference.steps.begin(), difference.steps.end(), std::back_inserter(steps));
  std::move(difference.outcomes.begin(), difference.outcomes.end(),
            std::back_inserter(replay_.outcomes));
  model_.steps = std::move(steps);
  replay_.start = std::move(difference.start);
  count_ = difference.count;
  cursor_ = difference.cursor;
  if (replay_.outcomes.size() < model_.steps.size()) {
    const Status done = replayFrom(replay_.outcomes.size(), {});
    KIRI_CHECK(done.isOk(), "nobody stops this replay");
  }
  return back;
}

}  // namespace kiri
