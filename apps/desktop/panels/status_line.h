// The foot of the window: what to do next, what just happened, what lies there.
// SPDX-License-Identifier: MIT
#pragma once

#include <QStatusBar>
#include <QTimer>

#include "apps/desktop/services/pool_runner.h"
#include "apps/desktop/services/session_hub.h"

class QLabel;
class QProgressBar;
class QToolButton;

namespace kiri::desktop {

class StatusLine final : public QStatusBar {
  Q_OBJECT
 public:
  /// `runner`: whose long work is shown, with a button that stops it; none: no long work.
  StatusLine(SessionHub& hub, PoolRunner* runner, QWidget* parent = nullptr);
  QString hint() const;
  QString facts() const;
  /// A sentence of the window itself, shown like those of the session.
  void say(Notice::Kind kind, const QString& text);
  /// What to do where no model is seen, such as the start page: said instead of the session's hint
  /// and facts. Empty: the model is seen again.
  void setElsewhere(const QString& hint);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void fit();
  void refresh();
  void refreshBusy();
  void showFacts();

  SessionHub& hub_;
  PoolRunner* runner_;
  QLabel* sign_;
  QLabel* hint_;
  QLabel* facts_;
  QLabel* what_;
  QProgressBar* progress_;
  QToolButton* cancel_;
  QTimer fade_;
  Phrase lastNotice_;
  std::string lastWhy_;
  QString elsewhere_;
  QString said_;  ///< the whole sentence; in a small window its end may not be seen
  bool isNoticeShown_ = false;
};

}  // namespace kiri::desktop
