// The pane with the folded model, drawn by the graphics card.
// SPDX-License-Identifier: MIT
#include "apps/desktop/views/gl_model_view.h"

#include <QEvent>
#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <QOpenGLPaintDevice>
#include <QPainter>
#include <cmath>
#include <utility>

#include "apps/desktop/look/convert.h"
#include "apps/desktop/look/cursors.h"
#include "apps/desktop/look/mark_painter.h"
#include "apps/desktop/look/theme.h"
#include "apps/desktop/views/card_view.h"

namespace kiri::desktop {
namespace {

constexpr int kSamples = 4;

std::vector<TintColor> colorsOf(const std::vector<FacetTint>& tints) {
  std::vector<TintColor> colors;
  colors.reserve(tints.size());
  const auto part = [](int value) { return static_cast<std::uint8_t>(value); };
  for (const FacetTint tint : tints) {
    const QColor c = tintOf(tint);
    colors.push_back({part(c.red()), part(c.green()), part(c.blue()), part(c.alpha())});
  }
  return colors;
}

}  // namespace

QSurfaceFormat surfaceFormat() {
  QSurfaceFormat format;
  if (QOpenGLContext::openGLModuleType() == QOpenGLContext::LibGLES) {
    format.setRenderableType(QSurfaceFormat::OpenGLES);
    format.setVersion(3, 0);
  } else {
    format.setRenderableType(QSurfaceFormat::OpenGL);
    format.setVersion(3, 3);
    format.setProfile(QSurfaceFormat::CoreProfile);
  }
  format.setDepthBufferSize(24);
  format.setStencilBufferSize(8);
  format.setSamples(kSamples);
  return format;
}

bool canDrawWithGl() {
  QOffscreenSurface surface;
  surface.setFormat(surfaceFormat());
  surface.create();
  QOpenGLContext context;
  context.setFormat(surfaceFormat());
  if (!surface.isValid() || !context.create() || !context.makeCurrent(&surface)) return false;
  const QSurfaceFormat got = context.format();
  const std::pair<int, int> least = context.isOpenGLES() ? std::pair(3, 0) : std::pair(3, 3);
  context.doneCurrent();
  return got.version() >= qMakePair(least.first, least.second);
}

GlModelView::GlModelView(SessionHub& hub, AppearanceStore& look, QWidget* parent)
    : QOpenGLWidget(parent),
      hub_(hub),
      look_(look),
      input_(new PaneInput(hub.session(), Pane::Model, this)),
      meshes_(new MeshKeeper(hub, this)) {
  setFormat(surfaceFormat());
  const auto repaint = [this] { update(); };
  connect(meshes_, &MeshKeeper::changed, this, repaint);
  connect(&look, &AppearanceStore::changed, this, repaint);
  connect(&hub, &SessionHub::viewChanged, this, repaint);
  connect(&hub, &SessionHub::marksChanged, this, [this] {
    showCursor(*this, hub_.session().cursor());
    update();
  });
}

GlModelView::~GlModelView() { release(); }

QString GlModelView::description() const {
  return renderer_ ? toQt(renderer_->description()) : QString();
}

void GlModelView::release() {
  if (!renderer_) return;
  makeCurrent();
  renderer_.reset();
  doneCurrent();
}

bool GlModelView::event(QEvent* event) {
  if (event->type() == QEvent::PaletteChange) update();
  if (input_->handle(event)) return true;
  return QOpenGLWidget::event(event);
}

void GlModelView::initializeGL() {
  // Called again when the widget has got another context, as when it changes its window.
  connect(context(), &QOpenGLContext::aboutToBeDestroyed, this, &GlModelView::release,
          Qt::UniqueConnection);
  meshOnCard_ = 0;
  lookOnCard_ = 0;
  tintsOnCard_.clear();
  Result<std::unique_ptr<GlRenderer>> made = GlRenderer::create();
  if (made) {
    renderer_ = std::move(*made);
  } else {
    renderer_.reset();
    emit failed(toQt(made.error().message));
  }
}

void GlModelView::upload() {
  const ShownMesh& shown = meshes_->newest();
  const bool isNewMesh = shown.mesh && shown.revision != meshOnCard_;
  if (isNewMesh) {
    renderer_->setMesh(*shown.mesh);
    meshOnCard_ = shown.revision;
  }
  const bool isDark = theme().isDark();
  if (isNewMesh || shown.tints != tintsOnCard_ || isDark != isDarkOnCard_) {
    renderer_->setTints(colorsOf(shown.tints));
    tintsOnCard_ = shown.tints;
    isDarkOnCard_ = isDark;
  }
  if (look_.revision() != lookOnCard_) {
    renderer_->setAppearance(look_.appearance());
    lookOnCard_ = look_.revision();
  }
}

void GlModelView::paintGL() {
  if (!renderer_) return;
  upload();
  const PaneMap map = hub_.session().camera().map();
  renderer_->draw(cardViewOf(map, meshes_->newest().ball, look_.display(), devicePixelRatioF()));
  paintMarks();
}

void GlModelView::paintMarks() {
  const std::shared_ptr<const FoldedState> state = hub_.session().shown().base;
  if (!state) return;
  const Marks marks = hub_.session().marks();
  if (marks.empty()) return;
  const PaneMap map = hub_.session().camera().map();
  // Not a painter on the widget: a picture that is taken of the widget would miss the marks.
  const qreal ratio = devicePixelRatioF();
  QOpenGLPaintDevice device((QSizeF(size()) * ratio).toSize());
  device.setDevicePixelRatio(ratio);
  QPainter painter(&device);
  painter.setFont(font());
  MarkPainter(painter, map, *state, look_.display().lineStyle).paint(marks);
}

}  // namespace kiri::desktop
