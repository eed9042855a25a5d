// Draws a step as a card: picture, number, words.
// SPDX-License-Identifier: MIT
#include "apps/desktop/panels/step_delegate.h"

#include <QPainter>
#include <QPixmap>

#include "apps/desktop/look/icons.h"
#include "apps/desktop/look/painted_words.h"
#include "apps/desktop/look/theme.h"
#include "apps/desktop/panels/steps_model.h"

namespace kiri::desktop {
namespace {

constexpr int kWidth = 104;
constexpr int kMargin = 3;
constexpr int kPadding = 6;
constexpr int kLines = 2;
constexpr int kStepSign = 16;  // of a step that does not apply

}  // namespace

QSize StepDelegate::sizeHint(const QStyleOptionViewItem& option, const QModelIndex&) const {
  const int line = option.fontMetrics.height();
  return {kWidth + 2 * kMargin, kPicture + kLines * line + 3 * kPadding + 2 * kMargin};
}

void StepDelegate::paint(QPainter* painter, const QStyleOptionViewItem& option,
                         const QModelIndex& index) const {
  const Theme& t = theme();
  const bool isCurrent = index.data(StepsModel::IsCurrentRole).toBool();
  const bool isUndone = index.data(StepsModel::IsUndoneRole).toBool();
  const QString problem = index.data(StepsModel::ProblemRole).toString();
  const bool isHovered = option.state.testFlag(QStyle::State_MouseOver);
  const bool hasFocus = option.state.testFlag(QStyle::State_HasFocus);

  painter->save();
  painter->setRenderHint(QPainter::Antialiasing);
  painter->setRenderHint(QPainter::SmoothPixmapTransform);
  const QRectF card =
      QRectF(option.rect).adjusted(kMargin + 0.5, kMargin + 0.5, -kMargin - 0.5, -kMargin - 0.5);
  painter->setPen(QPen(isCurrent || hasFocus ? t.accent : t.line, isCurrent ? 2 : 1));
  painter->setBrush(isHovered ? t.cardHover : t.card);
  painter->drawRoundedRect(card, 6, 6);

  if (isUndone) painter->setOpacity(0.4);
  const QRect box(option.rect.center().x() - kPicture / 2, static_cast<int>(card.top()) + kPadding,
                  kPicture, kPicture);
  const auto picture = index.data(StepsModel::PictureRole).value<QPixmap>();
  if (!picture.isNull()) {
    const QSize size = picture.size().scaled(box.size(), Qt::KeepAspectRatio);
    QRect place(QPoint(), size);
    place.moveCenter(box.center());
    painter->drawPixmap(place, picture);
  }
  const QRectF words = card.adjusted(kPadding, kPicture + 2 * kPadding, -kPadding, -kPadding / 2.0);
  painter->setPen(problem.isEmpty() ? (isCurrent ? t.text : t.faintText) : t.fault);
  paintWords(*painter, words, index.data().toString(), kLines);
  painter->setOpacity(1);
  if (!problem.isEmpty()) {
    const QRect sign(static_cast<int>(card.right()) - kStepSign - 4,
                     static_cast<int>(card.top()) + 4, kStepSign, kStepSign);
    icon("warning").paint(painter, sign);
  }
  painter->restore();
}

}  // namespace kiri::desktop
