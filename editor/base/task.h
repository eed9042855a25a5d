// Long work, done where it does not keep the person waiting.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <functional>
#include <memory>

#include "core/base/progress.h"
#include "editor/base/phrase.h"

namespace kiri {

/// Work and what to do when it has ended. `work` may run on any thread and touches only what it
/// owns or what nobody changes; `done` runs on the thread that started the task. `done` is called
/// once, also when the task was cancelled (its work then saw a Progress that said so, or was never
/// begun), but not after the runner is gone.
struct Task {
  Phrase what;  ///< for a progress bar, "Finding the way"; empty: nobody needs to be told
  std::function<void(const Progress&)> work;
  std::function<void()> done;
};

using TaskId = std::uint64_t;

/// Where tasks are done: beside the window, or at once in tests and commands.
class TaskRunner {
 public:
  virtual ~TaskRunner() = default;
  virtual TaskId start(Task task) = 0;
  /// Asks the task to stop. Nothing happens when it has ended.
  virtual void cancel(TaskId task) = 0;
};

/// Does every task at once, on the caller's thread.
class DirectRunner final : public TaskRunner {
 public:
  TaskId start(Task task) override;
  void cancel(TaskId task) override;

 private:
  TaskId last_ = 0;
};

/// Work of which only the newest asking matters: while one runs, the latest asked for waits, and
/// those asked for between are dropped. For previews, meshes, pictures.
class LatestTask {
 public:
  /// What becomes of work that runs when newer work is asked for. MayEnd: it is done and reported
  /// before the newest begins, so that work which lasts longer than the hand rests is not starved.
  enum class Overtaken { Stops, MayEnd };

  explicit LatestTask(TaskRunner& runner, Overtaken overtaken = Overtaken::Stops);
  ~LatestTask();
  LatestTask(const LatestTask&) = delete;
  LatestTask& operator=(const LatestTask&) = delete;

  /// Asks for work. When what runs has ended (asked to stop, or by itself: Overtaken) the newest
  /// asked for starts. `done` of dropped or stopped work is not called.
  void ask(Task task);
  /// Nothing is wanted any more.
  void clear();
  bool isBusy() const;

 private:
  struct Shared;
  static void begin(const std::shared_ptr<Shared>& shared);
  std::shared_ptr<Shared> shared_;
};

}  // namespace kiri
