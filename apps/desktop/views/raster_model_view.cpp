// The pane with the folded model where there is no graphics card: pictures made by the program.
// SPDX-License-Identifier: MIT
#include "apps/desktop/views/raster_model_view.h"

#include <QEvent>
#include <QPainter>
#include <algorithm>

#include "apps/desktop/look/convert.h"
#include "apps/desktop/look/cursors.h"
#include "apps/desktop/look/mark_painter.h"
#include "apps/desktop/look/theme.h"
#include "render/canvas/rasterise.h"
#include "render/scene/model_scene.h"

namespace kiri::desktop {
namespace {

QImage pictureOf(const FoldedState& state, const Appearance& appearance, const PaneMap& map,
                 double ratio, Color ground) {
  ModelSceneOptions options;
  options.margin = 0;
  const Vec2 half = map.size / (2 * map.pixelsPerMm);
  options.box = Box{map.centre - half, map.centre + half};
  // Lines are as wide as in the other pane, whatever the zoom.
  options.scale = map.pixelsPerMm * 25.4 / 96;
  Scene scene = modelScene(state, appearance, map.frame, options);
  scene.background = ground;
  const Result<Image> image = rasterise(scene, std::max(1, static_cast<int>(map.size.x * ratio)),
                                        std::max(1, static_cast<int>(map.size.y * ratio)));
  QImage picture = image ? toQt(*image) : QImage();
  picture.setDevicePixelRatio(ratio);
  return picture;
}

}  // namespace

RasterModelView::RasterModelView(SessionHub& hub, AppearanceStore& look, QWidget* parent)
    : QWidget(parent),
      hub_(hub),
      look_(look),
      input_(new PaneInput(hub.session(), Pane::Model, this)),
      task_(hub.runner(), LatestTask::Overtaken::MayEnd) {
  connect(&hub, &SessionHub::shownChanged, this, &RasterModelView::refresh);
  connect(&hub, &SessionHub::viewChanged, this, &RasterModelView::refresh);
  connect(&look, &AppearanceStore::changed, this, &RasterModelView::refresh);
  connect(&hub, &SessionHub::marksChanged, this, [this] {
    showCursor(*this, hub_.session().cursor());
    update();
  });
}

void RasterModelView::setNotice(const QString& notice) {
  notice_ = notice;
  update();
}

bool RasterModelView::event(QEvent* event) {
  const bool isHandled = input_->handle(event);
  if (event->type() == QEvent::Resize || event->type() == QEvent::PaletteChange) refresh();
  return isHandled || QWidget::event(event);
}

void RasterModelView::refresh() {
  const std::shared_ptr<const FoldedState> state = hub_.session().shown().state;
  if (!state || width() < 2 || height() < 2) return;
  auto picture = std::make_shared<QImage>();
  task_.ask({{},
             [picture, state, appearance = look_.appearance(), map = hub_.session().camera().map(),
              ratio = devicePixelRatioF(), ground = toColor(theme().ground)](const Progress&) {
               *picture = pictureOf(*state, appearance, map, ratio, ground);
             },
             [this, picture] {
               picture_ = *picture;
               update();
             }});
}

void RasterModelView::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.fillRect(rect(), theme().ground);
  if (!picture_.isNull()) painter.drawImage(QPointF(0, 0), picture_);
  const std::shared_ptr<const FoldedState> state = hub_.session().shown().base;
  const PaneMap map = hub_.session().camera().map();
  if (state) {
    MarkPainter(painter, map, *state, look_.display().lineStyle).paint(hub_.session().marks());
  }
  if (notice_.isEmpty()) return;
  const QRect foot = rect().adjusted(12, 0, -12, -10);
  painter.setPen(theme().warning);
  painter.drawText(foot, Qt::AlignBottom | Qt::AlignLeft | Qt::TextWordWrap, notice_);
}

}  // namespace kiri::desktop
