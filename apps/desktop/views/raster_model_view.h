// The pane with the folded model where there is no graphics card: pictures made by the program.
// SPDX-License-Identifier: MIT
#pragma once

#include <QImage>
#include <QWidget>

#include "apps/desktop/services/session_hub.h"
#include "apps/desktop/views/appearance_store.h"
#include "apps/desktop/views/pane_input.h"
#include "editor/base/task.h"

namespace kiri::desktop {

/// The same picture as that of GlModelView, a little later: it is made beside the window, and until
/// it is ready the last one is shown.
class RasterModelView final : public QWidget {
  Q_OBJECT
 public:
  RasterModelView(SessionHub& hub, AppearanceStore& look, QWidget* parent = nullptr);
  PaneInput& input() { return *input_; }
  /// A sentence at the foot of the pane: why it is slow.
  void setNotice(const QString& notice);

 protected:
  bool event(QEvent* event) override;
  void paintEvent(QPaintEvent* event) override;

 private:
  void refresh();

  SessionHub& hub_;
  AppearanceStore& look_;
  PaneInput* input_;
  QImage picture_;
  QString notice_;
  LatestTask task_;
};

}  // namespace kiri::desktop
