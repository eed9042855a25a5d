// Long work on other threads, so that the window never waits.
// SPDX-License-Identifier: MIT
#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QThreadPool>
#include <QTimer>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>

#include "editor/base/task.h"

namespace kiri::desktop {

/// What a progress bar shows: the named task that has been running for the longest time.
struct Busy {
  TaskId task = 0;
  Phrase what;
  double done = 0;  ///< 0 to 1
  bool operator==(const Busy&) const = default;
};

/// The window's TaskRunner. Tasks begin in the order in which they were started, some of them side
/// by side; `done` is called from the event loop of the thread that made the runner (that of the
/// window), in the order in which work ended, and never after the runner is gone: its destructor
/// asks all work to stop and waits for it.
///
/// Made once in main; a progress bar listens to `busyChanged` and reads `busy()`; its cancel button
/// calls `cancel(busy()->task)`. Work that throws (a defect, core/base/check.h) counts as never
/// begun, and `defectFound` tells what it said.
class PoolRunner final : public QObject, public TaskRunner {
  Q_OBJECT
 public:
  /// `threads` below 1: as many as the machine has, but at least two.
  explicit PoolRunner(int threads = 0, QObject* parent = nullptr);
  ~PoolRunner() override;

  TaskId start(Task task) override;
  void cancel(TaskId task) override;
  /// Everything that was started and has not ended is asked to stop.
  void cancelAll();

  /// Named work that has taken longer than 150 ms; none when there is none.
  const std::optional<Busy>& busy() const { return busy_; }
  /// Tasks whose `done` has not been called yet, named or not.
  std::size_t pending() const { return jobs_.size(); }

 signals:
  void busyChanged();
  void defectFound(const QString& sentence);

 private:
  struct Job;
  void run(Job& job);
  void finish(TaskId task);
  void look();

  QThreadPool pool_;
  QTimer timer_;
  QElapsedTimer clock_;
  std::map<TaskId, std::shared_ptr<Job>> jobs_;
  std::optional<Busy> busy_;
  TaskId last_ = 0;
};

}  // namespace kiri::desktop
