// Between the editor's values and Qt's: points, colours, text.
// SPDX-License-Identifier: MIT
#pragma once

#include <QColor>
#include <QImage>
#include <QPointF>
#include <QString>
#include <string>

#include "core/base/vec.h"
#include "core/model/model.h"
#include "editor/base/phrase.h"
#include "render/scene/image.h"

namespace kiri::desktop {

inline QPointF toQt(Vec2 v) { return {v.x, v.y}; }
inline Vec2 toVec2(QPointF p) { return {p.x(), p.y()}; }
inline QColor toQt(Color c) { return {c.red, c.green, c.blue}; }
inline Color toColor(const QColor& c) {
  return {static_cast<std::uint8_t>(c.red()), static_cast<std::uint8_t>(c.green()),
          static_cast<std::uint8_t>(c.blue())};
}
inline QString toQt(const std::string& text) { return QString::fromStdString(text); }
/// A picture of its own: it does not refer to `image`.
QImage toQt(const Image& image);

/// The phrase in the language of the window, with its arguments in their places. The translators
/// know a sentence by the folder that says it (KIRI_TEXT), which the phrase itself does not carry:
/// all folders are asked, the first that knows it answers.
QString said(const Phrase& phrase);

}  // namespace kiri::desktop
