// The images on the two sides of the paper.
// SPDX-License-Identifier: MIT
#include "apps/desktop/services/textures.h"

#include <QDir>
#include <QFileInfo>
#include <QImageReader>
#include <cstddef>
#include <cstring>
#include <utility>

namespace kiri::desktop {

namespace {

std::shared_ptr<const Image> textureOf(const PaperSide& side, const QString& modelPath,
                                       QStringList* problems) {
  const QString path = texturePathOf(side, modelPath);
  if (path.isEmpty()) return nullptr;
  Result<Image> image = readTexture(path);
  if (image.isOk()) return std::make_shared<const Image>(std::move(*image));
  if (problems) problems->append(QString::fromStdString(image.error().message));
  return nullptr;
}

}  // namespace

Image imageOf(const QImage& picture) {
  const QImage rgba = picture.convertToFormat(QImage::Format_RGBA8888);
  Image image{rgba.width(), rgba.height(), {}};
  const std::size_t row = static_cast<std::size_t>(rgba.width()) * 4;
  image.rgba.resize(row * static_cast<std::size_t>(rgba.height()));
  for (int y = 0; y < rgba.height(); ++y) {
    std::memcpy(image.rgba.data() + row * static_cast<std::size_t>(y), rgba.constScanLine(y), row);
  }
  return image;
}

Result<Image> readTexture(const QString& path) {
  constexpr int kMost = 4096;
  QImageReader reader(path);
  reader.setAutoTransform(true);
  const QSize size = reader.size();
  if (size.width() > kMost || size.height() > kMost) {
    reader.setScaledSize(size.scaled(kMost, kMost, Qt::KeepAspectRatio));
  }
  const QImage picture = reader.read();
  if (picture.isNull()) {
    return Error{
        ErrorCode::BadFile,
        "the image " + path.toStdString() + " is left out: " + reader.errorString().toStdString(),
        {}};
  }
  return imageOf(picture);
}

QString texturePathOf(const PaperSide& side, const QString& modelPath) {
  if (side.texture.empty()) return {};
  QString path = QString::fromStdString(side.texture);
  if (QDir::isAbsolutePath(path) || modelPath.isEmpty()) return path;
  return QFileInfo(modelPath).absoluteDir().filePath(path);
}

Appearance appearanceWithTextures(const Model& model, const QString& modelPath,
                                  QStringList* problems) {
  Appearance appearance = appearanceOf(model);
  appearance.front.texture = textureOf(model.front, modelPath, problems);
  appearance.back.texture = textureOf(model.back, modelPath, problems);
  return appearance;
}

}  // namespace kiri::desktop
