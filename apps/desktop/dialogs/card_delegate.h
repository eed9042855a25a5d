// Draws a model of a gallery as a card: picture, title, figure.
// SPDX-License-Identifier: MIT
#pragma once

#include <QStyledItemDelegate>

namespace kiri::desktop {

/// Of the item it reads Qt::DisplayRole (title), Qt::DecorationRole (QPixmap) and FigureRole.
class CardDelegate final : public QStyledItemDelegate {
 public:
  enum Role { PathRole = Qt::UserRole, FigureRole };
  static constexpr int kPicture = 132;  ///< pixels of the toolkit on a side
  using QStyledItemDelegate::QStyledItemDelegate;

  /// Of every card.
  static QSize sizeFor(const QFontMetrics& metrics);
  QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override;
  void paint(QPainter* painter, const QStyleOptionViewItem& option,
             const QModelIndex& index) const override;
};

}  // namespace kiri::desktop
