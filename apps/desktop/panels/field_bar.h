// The bar above the panes: which tool is at work, its numbers and choices, do it or drop it.
// SPDX-License-Identifier: MIT
#pragma once

#include <QFrame>

#include "apps/desktop/panels/field_editor.h"
#include "apps/desktop/services/session_hub.h"

class QAction;
class QLabel;
class QToolButton;
class QScrollArea;

namespace kiri::desktop {

/// Always there and always as high, so that nothing jumps when the hand begins to draw.
class FieldBar final : public QFrame {
  Q_OBJECT
 public:
  /// `commit` and `cancel`: the actions of Enter and Esc.
  FieldBar(SessionHub& hub, QAction& commit, QAction& cancel, QWidget* parent = nullptr);
  /// The action of the tool at work: its icon and name stand at the left.
  void setTool(const QAction& tool);
  FieldEditor& editor() { return *editor_; }

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  void refresh();
  void fit();
  void showMore();
  void tell(const QString& id, const FieldValue& value);

  SessionHub& hub_;
  QLabel* picture_;
  QLabel* name_;
  QScrollArea* room_;
  FieldEditor* editor_;
  QToolButton* more_;
  FieldEditor* rest_;  ///< what the bar has no room for, in a window of its own
  QToolButton* commit_;
  QToolButton* cancel_;
};

}  // namespace kiri::desktop
