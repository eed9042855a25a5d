// The pane with the folded model, whatever draws it.
// SPDX-License-Identifier: MIT
#pragma once

#include <QWidget>

#include "apps/desktop/services/session_hub.h"
#include "apps/desktop/views/appearance_store.h"

class QStackedLayout;

namespace kiri::desktop {

/// Draws with OpenGL, and where that is not to be had with pictures made by the program, with a
/// sentence that says so. Everything else works the same.
class ModelView final : public QWidget {
  Q_OBJECT
 public:
  enum class Drawing { Automatic, Software };
  ModelView(SessionHub& hub, AppearanceStore& look, Drawing drawing = Drawing::Automatic,
            QWidget* parent = nullptr);

  /// The widget that takes the events of the hand.
  QWidget* surface() const;
  bool usesGl() const;
  /// What draws, for the about box.
  QString description() const;
  QSize minimumSizeHint() const override { return {160, 160}; }
  QSize sizeHint() const override { return {760, 560}; }

 private:
  void useSoftware(const QString& why);
  void adopt(QWidget* view);

  SessionHub& hub_;
  AppearanceStore& look_;
  QStackedLayout* layout_;
};

}  // namespace kiri::desktop
