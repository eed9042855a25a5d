// The colours and textures of the open model, read once and shared by both panes.
// SPDX-License-Identifier: MIT
#include "apps/desktop/views/appearance_store.h"

#include <optional>
#include <utility>

#include "apps/desktop/look/convert.h"
#include "apps/desktop/services/textures.h"

namespace kiri::desktop {

AppearanceStore::AppearanceStore(SessionHub& hub, QObject* parent)
    : QObject(parent), hub_(hub), readFront_(hub.runner()), readBack_(hub.runner()) {
  connect(&hub, &SessionHub::documentChanged, this, &AppearanceStore::refresh);
  refresh();
}

void AppearanceStore::setDisplay(const Display& display) {
  display_ = display;
  apply();
}

void AppearanceStore::refresh() {
  const Document& document = hub_.session().document();
  read(front_, readFront_, texturePathOf(document.model().front, toQt(document.path())));
  read(back_, readBack_, texturePathOf(document.model().back, toQt(document.path())));
  apply();
}

void AppearanceStore::read(Texture& texture, LatestTask& task, const QString& file) {
  if (texture.file == file) return;
  texture = {file, nullptr};
  task.clear();
  if (file.isEmpty()) return;
  auto image = std::make_shared<std::optional<Result<Image>>>();
  task.ask({{},
            [file, image](const Progress&) { *image = readTexture(file); },
            [this, &texture, image] {
              if (!image->has_value()) return;  // the program ends
              Result<Image>& read = **image;
              if (!read) {
                emit failed(toQt(read.error().message));
                return;
              }
              texture.image = std::make_shared<const Image>(std::move(*read));
              apply();
            }});
}

void AppearanceStore::apply() {
  Appearance next = appearanceOf(hub_.session().document().model());
  next.front.texture = front_.image;
  next.back.texture = back_.image;
  next.lineStyle = display_.lineStyle;
  next.showEdges = display_.showsEdges;
  next.showCreases = display_.showsCreases;
  next.isShaded = display_.isShaded;
  next.gridSpacing = display_.showsGrid ? display_.gridSpacing : 0;
  appearance_ = std::move(next);
  ++revision_;
  emit changed();
}

}  // namespace kiri::desktop
