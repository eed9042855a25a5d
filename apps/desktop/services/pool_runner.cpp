// Long work on other threads, so that the window never waits.
// SPDX-License-Identifier: MIT
#include "apps/desktop/services/pool_runner.h"

#include <QMetaObject>
#include <QThread>
#include <algorithm>
#include <atomic>
#include <exception>
#include <utility>

namespace kiri::desktop {

namespace {

constexpr int kPatience = 150;  // ms before a progress bar is worth its flicker
constexpr int kLooks = 50;      // ms between two looks at how far work is

}  // namespace

struct PoolRunner::Job {
  Task task;
  std::int64_t started = 0;  ///< ms on the runner's clock
  std::atomic<bool> isCancelled = false;
  std::atomic<double> done = 0;
};

PoolRunner::PoolRunner(int threads, QObject* parent) : QObject(parent) {
  constexpr int kLeast = 2;  // a long task must not keep the preview of a short one waiting
  pool_.setMaxThreadCount(threads > 0 ? threads : std::max(kLeast, QThread::idealThreadCount()));
  clock_.start();
  timer_.setInterval(kLooks);
  connect(&timer_, &QTimer::timeout, this, &PoolRunner::look);
}

PoolRunner::~PoolRunner() {
  cancelAll();
  pool_.waitForDone();
}

TaskId PoolRunner::start(Task task) {
  const TaskId id = ++last_;
  auto job = std::make_shared<Job>();
  job->task = std::move(task);
  job->started = clock_.elapsed();
  jobs_.emplace(id, job);
  if (!job->task.what.isEmpty() && !timer_.isActive()) timer_.start();
  pool_.start([this, job, id] {
    run(*job);
    // What the work holds is let go on this thread: large states take time to go.
    job->task.work = nullptr;
    QMetaObject::invokeMethod(
        this, [this, id] { finish(id); }, Qt::QueuedConnection);
  });
  return id;
}

void PoolRunner::run(Job& job) {
  if (job.isCancelled || !job.task.work) return;
  QString defect;
  try {
    job.task.work([&job](double done) {
      job.done = done;
      return !job.isCancelled;
    });
    return;
  } catch (const std::exception& thrown) {
    defect = QString::fromUtf8(thrown.what());
  } catch (...) {
    defect = QStringLiteral("an unknown exception");
  }
  QMetaObject::invokeMethod(
      this, [this, defect] { emit defectFound(defect); }, Qt::QueuedConnection);
}

void PoolRunner::finish(TaskId task) {
  const auto found = jobs_.find(task);
  if (found == jobs_.end()) return;
  const std::shared_ptr<Job> job = found->second;
  jobs_.erase(found);
  if (busy_ && busy_->task == task) look();
  if (job->task.done) job->task.done();
}

void PoolRunner::cancel(TaskId task) {
  const auto found = jobs_.find(task);
  if (found != jobs_.end()) found->second->isCancelled = true;
}

void PoolRunner::cancelAll() {
  for (const auto& [id, job] : jobs_) job->isCancelled = true;
}

void PoolRunner::look() {
  const bool hasNamed = std::any_of(jobs_.begin(), jobs_.end(), [](const auto& entry) {
    return !entry.second->task.what.isEmpty();
  });
  const auto oldest = std::find_if(jobs_.begin(), jobs_.end(), [this](const auto& entry) {
    const Job& job = *entry.second;
    return !job.task.what.isEmpty() && clock_.elapsed() - job.started >= kPatience;
  });
  std::optional<Busy> now;
  if (oldest != jobs_.end()) {
    now = Busy{oldest->first, oldest->second->task.what,
               std::clamp(oldest->second->done.load(), 0.0, 1.0)};
  }
  if (!hasNamed) timer_.stop();
  if (now == busy_) return;
  busy_ = std::move(now);
  emit busyChanged();
}

}  // namespace kiri::desktop
