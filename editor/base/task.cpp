// Doing tasks at once, and only the newest of several.
// SPDX-License-Identifier: MIT
#include "editor/base/task.h"

#include <optional>
#include <utility>

namespace kiri {

TaskId DirectRunner::start(Task task) {
  if (task.work) task.work({});
  if (task.done) task.done();
  return ++last_;
}

void DirectRunner::cancel(TaskId) {}

struct LatestTask::Shared {
  TaskRunner* runner = nullptr;  ///< none when nobody wants anything any more
  Overtaken overtaken = Overtaken::Stops;
  std::optional<Task> waiting;
  std::optional<TaskId> running;
  bool isRunning = false;
  bool isWanted = false;  ///< what runs is still the newest
};

LatestTask::LatestTask(TaskRunner& runner, Overtaken overtaken)
    : shared_(std::make_shared<Shared>()) {
  shared_->runner = &runner;
  shared_->overtaken = overtaken;
}

LatestTask::~LatestTask() {
  clear();
  shared_->runner = nullptr;
}

void LatestTask::ask(Task task) {
  if (shared_->overtaken == Overtaken::Stops) clear();
  shared_->waiting = std::move(task);
  if (!shared_->isRunning) begin(shared_);
}

void LatestTask::clear() {
  shared_->waiting.reset();
  shared_->isWanted = false;
  if (shared_->isRunning && shared_->running) shared_->runner->cancel(*shared_->running);
}

bool LatestTask::isBusy() const { return shared_->isRunning || shared_->waiting.has_value(); }

void LatestTask::begin(const std::shared_ptr<Shared>& shared) {
  Task task = std::move(*shared->waiting);
  shared->waiting.reset();
  shared->isRunning = true;
  shared->isWanted = true;
  shared->running.reset();
  auto done = [shared, report = std::move(task.done)] {
    shared->isRunning = false;
    shared->running.reset();
    if (shared->isWanted && report) report();
    if (shared->runner && shared->waiting && !shared->isRunning) begin(shared);
  };
  const TaskId id =
      shared->runner->start({std::move(task.what), std::move(task.work), std::move(done)});
  // A runner that does everything at once has ended the task, or a later one, by now.
  if (shared->isRunning && !shared->running) shared->running = id;
}

}  // namespace kiri
