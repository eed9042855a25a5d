// Work that follows what changes all the time, without ever being starved by it.
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <optional>

#include "editor/base/task.h"

namespace kiri::desktop {

/// Like LatestTask, but what runs may end: while a hand drags, a new state comes before the mesh of
/// the last one is done, and if that were stopped each time nothing would be seen until the hand
/// rests. Only the newest of those that wait is done next.
class SteadyTask {
 public:
  explicit SteadyTask(TaskRunner& runner) : shared_(std::make_shared<Shared>()) {
    shared_->runner = &runner;
  }
  ~SteadyTask() {
    shared_->runner = nullptr;
    shared_->waiting.reset();
  }
  SteadyTask(const SteadyTask&) = delete;
  SteadyTask& operator=(const SteadyTask&) = delete;

  void ask(Task task) {
    shared_->waiting = std::move(task);
    if (!shared_->isRunning) begin(shared_);
  }
  bool isBusy() const { return shared_->isRunning; }

 private:
  struct Shared {
    TaskRunner* runner = nullptr;  ///< none when nobody listens any more
    std::optional<Task> waiting;
    bool isRunning = false;
  };

  static void begin(const std::shared_ptr<Shared>& shared) {
    Task task = std::move(*shared->waiting);
    shared->waiting.reset();
    shared->isRunning = true;
    auto done = [shared, report = std::move(task.done)] {
      shared->isRunning = false;
      if (shared->runner && report) report();
      if (shared->runner && shared->waiting && !shared->isRunning) begin(shared);
    };
    shared->runner->start({std::move(task.what), std::move(task.work), std::move(done)});
  }

  std::shared_ptr<Shared> shared_;
};

}  // namespace kiri::desktop
