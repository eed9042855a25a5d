// The history as a row of cards.
// SPDX-License-Identifier: MIT
#include "apps/desktop/panels/steps_list.h"

#include <QContextMenuEvent>
#include <QKeyEvent>
#include <QMenu>
#include <QScrollBar>
#include <QWheelEvent>
#include <cmath>

#include "apps/desktop/panels/step_delegate.h"
#include "apps/desktop/panels/steps_model.h"

namespace kiri::desktop {

StepsList::StepsList(SessionHub& hub, QWidget* parent)
    : QListView(parent), hub_(hub), steps_(new StepsModel(hub, this)) {
  setObjectName("steps");
  setAccessibleName(tr("Steps"));
  setModel(steps_);
  setItemDelegate(new StepDelegate(this));
  setFlow(QListView::LeftToRight);
  setWrapping(false);
  setUniformItemSizes(true);
  setMouseTracking(true);
  setSelectionMode(QAbstractItemView::SingleSelection);
  setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  setHorizontalScrollMode(QAbstractItemView::ScrollPerPixel);
  setEditTriggers(QAbstractItemView::NoEditTriggers);
  connect(this, &QListView::clicked, this, &StepsList::jump);
  connect(this, &QListView::doubleClicked, this, [this](const QModelIndex& index) {
    if (index.row() > 0) emit editWanted(index.row() - 1);
  });
  connect(&hub, &SessionHub::documentChanged, this, &StepsList::follow);
}

QSize StepsList::sizeHint() const {
  QStyleOptionViewItem option;
  initViewItemOption(&option);
  const int height = itemDelegate()->sizeHint(option, {}).height();
  return {400, height + horizontalScrollBar()->sizeHint().height() + 4};
}

QSize StepsList::minimumSizeHint() const { return {120, sizeHint().height()}; }

void StepsList::follow() {
  const QModelIndex current = steps_->index(steps_->currentRow());
  setCurrentIndex(current);
  scrollTo(current);
  viewport()->update();
}

void StepsList::jump(const QModelIndex& index) {
  if (index.isValid()) hub_.session().jumpTo(static_cast<std::size_t>(index.row()));
}

bool StepsList::event(QEvent* event) {
  if (event->type() == QEvent::Polish || event->type() == QEvent::ScreenChangeInternal) {
    steps_->setPixels(static_cast<int>(std::lround(StepDelegate::kPicture * devicePixelRatioF())));
  }
  return QListView::event(event);
}

void StepsList::keyPressEvent(QKeyEvent* event) {
  const int row = currentIndex().row();
  if (event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter) {
    jump(currentIndex());
  } else if (event->key() == Qt::Key_F2 && row > 0) {
    emit editWanted(row - 1);
  } else if (event->key() == Qt::Key_Delete && row > 0) {
    emit removeWanted(row - 1);
  } else {
    QListView::keyPressEvent(event);
  }
}

/// The list lies on its side, so the wheel walks along it.
void StepsList::wheelEvent(QWheelEvent* event) {
  const QPoint delta = event->angleDelta();
  const int by = std::abs(delta.x()) > std::abs(delta.y()) ? delta.x() : delta.y();
  horizontalScrollBar()->setValue(horizontalScrollBar()->value() - by);
  event->accept();
}

/// The card of the step that is shown stays in sight when the room for cards changes.
void StepsList::resizeEvent(QResizeEvent* event) {
  QListView::resizeEvent(event);
  scrollTo(currentIndex());
}

void StepsList::contextMenuEvent(QContextMenuEvent* event) {
  const QModelIndex index = indexAt(event->pos());
  if (!index.isValid()) return;
  const int row = index.row();
  QMenu menu(this);
  menu.addAction(tr("Show the model here"), this, [this, index] { jump(index); });
  QAction* edit =
      menu.addAction(tr("Change this step"), this, [this, row] { emit editWanted(row - 1); });
  menu.addSeparator();
  QAction* remove =
      menu.addAction(tr("Remove this step"), this, [this, row] { emit removeWanted(row - 1); });
  edit->setEnabled(row > 0);
  remove->setEnabled(row > 0);
  menu.exec(event->globalPos());
}

}  // namespace kiri::desktop
