// Draws a step as a card: picture, number, words.
// SPDX-License-Identifier: MIT
#pragma once

#include <QStyledItemDelegate>

namespace kiri::desktop {

class StepDelegate final : public QStyledItemDelegate {
  Q_OBJECT
 public:
  using QStyledItemDelegate::QStyledItemDelegate;
  static constexpr int kPicture = 64;  ///< pixels on a side

  void paint(QPainter* painter, const QStyleOptionViewItem& option,
             const QModelIndex& index) const override;
  QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override;
};

}  // namespace kiri::desktop
