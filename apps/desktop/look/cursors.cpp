// The pointers of the hand.
// SPDX-License-Identifier: MIT
#include "apps/desktop/look/cursors.h"

#include <QPainter>
#include <QPixmap>
#include <QVariant>
#include <QWidget>

#include "apps/desktop/look/icons.h"

namespace kiri::desktop {
namespace {

/// The cross of the system's hand with the tool's icon beside it, so that the point stays exact.
QCursor crossWith(const QString& name) {
  constexpr int kSize = 32;
  constexpr int kMiddle = 8;
  QPixmap pixmap(kSize, kSize);
  pixmap.fill(Qt::transparent);
  QPainter painter(&pixmap);
  for (const auto& [color, width] : {std::pair(QColor(Qt::white), 3), {QColor(Qt::black), 1}}) {
    painter.setPen(QPen(color, width));
    painter.drawLine(kMiddle, 1, kMiddle, kMiddle - 3);
    painter.drawLine(kMiddle, kMiddle + 3, kMiddle, 2 * kMiddle - 1);
    painter.drawLine(1, kMiddle, kMiddle - 3, kMiddle);
    painter.drawLine(kMiddle + 3, kMiddle, 2 * kMiddle - 1, kMiddle);
  }
  icon(name).paint(&painter, QRect(13, 13, 18, 18));
  painter.end();
  return QCursor(pixmap, kMiddle, kMiddle);
}

QCursor makeCursor(CursorShape shape) {
  switch (shape) {
    case CursorShape::Arrow:
      return Qt::ArrowCursor;
    case CursorShape::Cross:
      return Qt::CrossCursor;
    case CursorShape::Hand:
      return Qt::OpenHandCursor;
    case CursorShape::ClosedHand:
      return Qt::ClosedHandCursor;
    case CursorShape::Scissors:
      return crossWith("straight-cut");
    case CursorShape::Tear:
      return crossWith("tear");
    case CursorShape::Pen:
      return crossWith("line");
    case CursorShape::Forbidden:
      return Qt::ForbiddenCursor;
    case CursorShape::Orbit:
      return Qt::SizeAllCursor;
  }
  return Qt::ArrowCursor;
}

}  // namespace

void showCursor(QWidget& widget, CursorShape shape) {
  // The same hundred times a second while the hand moves: only a change costs anything.
  const QVariant number = static_cast<int>(shape);
  if (widget.property("kiriCursor") == number) return;
  widget.setProperty("kiriCursor", number);
  widget.setCursor(makeCursor(shape));
}

}  // namespace kiri::desktop
