// The numbers and choices of the step that is shown, to be changed.
// SPDX-License-Identifier: MIT
#pragma once

#include <QScrollArea>
#include <optional>

#include "apps/desktop/panels/field_editor.h"
#include "apps/desktop/services/session_hub.h"

class QLabel;
class QPushButton;

namespace kiri::desktop {

/// Follows the cursor of the history; what is typed replays the model beside the window.
class StepPanel final : public QScrollArea {
  Q_OBJECT
 public:
  explicit StepPanel(SessionHub& hub, QWidget* parent = nullptr);
  /// Shows step `index`, from 0, even when the model stands at another, until the cursor moves.
  void showStep(std::size_t index);
  FieldEditor& editor() { return *editor_; }
  QSize sizeHint() const override { return {270, 260}; }

 signals:
  void removeWanted(int index);

 private:
  void refresh();
  void edit(const std::string& id, const FieldValue& value);
  std::optional<std::size_t> chosen() const;

  SessionHub& hub_;
  std::optional<std::size_t> wanted_;
  std::size_t cursor_ = 0;
  QLabel* title_;
  QLabel* summary_;
  QLabel* problem_;
  QLabel* empty_;
  FieldEditor* editor_;
  QPushButton* remove_;
};

}  // namespace kiri::desktop
