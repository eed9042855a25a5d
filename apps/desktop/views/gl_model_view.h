// The pane with the folded model, drawn by the graphics card.
// SPDX-License-Identifier: MIT
#pragma once

#include <QOpenGLWidget>
#include <memory>

#include "apps/desktop/services/session_hub.h"
#include "apps/desktop/views/appearance_store.h"
#include "apps/desktop/views/mesh_keeper.h"
#include "apps/desktop/views/pane_input.h"
#include "render/gl/renderer.h"

namespace kiri::desktop {

/// The surface that the window asks for: OpenGL 3.3 core, or ES 3 where there is nothing else.
QSurfaceFormat surfaceFormat();
/// Whether a context that the renderer can use is to be had here. Needs an application.
bool canDrawWithGl();

class GlModelView final : public QOpenGLWidget {
  Q_OBJECT
 public:
  GlModelView(SessionHub& hub, AppearanceStore& look, QWidget* parent = nullptr);
  ~GlModelView() override;
  PaneInput& input() { return *input_; }
  /// What draws, for the about box; empty before the first picture.
  QString description() const;

 signals:
  /// The renderer cannot be made; the view stays empty.
  void failed(const QString& why);

 protected:
  bool event(QEvent* event) override;
  void initializeGL() override;
  void paintGL() override;

 private:
  void release();
  void upload();
  void paintMarks();

  SessionHub& hub_;
  AppearanceStore& look_;
  PaneInput* input_;
  MeshKeeper* meshes_;
  std::unique_ptr<GlRenderer> renderer_;
  std::uint64_t meshOnCard_ = 0;
  std::uint64_t lookOnCard_ = 0;
  std::vector<FacetTint> tintsOnCard_;
  bool isDarkOnCard_ = false;
};

}  // namespace kiri::desktop
