// Models to choose from, as cards side by side.
// SPDX-License-Identifier: MIT
#pragma once

#include <QListWidget>

#include "apps/desktop/services/model_cards.h"

namespace kiri::desktop {

/// As high as what it shows: the page around it scrolls, not the list.
class CardList final : public QListWidget {
  Q_OBJECT
 public:
  CardList(ModelCards& cards, const QString& name, QWidget* parent = nullptr);

  void show(const QStringList& paths);
  QStringList paths() const;
  /// Hides the cards whose words do not hold all words of `wanted`; true when some are left.
  /// `context`: what else counts as words of every card.
  bool filter(const QString& wanted, const QString& context = {});
  /// Takes the keyboard at the first or last row, in the column of that place.
  void enter(bool fromAbove, int x);
  /// The path of the card under the keyboard or the pointer; empty: none.
  QString pointedAt() const;
  /// Notes beside the pointer; not where they are shown elsewhere.
  void setTips(bool hasTips) { hasTips_ = hasTips; }
  int heightForWidth(int width) const override;
  bool hasHeightForWidth() const override { return true; }

 signals:
  void chosen(const QString& path);
  /// A card is under the pointer or the keyboard.
  void looked(const QString& path);
  /// The keyboard is at a card.
  void reached(const QRect& card);
  /// The keyboard leaves upwards (-1) or downwards (1), at that place.
  void left(int direction, int x);

 protected:
  void keyPressEvent(QKeyEvent* event) override;
  void focusInEvent(QFocusEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void changeEvent(QEvent* event) override;
  bool viewportEvent(QEvent* event) override;

 private:
  void fill(const QString& path);
  void fit();
  void tell();
  QListWidgetItem* inRow(int direction, int x) const;
  QListWidgetItem* beside(int direction) const;
  int shownCount() const;
  QList<QListWidgetItem*> shownItems() const;

  ModelCards& cards_;
  bool hasTips_ = true;
};

}  // namespace kiri::desktop
