// The pane with the folded model, whatever draws it.
// SPDX-License-Identifier: MIT
#include "apps/desktop/views/model_view.h"

#include <QStackedLayout>

#include "apps/desktop/views/gl_model_view.h"
#include "apps/desktop/views/raster_model_view.h"

namespace kiri::desktop {

ModelView::ModelView(SessionHub& hub, AppearanceStore& look, Drawing drawing, QWidget* parent)
    : QWidget(parent), hub_(hub), look_(look), layout_(new QStackedLayout(this)) {
  if (drawing == Drawing::Software) {
    useSoftware({});
    return;
  }
  if (!canDrawWithGl()) {
    useSoftware(
        tr("There is no OpenGL 3.3 or OpenGL ES 3 here, so pictures are made by the "
           "program itself and come a little later."));
    return;
  }
  auto* view = new GlModelView(hub, look, this);
  connect(view, &GlModelView::failed, this, [this](const QString& why) {
    useSoftware(tr("The graphics card cannot be used (%1), so pictures are made by the program "
                   "itself and come a little later.")
                    .arg(why));
  });
  adopt(view);
}

void ModelView::adopt(QWidget* view) {
  view->setAccessibleName(tr("The folded model"));
  view->setAccessibleDescription(tr("Fold, cut and turn the paper here"));
  layout_->addWidget(view);
  layout_->setCurrentWidget(view);
  setFocusProxy(view);
}

void ModelView::useSoftware(const QString& why) {
  auto* view = new RasterModelView(hub_, look_, this);
  view->setNotice(why);
  adopt(view);
}

QWidget* ModelView::surface() const { return layout_->currentWidget(); }

bool ModelView::usesGl() const { return qobject_cast<GlModelView*>(surface()) != nullptr; }

QString ModelView::description() const {
  const auto* view = qobject_cast<GlModelView*>(surface());
  return view ? view->description() : tr("the program itself");
}

}  // namespace kiri::desktop
