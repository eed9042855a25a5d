// Models to choose from, as cards side by side.
// SPDX-License-Identifier: MIT
#include "apps/desktop/dialogs/card_list.h"

#include <QKeyEvent>
#include <QPixmap>
#include <algorithm>
#include <cstdlib>
#include <utility>

#include "apps/desktop/dialogs/card_delegate.h"

namespace kiri::desktop {

namespace {

bool holdsAll(const QString& text, const QString& wanted) {
  const QStringList words = wanted.split(' ', Qt::SkipEmptyParts);
  return std::all_of(words.begin(), words.end(), [&text](const QString& word) {
    return text.contains(word, Qt::CaseInsensitive);
  });
}

}  // namespace

CardList::CardList(ModelCards& cards, const QString& name, QWidget* parent)
    : QListWidget(parent), cards_(cards) {
  setAccessibleName(name);
  setItemDelegate(new CardDelegate(this));
  setViewMode(QListView::IconMode);
  setMovement(QListView::Static);
  setResizeMode(QListView::Adjust);
  setUniformItemSizes(true);
  setMouseTracking(true);
  setFrameShape(QFrame::NoFrame);
  setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  viewport()->setAutoFillBackground(false);
  setGridSize(CardDelegate::sizeFor(fontMetrics()));
  QSizePolicy policy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  policy.setHeightForWidth(true);
  setSizePolicy(policy);
  // One click is enough, as with all buttons of the page; keys work as in any list.
  connect(this, &QListWidget::itemClicked, this, &QListWidget::itemActivated);
  connect(this, &QListWidget::itemActivated, this, [this](const QListWidgetItem* item) {
    emit chosen(item->data(CardDelegate::PathRole).toString());
  });
  connect(this, &QListWidget::itemEntered, this, [this](const QListWidgetItem* item) {
    emit looked(item->data(CardDelegate::PathRole).toString());
  });
  connect(this, &QListWidget::currentItemChanged, this, &CardList::tell);
  connect(&cards, &ModelCards::changed, this, &CardList::fill);
}

QStringList CardList::paths() const {
  QStringList paths;
  for (int i = 0; i < count(); ++i) paths << item(i)->data(CardDelegate::PathRole).toString();
  return paths;
}

void CardList::show(const QStringList& wanted) {
  if (paths() != wanted) {
    clear();
    for (const QString& path : wanted) {
      auto* item = new QListWidgetItem(this);
      item->setData(CardDelegate::PathRole, path);
    }
  }
  for (const QString& path : wanted) fill(path);
  fit();
}

void CardList::fill(const QString& path) {
  for (int i = 0; i < count(); ++i) {
    QListWidgetItem& shown = *item(i);
    if (shown.data(CardDelegate::PathRole).toString() != path) continue;
    const ModelCard card = cards_.card(path);
    shown.setText(card.title);
    shown.setData(CardDelegate::FigureRole, card.figure);
    const QString tip = card.notes.isEmpty() ? path : card.notes;
    shown.setToolTip("<p>" + tip.toHtmlEscaped() + "</p>");  // in lines
    shown.setData(Qt::AccessibleDescriptionRole, card.figure);
    if (!card.picture.isNull()) shown.setData(Qt::DecorationRole, QPixmap::fromImage(card.picture));
  }
}

bool CardList::filter(const QString& wanted, const QString& context) {
  bool isSome = false;
  for (int i = 0; i < count(); ++i) {
    const ModelCard card = cards_.card(item(i)->data(CardDelegate::PathRole).toString());
    const QString text = card.title + "\n" + card.figure + "\n" + card.notes + "\n" + context;
    const bool isShown = holdsAll(text, wanted);
    item(i)->setHidden(!isShown);
    isSome = isSome || isShown;
  }
  fit();
  return isSome;
}

QList<QListWidgetItem*> CardList::shownItems() const {
  QList<QListWidgetItem*> items;
  for (int i = 0; i < count(); ++i) {
    if (!item(i)->isHidden()) items << item(i);
  }
  return items;
}

int CardList::shownCount() const { return static_cast<int>(shownItems().size()); }

int CardList::heightForWidth(int width) const {
  const QSize card = gridSize();
  const int columns = std::max(1, width / card.width());
  const int rows = (shownCount() + columns - 1) / columns;
  return rows * card.height() + (rows > 0 ? 4 : 0);
}

void CardList::fit() {
  const int height = heightForWidth(width());
  if (minimumHeight() != height || maximumHeight() != height) setFixedHeight(height);
}

void CardList::resizeEvent(QResizeEvent* event) {
  QListWidget::resizeEvent(event);
  fit();
}

void CardList::changeEvent(QEvent* event) {
  QListWidget::changeEvent(event);
  if (event->type() != QEvent::FontChange && event->type() != QEvent::StyleChange) return;
  setGridSize(CardDelegate::sizeFor(fontMetrics()));
  fit();
}

bool CardList::viewportEvent(QEvent* event) {
  if (event->type() == QEvent::ToolTip && !hasTips_) return true;
  return QListWidget::viewportEvent(event);
}

void CardList::enter(bool fromAbove, int x) {
  QListWidgetItem* best = nullptr;
  for (QListWidgetItem* item : shownItems()) {
    if (best == nullptr) best = item;
    const QRect here = visualItemRect(item);
    const QRect there = visualItemRect(best);
    const bool isNearerRow = fromAbove ? here.top() < there.top() : here.top() > there.top();
    const bool isSameRow = here.top() == there.top();
    const bool isNearerColumn = std::abs(here.center().x() - x) < std::abs(there.center().x() - x);
    if (isNearerRow || (isSameRow && isNearerColumn)) best = item;
  }
  if (best != nullptr) setCurrentItem(best);
  setFocus(Qt::TabFocusReason);
}

/// The card of a neighbouring row, the nearest to `x`; none where that was the last row.
QListWidgetItem* CardList::inRow(int direction, int x) const {
  const int from = visualItemRect(currentItem()).top();
  QListWidgetItem* best = nullptr;
  const auto away = [&](const QListWidgetItem* item) {
    const QRect place = visualItemRect(item);
    return std::pair(std::abs(place.top() - from), std::abs(place.center().x() - x));
  };
  for (QListWidgetItem* item : shownItems()) {
    const int down = visualItemRect(item).top() - from;
    const bool isThere = direction < 0 ? down < 0 : down > 0;
    if (isThere && (best == nullptr || away(item) < away(best))) best = item;
  }
  return best;
}

QListWidgetItem* CardList::beside(int direction) const {
  const QList<QListWidgetItem*> shown = shownItems();
  const qsizetype next = shown.indexOf(currentItem()) + direction;
  return next >= 0 && next < shown.size() ? shown[next] : nullptr;
}

/// Left and right go through all cards, up and down to the nearest card of the next row, and on
/// into the lists around.
void CardList::keyPressEvent(QKeyEvent* event) {
  const int key = event->key();
  const bool isSideways = key == Qt::Key_Left || key == Qt::Key_Right;
  const bool isArrow = isSideways || key == Qt::Key_Up || key == Qt::Key_Down;
  if (!isArrow || currentItem() == nullptr) return QListWidget::keyPressEvent(event);
  const int direction = key == Qt::Key_Left || key == Qt::Key_Up ? -1 : 1;
  const int here = visualItemRect(currentItem()).center().x();
  QListWidgetItem* next = isSideways ? beside(direction) : inRow(direction, here);
  if (next != nullptr) return setCurrentItem(next);
  emit left(direction, isSideways ? (direction > 0 ? 0 : width()) : here);
}

void CardList::focusInEvent(QFocusEvent* event) {
  QListWidget::focusInEvent(event);
  if (event->reason() == Qt::MouseFocusReason) return;
  if (currentItem() == nullptr || currentItem()->isHidden()) {
    const QList<QListWidgetItem*> shown = shownItems();
    if (!shown.isEmpty()) setCurrentItem(shown.front());
  }
  tell();
}

/// What the keyboard is at.
void CardList::tell() {
  if (currentItem() == nullptr || !hasFocus()) return;
  emit looked(pointedAt());
  emit reached(visualItemRect(currentItem()));
}

QString CardList::pointedAt() const {
  return currentItem() ? currentItem()->data(CardDelegate::PathRole).toString() : QString();
}

}  // namespace kiri::desktop
