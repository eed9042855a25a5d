// Between the editor's values and Qt's: points, colours, text.
// SPDX-License-Identifier: MIT
#include "apps/desktop/look/convert.h"

#include <QCoreApplication>

namespace kiri::desktop {
namespace {

/// The folders that KIRI_TEXT names.
constexpr const char* kContexts[] = {"editor/tools",  "editor/session", "editor/document",
                                     "editor/motion", "editor/snap",    "editor/view",
                                     "editor/base"};

}  // namespace

QImage toQt(const Image& image) {
  if (image.width <= 0 || image.height <= 0) return {};
  const QImage shared(image.rgba.data(), image.width, image.height, qsizetype{image.width} * 4,
                      QImage::Format_RGBA8888);
  return shared.copy();
}

QString said(const Phrase& phrase) {
  if (phrase.isEmpty()) return {};
  const QString english = toQt(phrase.text);
  QString translated = english;
  for (const char* context : kContexts) {
    translated = QCoreApplication::translate(context, phrase.text.c_str());
    if (translated != english) break;
  }
  return toQt(withArguments(translated.toStdString(), phrase.arguments));
}

}  // namespace kiri::desktop
