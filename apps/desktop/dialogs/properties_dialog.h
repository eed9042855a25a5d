// Title and notes of the model.
// SPDX-License-Identifier: MIT
#pragma once

#include <QDialog>
#include <QLineEdit>
#include <QPlainTextEdit>

namespace kiri::desktop {

/// Accepted: `title()` and `notes()`, for setTitle of editor/document.
class PropertiesDialog final : public QDialog {
  Q_OBJECT
 public:
  PropertiesDialog(const QString& title, const QString& notes, QWidget* parent = nullptr);

  QString title() const { return title_->text(); }
  QString notes() const { return notes_->toPlainText(); }

 private:
  QLineEdit* title_ = nullptr;
  QPlainTextEdit* notes_ = nullptr;
};

}  // namespace kiri::desktop
