// The images on the two sides of the paper.
// SPDX-License-Identifier: MIT
#pragma once

#include <QImage>
#include <QString>
#include <QStringList>
#include <memory>

#include "core/base/result.h"
#include "core/model/model.h"
#include "render/scene/appearance.h"
#include "render/scene/image.h"

namespace kiri::desktop {

/// An image of any kind that Qt reads, no wider or higher than 4096 pixels: larger ones are made
/// smaller. Errors: BadFile - with the reason.
Result<Image> readTexture(const QString& path);

/// Where the image of a side lies that the file in `modelPath` names; empty when there is none.
QString texturePathOf(const PaperSide& side, const QString& modelPath);

/// Colours, box and images of a model, for pictures and panes. An image that cannot be read is left
/// out and told of in `problems`, where that is given. Reads files: call it beside the window, or
/// when the model or its sides have changed only.
Appearance appearanceWithTextures(const Model& model, const QString& modelPath,
                                  QStringList* problems = nullptr);

/// `picture` as a texture; back: toQt.
Image imageOf(const QImage& picture);

}  // namespace kiri::desktop
