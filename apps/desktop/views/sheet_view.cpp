// The pane with the flat sheet.
// SPDX-License-Identifier: MIT
#include "apps/desktop/views/sheet_view.h"

#include <QEvent>
#include <QPainter>

#include "apps/desktop/look/cursors.h"
#include "apps/desktop/look/mark_painter.h"
#include "apps/desktop/look/theme.h"
#include "apps/desktop/views/sheet_painter.h"

namespace kiri::desktop {

SheetView::SheetView(SessionHub& hub, AppearanceStore& look, QWidget* parent)
    : QWidget(parent),
      hub_(hub),
      look_(look),
      input_(new PaneInput(hub.session(), Pane::Sheet, this)) {
  setAccessibleName(tr("The flat sheet"));
  setAccessibleDescription(tr("The crease pattern on the unfolded paper"));
  setAttribute(Qt::WA_OpaquePaintEvent);
  connect(&hub, &SessionHub::shownChanged, this, &SheetView::forget);
  connect(&hub, &SessionHub::viewChanged, this, &SheetView::forget);
  connect(&look, &AppearanceStore::changed, this, &SheetView::forget);
  connect(&hub, &SessionHub::marksChanged, this, [this] {
    showCursor(*this, hub_.session().cursor());
    update();
  });
}

void SheetView::forget() {
  paper_ = {};
  update();
}

bool SheetView::event(QEvent* event) {
  if (event->type() == QEvent::Resize || event->type() == QEvent::PaletteChange) forget();
  if (input_->handle(event)) return true;
  return QWidget::event(event);
}

void SheetView::paintPaper(const Shown& shown, const PaneMap& map) {
  const qreal ratio = devicePixelRatioF();
  paper_ = QPixmap((QSizeF(size()) * ratio).toSize());
  paper_.setDevicePixelRatio(ratio);
  paper_.fill(theme().sheetGround);
  if (!shown.state) return;
  QPainter painter(&paper_);
  if (shown.isPreview && shown.base) {
    SheetPainter(painter, map, *shown.base, look_.appearance(), look_.display()).paintGhost();
  }
  SheetPainter(painter, map, *shown.state, look_.appearance(), look_.display()).paint(shown.tints);
}

void SheetView::paintEvent(QPaintEvent*) {
  const PaneMap map = hub_.session().sheetCamera().map();
  if (paper_.isNull() || paper_.devicePixelRatio() != devicePixelRatioF()) {
    paintPaper(hub_.session().shown(), map);
  }
  QPainter painter(this);
  painter.drawPixmap(0, 0, paper_);
  const std::shared_ptr<const FoldedState> state = hub_.session().shown().base;
  if (state) {
    MarkPainter(painter, map, *state, look_.display().lineStyle).paint(hub_.session().marks());
  }
}

}  // namespace kiri::desktop
