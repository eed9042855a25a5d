// A box for text of several lines that tells when its text has been changed.
// SPDX-License-Identifier: MIT
#include "apps/desktop/panels/notes_box.h"

#include <QKeyEvent>
#include <QScrollBar>
#include <QTextDocument>

namespace kiri::desktop {
namespace {

constexpr int kNoteLines = 5;

}  // namespace

NotesBox::NotesBox(QWidget* parent) : QPlainTextEdit(parent) {
  setTabChangesFocus(true);
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
}

void NotesBox::show(const QString& text) {
  if (toPlainText() == text || (hasFocus() && document()->isModified())) return;
  setPlainText(text);
  document()->setModified(false);
}

QSize NotesBox::sizeHint() const {
  const int rim = 2 * frameWidth() + static_cast<int>(2 * document()->documentMargin());
  return {120, kNoteLines * fontMetrics().lineSpacing() + rim};
}

void NotesBox::focusOutEvent(QFocusEvent* event) {
  QPlainTextEdit::focusOutEvent(event);
  tell();
}

void NotesBox::keyPressEvent(QKeyEvent* event) {
  const bool isEnter = event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter;
  if (!isEnter || !event->modifiers().testFlag(Qt::ControlModifier)) {
    return QPlainTextEdit::keyPressEvent(event);
  }
  tell();
}

void NotesBox::tell() {
  if (!document()->isModified()) return;
  document()->setModified(false);
  emit edited(toPlainText());
}

}  // namespace kiri::desktop
