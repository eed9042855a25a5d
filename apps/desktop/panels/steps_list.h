// The history as a row of cards.
// SPDX-License-Identifier: MIT
#pragma once

#include <QListView>

#include "apps/desktop/services/session_hub.h"

namespace kiri::desktop {

class StepsModel;

/// A click shows the model after that step; a double click asks to change the step's numbers.
class StepsList final : public QListView {
  Q_OBJECT
 public:
  explicit StepsList(SessionHub& hub, QWidget* parent = nullptr);
  QSize sizeHint() const override;
  QSize minimumSizeHint() const override;

 signals:
  /// Step `index`, from 0, is to be changed.
  void editWanted(int index);
  void removeWanted(int index);

 protected:
  void contextMenuEvent(QContextMenuEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  bool event(QEvent* event) override;

 private:
  void follow();
  void jump(const QModelIndex& index);

  SessionHub& hub_;
  StepsModel* steps_;
};

}  // namespace kiri::desktop
