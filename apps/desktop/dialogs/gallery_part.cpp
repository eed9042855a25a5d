// The examples in their groups, with a field to search them.
// SPDX-License-Identifier: MIT
#include "apps/desktop/dialogs/gallery_part.h"

#include <QHBoxLayout>
#include <QKeyEvent>
#include <QVBoxLayout>
#include <algorithm>

#include "apps/desktop/dialogs/form.h"
#include "apps/desktop/look/icons.h"

namespace kiri::desktop {

namespace {

constexpr int kSearchWidth = 260;
constexpr int kBetweenGroups = 18;

bool isSame(const ExampleGroup& a, const ExampleGroup& b) {
  return a.title == b.title && a.notes == b.notes && a.models == b.models;
}

}  // namespace

GalleryPart::GalleryPart(ModelCards& cards, QWidget* parent)
    : QWidget(parent),
      cards_(cards),
      search_(new QLineEdit),
      nothing_(remark(tr("No example has these words."))),
      groupsPart_(new QWidget) {
  search_->setPlaceholderText(tr("Search the examples"));
  search_->setAccessibleName(tr("Search the examples"));
  search_->setClearButtonEnabled(true);
  search_->addAction(icon("search"), QLineEdit::LeadingPosition);
  search_->setMaximumWidth(kSearchWidth);
  search_->installEventFilter(this);
  auto* head = new QHBoxLayout;
  head->addWidget(headline(tr("Examples")));
  head->addStretch();
  head->addWidget(search_, 1);
  auto* inside = new QVBoxLayout(groupsPart_);
  inside->setContentsMargins(0, 0, 0, 0);
  inside->setSpacing(kBetweenGroups);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(10);
  column->addLayout(head);
  column->addWidget(nothing_);
  column->addWidget(groupsPart_);
  nothing_->hide();
  connect(search_, &QLineEdit::textChanged, this, &GalleryPart::filter);
  connect(&cards, &ModelCards::changed, this, [this] {
    if (!search_->text().isEmpty()) filter();
  });
}

void GalleryPart::show(const QList<ExampleGroup>& groups) {
  const bool isKnown =
      std::equal(groups.begin(), groups.end(), groups_.begin(), groups_.end(),
                 [](const ExampleGroup& a, const Group& b) { return isSame(a, b.what); });
  if (!isKnown) {
    for (const Group& group : groups_) delete group.part;
    groups_.clear();
    for (const ExampleGroup& group : groups) add(group);
  }
  for (const Group& group : groups_) group.list->show(group.what.models);
  if (!isKnown) filter();
}

void GalleryPart::add(const ExampleGroup& what) {
  Group group{what, new QWidget, nullptr};
  const QString name = what.title.isEmpty() ? tr("Examples") : what.title;
  group.list = new CardList(cards_, name);
  auto* column = new QVBoxLayout(group.part);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(2);
  if (!what.title.isEmpty()) {
    auto* title = new QLabel(what.title);
    QFont bold = title->font();
    bold.setWeight(QFont::DemiBold);
    title->setFont(bold);
    column->addWidget(title);
  }
  if (!what.notes.isEmpty()) column->addWidget(remark(what.notes));
  column->addSpacing(4);
  column->addWidget(group.list);
  groupsPart_->layout()->addWidget(group.part);
  connectList(*group.list);
  groups_.append(group);
}

void GalleryPart::connectList(CardList& list) {
  connect(&list, &CardList::chosen, this, &GalleryPart::chosen);
  connect(&list, &CardList::looked, this, &GalleryPart::looked);
  connect(&list, &CardList::left, this,
          [this, &list](int direction, int x) { goOn(list, direction, x); });
  connect(&list, &CardList::reached, this,
          [this, &list](const QRect& card) { emit reached(&list, card); });
}

QStringList GalleryPart::paths() const {
  QStringList paths;
  for (const Group& group : groups_) paths += group.what.models;
  return paths;
}

QList<CardList*> GalleryPart::lists() const {
  QList<CardList*> lists;
  for (const Group& group : groups_) lists << group.list;
  return lists;
}

void GalleryPart::filter() {
  bool isSome = groups_.isEmpty();
  for (const Group& group : groups_) {
    const bool isShown = group.list->filter(search_->text(), group.what.title);
    group.part->setVisible(isShown);
    isSome = isSome || isShown;
  }
  nothing_->setVisible(!isSome);
}

void GalleryPart::goOn(const CardList& from, int direction, int x) {
  QList<CardList*> shown;
  for (const Group& group : groups_) {
    if (!group.part->isHidden()) shown << group.list;
  }
  const auto at = std::find(shown.begin(), shown.end(), &from);
  const qsizetype next = (at - shown.begin()) + direction;
  if (next >= 0 && next < shown.size()) return shown[next]->enter(direction > 0, x);
  if (next < 0) search_->setFocus(Qt::TabFocusReason);
}

/// From the field down to the cards; Esc empties the field before it leaves the page.
bool GalleryPart::eventFilter(QObject* watched, QEvent* event) {
  if (watched != search_ || event->type() != QEvent::KeyPress)
    return QWidget::eventFilter(watched, event);
  const int key = static_cast<QKeyEvent*>(event)->key();
  if (key == Qt::Key_Escape && !search_->text().isEmpty()) {
    search_->clear();
    return true;
  }
  const bool isDown = key == Qt::Key_Down || key == Qt::Key_Return || key == Qt::Key_Enter;
  if (!isDown) return QWidget::eventFilter(watched, event);
  for (const Group& group : groups_) {
    if (group.part->isHidden()) continue;
    group.list->enter(true, 0);
    break;
  }
  return true;
}

}  // namespace kiri::desktop
