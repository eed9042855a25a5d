// Draws a model of a gallery as a card: picture, title, figure.
// SPDX-License-Identifier: MIT
#include "apps/desktop/dialogs/card_delegate.h"

#include <QPainter>
#include <QPixmap>

#include "apps/desktop/look/painted_words.h"
#include "apps/desktop/look/theme.h"

namespace kiri::desktop {

namespace {

constexpr int kCardMargin = 3;
constexpr int kPadding = 9;
constexpr int kTitleLines = 2;

}  // namespace

QSize CardDelegate::sizeFor(const QFontMetrics& metrics) {
  const int words = (kTitleLines + 1) * metrics.lineSpacing();
  return {kPicture + 2 * (kPadding + kCardMargin),
          kPicture + words + 3 * kPadding + 2 * kCardMargin};
}

QSize CardDelegate::sizeHint(const QStyleOptionViewItem& option, const QModelIndex&) const {
  return sizeFor(option.fontMetrics);
}

void CardDelegate::paint(QPainter* painter, const QStyleOptionViewItem& option,
                         const QModelIndex& index) const {
  const Theme& t = theme();
  const bool isHovered = option.state.testFlag(QStyle::State_MouseOver);
  const bool hasFocus = option.state.testFlag(QStyle::State_HasFocus);
  painter->save();
  painter->setRenderHint(QPainter::Antialiasing);
  painter->setRenderHint(QPainter::SmoothPixmapTransform);
  const QRectF card =
      QRectF(option.rect)
          .adjusted(kCardMargin + 0.5, kCardMargin + 0.5, -kCardMargin - 0.5, -kCardMargin - 0.5);
  if (isHovered || hasFocus) {
    painter->setPen(QPen(hasFocus ? t.accent : t.line, hasFocus ? 2 : 1));
    painter->setBrush(t.cardHover);
    painter->drawRoundedRect(card, 6, 6);
  }
  const QRect box(option.rect.center().x() - kPicture / 2, static_cast<int>(card.top()) + kPadding,
                  kPicture, kPicture);
  const auto picture = index.data(Qt::DecorationRole).value<QPixmap>();
  if (!picture.isNull()) {
    QRect place(QPoint(), picture.size().scaled(box.size(), Qt::KeepAspectRatio));
    place.moveCenter(box.center());
    painter->drawPixmap(place, picture);
  }
  painter->setFont(option.font);
  QRectF words = card.adjusted(kPadding / 2.0, 0, -kPadding / 2.0, 0);
  words.setTop(box.bottom() + kPadding);
  painter->setPen(t.text);
  const double used = paintWords(*painter, words, index.data().toString(), kTitleLines);
  painter->setPen(t.faintText);
  words.setTop(words.top() + used);
  paintWords(*painter, words, index.data(FigureRole).toString(), 1);
  painter->restore();
}

}  // namespace kiri::desktop
