// The card of the tour: what to do now, and the ghost of the hand that shows it.
// SPDX-License-Identifier: MIT
#pragma once

#include <QElapsedTimer>
#include <QFrame>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QTimer>

#include "apps/desktop/services/session_hub.h"
#include "editor/session/tour.h"

namespace kiri::desktop {

/// Floats over the lower right corner of its parent (both panes), where the least of the paper is
/// covered; hidden until the tour begins.
///
///   TourCard* card = new TourCard(hub, panes);
///   tour action, StartPage::tourWanted:
///     files.whenSafe([&] { files.openModel(Tour::startModel()); card->begin(); });
class TourCard final : public QFrame {
  Q_OBJECT
 public:
  TourCard(SessionHub& hub, QWidget* parent);
  ~TourCard() override;

  /// From the first step; the sheet of the tour is being opened.
  void begin();
  void end();
  bool isOn() const { return isOn_; }
  const Tour& tour() const { return tour_; }

 signals:
  void ended();

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
  void changeEvent(QEvent* event) override;

 private:
  void look();
  void say();
  void moveHand();
  void place();

  SessionHub& hub_;
  Tour tour_;
  bool isOn_ = false;
  QTimer timer_;
  QElapsedTimer clock_;
  QLabel* number_ = nullptr;
  QLabel* title_ = nullptr;
  QLabel* text_ = nullptr;
  QProgressBar* bar_ = nullptr;
  QPushButton* close_ = nullptr;
};

}  // namespace kiri::desktop
