// Words in a narrow box, as on cards.
// SPDX-License-Identifier: MIT
#include "apps/desktop/look/painted_words.h"

#include <QTextLayout>

namespace kiri::desktop {

double paintWords(QPainter& painter, const QRectF& box, const QString& text, int lines) {
  QTextLayout layout(text, painter.font());
  QTextOption option(Qt::AlignHCenter);
  option.setWrapMode(QTextOption::WrapAtWordBoundaryOrAnywhere);
  layout.setTextOption(option);
  layout.beginLayout();
  const QFontMetricsF metrics(painter.font());
  double y = 0;
  for (int row = 0; row < lines; ++row) {
    QTextLine line = layout.createLine();
    if (!line.isValid()) break;
    line.setLineWidth(box.width());
    const bool isLast = row == lines - 1;
    QString words = text.mid(line.textStart(), isLast ? -1 : line.textLength()).trimmed();
    words = metrics.elidedText(words, Qt::ElideRight, box.width());
    painter.drawText(QRectF(box.left(), box.top() + y, box.width(), line.height()),
                     Qt::AlignHCenter | Qt::AlignVCenter, words);
    y += line.height();
  }
  layout.endLayout();
  return y;
}

}  // namespace kiri::desktop
