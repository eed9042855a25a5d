// The sliders of the fold lines, and the one for all of them.
// SPDX-License-Identifier: MIT
#pragma once

#include <QWidget>

#include "apps/desktop/services/session_hub.h"

class QLabel;
class QSlider;
class QToolButton;

namespace kiri::desktop {

class FoldRows;

/// Live: the paper follows the slider, stops where it would stretch and says why; a collision is
/// told and does not block. Letting go makes one step.
class FoldsPanel final : public QWidget {
  Q_OBJECT
 public:
  explicit FoldsPanel(SessionHub& hub, QWidget* parent = nullptr);
  FoldRows& rows() { return *rows_; }
  QSlider& all() { return *all_; }
  QSize sizeHint() const override { return {270, 320}; }

 private:
  QWidget* makeHead();
  void refresh();
  void showSlide();
  void say(const QString& text, bool isFault);
  void setLeaf(bool isLeaf);

  SessionHub& hub_;
  QToolButton* together_;
  QToolButton* inOrder_;
  QSlider* all_;
  QLabel* said_;
  QLabel* empty_;
  FoldRows* rows_;
  bool isUpdating_ = false;
};

}  // namespace kiri::desktop
