// Changes one after the other.
// SPDX-License-Identifier: MIT
#include "editor/session/change_queue.h"

#include <optional>
#include <utility>

namespace kiri {

namespace {

struct Entry {
  Change change;
  Phrase what;
  ChangeQueue::Ended ended;
  std::function<void()> action;  ///< instead of the change
};

}  // namespace

struct ChangeQueue::Shared {
  TaskRunner* runner = nullptr;  ///< none when the queue is gone
  std::function<const History&()> history;
  std::deque<Entry> waiting;
  bool isRunning = false;
  std::optional<TaskId> task;
  bool isCancelled = false;
};

ChangeQueue::ChangeQueue(TaskRunner& runner, std::function<const History&()> history)
    : shared_(std::make_shared<Shared>()) {
  shared_->runner = &runner;
  shared_->history = std::move(history);
}

ChangeQueue::~ChangeQueue() {
  cancel();
  shared_->runner = nullptr;
}

void ChangeQueue::add(Change change, Phrase what, Ended ended) {
  shared_->waiting.push_back({std::move(change), std::move(what), std::move(ended), {}});
  next(shared_);
}

void ChangeQueue::add(std::function<void()> action) {
  shared_->waiting.push_back({{}, {}, {}, std::move(action)});
  next(shared_);
}

bool ChangeQueue::isBusy() const { return shared_->isRunning; }

void ChangeQueue::cancel() {
  shared_->waiting.clear();
  shared_->isCancelled = shared_->isRunning;
  if (shared_->task) shared_->runner->cancel(*shared_->task);
}

void ChangeQueue::next(const std::shared_ptr<Shared>& shared) {
  if (shared->isRunning || !shared->runner || shared->waiting.empty()) return;
  Entry entry = std::move(shared->waiting.front());
  shared->waiting.pop_front();
  shared->isRunning = true;
  if (entry.action) {
    entry.action();
    shared->isRunning = false;
    next(shared);
    return;
  }
  shared->isCancelled = false;
  shared->task.reset();
  // The work owns what it reads: the history may not change meanwhile, but the window may go.
  const auto from = std::make_shared<const History>(shared->history());
  const auto result = std::make_shared<std::optional<Result<History>>>();
  Task task;
  task.what = entry.what;
  task.work = [change = std::move(entry.change), from, result](const Progress& progress) {
    result->emplace(change(*from, progress));
  };
  task.done = [shared, result, ended = std::move(entry.ended)] {
    shared->isRunning = false;
    shared->task.reset();
    if (!shared->runner) return;
    const bool isStopped = shared->isCancelled || !result->has_value();
    shared->isCancelled = false;
    ended(isStopped ? Result<History>(Error{ErrorCode::Cancelled, "the work was stopped", {}})
                    : std::move(**result));
    next(shared);
  };
  const TaskId id = shared->runner->start(std::move(task));
  if (shared->isRunning && !shared->task) shared->task = id;
}

}  // namespace kiri
