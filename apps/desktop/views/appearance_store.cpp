// The colours and textures of the open model, read once and shared by both panes.
// SPDX-License-Identifier: MIT
#include "apps/desktop/views/appearance_store.h"

#include <QDir>
#include <QFileInfo>
#include <QImageReader>
#include <algorithm>
#include <cstring>
#include <utility>

#include "apps/desktop/look/convert.h"

namespace kiri::desktop {
namespace {

constexpr int kLargestTexture = 4096;  // pixels; what every OpenGL 3.3 takes is more

std::shared_ptr<const Image> readImage(const QString& file) {
  QImageReader reader(file);
  reader.setAutoTransform(true);
  const QSize size = reader.size();
  if (size.width() > kLargestTexture || size.height() > kLargestTexture) {
    reader.setScaledSize(size.scaled(kLargestTexture, kLargestTexture, Qt::KeepAspectRatio));
  }
  const QImage read = reader.read().convertToFormat(QImage::Format_RGBA8888);
  if (read.isNull()) return nullptr;
  auto image = std::make_shared<Image>();
  image->width = read.width();
  image->height = read.height();
  const auto row = static_cast<std::size_t>(read.width()) * 4;
  image->rgba.resize(row * static_cast<std::size_t>(read.height()));
  for (int y = 0; y < read.height(); ++y) {
    std::memcpy(&image->rgba[row * static_cast<std::size_t>(y)], read.constScanLine(y), row);
  }
  return image;
}

QString fileOf(const PaperSide& side, const std::string& model) {
  if (side.texture.empty()) return {};
  return QDir(QFileInfo(toQt(model)).absolutePath()).absoluteFilePath(toQt(side.texture));
}

}  // namespace

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
  read(front_, readFront_, fileOf(document.model().front, document.path()));
  read(back_, readBack_, fileOf(document.model().back, document.path()));
  apply();
}

void AppearanceStore::read(Texture& texture, LatestTask& task, const QString& file) {
  if (texture.file == file) return;
  texture = {file, nullptr};
  task.clear();
  if (file.isEmpty()) return;
  auto image = std::make_shared<std::shared_ptr<const Image>>();
  task.ask({{},
            [file, image](const Progress&) { *image = readImage(file); },
            [this, &texture, image] {
              texture.image = *image;
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
