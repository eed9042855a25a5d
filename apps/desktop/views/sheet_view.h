// The pane with the flat sheet.
// SPDX-License-Identifier: MIT
#pragma once

#include <QPixmap>
#include <QWidget>

#include "apps/desktop/services/session_hub.h"
#include "apps/desktop/views/appearance_store.h"
#include "apps/desktop/views/pane_input.h"

namespace kiri::desktop {

/// Shows what the session shows, as it lies on the sheet at rest. The paper is painted once for
/// each state and eye; what changes with every movement of the hand is painted over it.
class SheetView final : public QWidget {
  Q_OBJECT
 public:
  SheetView(SessionHub& hub, AppearanceStore& look, QWidget* parent = nullptr);
  PaneInput& input() { return *input_; }
  QSize minimumSizeHint() const override { return {120, 120}; }
  QSize sizeHint() const override { return {420, 560}; }

 protected:
  bool event(QEvent* event) override;
  void paintEvent(QPaintEvent* event) override;

 private:
  void forget();
  void paintPaper(const Shown& shown, const PaneMap& map);

  SessionHub& hub_;
  AppearanceStore& look_;
  PaneInput* input_;
  QPixmap paper_;  ///< null: to be painted anew
};

}  // namespace kiri::desktop
