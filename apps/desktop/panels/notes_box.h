// A box for text of several lines that tells when its text has been changed.
// SPDX-License-Identifier: MIT
#pragma once

#include <QPlainTextEdit>

namespace kiri::desktop {

/// As high as some lines; what is typed counts when the box loses the focus, or with Ctrl+Enter.
class NotesBox final : public QPlainTextEdit {
  Q_OBJECT
 public:
  explicit NotesBox(QWidget* parent = nullptr);
  /// What is being typed is not taken out of the person's hands.
  void show(const QString& text);
  QSize sizeHint() const override;

 signals:
  void edited(const QString& text);

 protected:
  void focusOutEvent(QFocusEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  void tell();
};

}  // namespace kiri::desktop
