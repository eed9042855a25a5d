// How far work beside the window is, at the foot of the dialog that asked for it.
// SPDX-License-Identifier: MIT
#pragma once

#include <QLabel>
#include <QProgressBar>
#include <QTimer>
#include <QWidget>
#include <functional>
#include <memory>

#include "editor/base/task.h"

namespace kiri::desktop {

/// A bar with a sentence. One piece of work at a time; when the bar goes, its work is asked to stop
/// and is not reported.
class WorkBar final : public QWidget {
  Q_OBJECT
 public:
  explicit WorkBar(TaskRunner& runner, QWidget* parent = nullptr);
  ~WorkBar() override;

  /// `work` runs beside the window; `done` is called on the window's thread, also when the work was
  /// stopped. Requires that nothing is under way.
  void start(const QString& what, std::function<void(const Progress&)> work,
             std::function<void()> done);
  void stop();
  bool isBusy() const { return state_ != nullptr; }
  /// What came of it, until the next start.
  void say(const QString& sentence, bool isFault = false);
  QString said() const { return label_->text(); }

 signals:
  void busyChanged(bool isBusy);

 private:
  struct State;
  TaskRunner& runner_;
  QLabel* label_;
  QProgressBar* bar_;
  QTimer timer_;
  std::shared_ptr<State> state_;
};

}  // namespace kiri::desktop
