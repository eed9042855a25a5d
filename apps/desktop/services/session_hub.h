// The open session, and Qt signals for what changes in it.
// SPDX-License-Identifier: MIT
#pragma once

#include <QObject>
#include <memory>

#include "editor/session/session.h"

namespace kiri::desktop {

/// Owns the session and tells any number of listeners what has changed. Changes are gathered and
/// told once when the window is idle again, so a hundred events of the mouse cost one update.
class SessionHub final : public QObject {
  Q_OBJECT
 public:
  explicit SessionHub(TaskRunner& runner, QObject* parent = nullptr);
  ~SessionHub() override;

  Session& session() { return *session_; }
  const Session& session() const { return *session_; }
  TaskRunner& runner() { return runner_; }
  /// Tells at once what has been gathered.
  void flush();

 signals:
  /// Before the signals below, with all that has changed.
  void changed(const kiri::Changed& what);
  void documentChanged();
  void shownChanged();
  void marksChanged();
  void viewChanged();
  void toolChanged();
  void busyChanged();
  void patternChanged();
  void selectionChanged();

 private:
  void note(const Changed& what);

  TaskRunner& runner_;
  Changed gathered_;
  bool isWaiting_ = false;
  std::unique_ptr<Session> session_;
};

}  // namespace kiri::desktop
