// A task runner that does nothing before it is told: for tests of what happens meanwhile.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <deque>
#include <set>
#include <utility>

#include "editor/base/task.h"

namespace kiri {

class HandRunner final : public TaskRunner {
 public:
  TaskId start(Task task) override {
    waiting_.push_back({++last_, std::move(task)});
    return last_;
  }
  void cancel(TaskId task) override { cancelled_.insert(task); }

  std::size_t waitingCount() const { return waiting_.size(); }
  /// Does the oldest task; cancelled ones are begun all the same and told by their Progress.
  void runOne() {
    auto [id, task] = std::move(waiting_.front());
    waiting_.pop_front();
    const TaskId number = id;
    if (task.work) task.work([this, number](double) { return cancelled_.count(number) == 0; });
    if (task.done) task.done();
  }
  /// Until nothing is left, also of what is started meanwhile.
  void runAll() {
    while (!waiting_.empty()) runOne();
  }

 private:
  std::deque<std::pair<TaskId, Task>> waiting_;
  std::set<TaskId> cancelled_;
  TaskId last_ = 0;
};

}  // namespace kiri
