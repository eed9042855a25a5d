// Play, pause, scrub: the whole process in time.
// SPDX-License-Identifier: MIT
#pragma once

#include <QElapsedTimer>
#include <QFrame>
#include <QTimer>

#include "apps/desktop/services/session_hub.h"

class QComboBox;
class QLabel;
class QSlider;
class QToolButton;

namespace kiri::desktop {

class PlayerBar final : public QFrame {
  Q_OBJECT
 public:
  explicit PlayerBar(SessionHub& hub, QWidget* parent = nullptr);

  void togglePlay();
  void stop();
  void skip(int steps);
  void setLoops(bool loops);
  /// +1: the next faster of the speeds, -1: the next slower.
  void changeSpeed(int by);
  bool isPlaying() const;
  QSlider& slider() { return *slider_; }

 signals:
  void loopsChanged(bool loops);

 private:
  void tick();
  void refresh();
  void play();
  void whenOpened();
  void scrub(int ticks);

  SessionHub& hub_;
  QToolButton* play_;
  QToolButton* loop_;
  QToolButton* close_;
  QSlider* slider_;
  QComboBox* speed_;
  QLabel* place_;
  QTimer timer_;
  QElapsedTimer clock_;
  bool wasOpen_ = false;
  bool isHeldAtOpening_ = false;  ///< the film was opened to look at a moment, not to play
  bool isUpdating_ = false;
};

}  // namespace kiri::desktop
