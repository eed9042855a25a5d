// What the gallery of the examples says, in the language of the window.
// SPDX-License-Identifier: MIT
#include "apps/desktop/services/gallery_words.h"

#include <QCoreApplication>

namespace kiri::desktop {

namespace {

/// The titles and sentences of examples/gallery.json, for the translators' tool.
[[maybe_unused]] constexpr const char* kWords[] = {
    QT_TRANSLATE_NOOP("examples/gallery", "How leaves are made"),
    QT_TRANSLATE_NOOP(
        "examples/gallery",
        "The sheet is folded along veins and anti-veins, as a leaf is in its bud; one "
        "cut through all layers, and it is unfolded."),
    QT_TRANSLATE_NOOP("examples/gallery", "Leaves"),
    QT_TRANSLATE_NOOP("examples/gallery", "Origami"),
    QT_TRANSLATE_NOOP("examples/gallery", "Kirigami"),
    QT_TRANSLATE_NOOP(
        "examples/gallery",
        "Folded, cut through all layers with straight cuts and curves, and unfolded."),
    QT_TRANSLATE_NOOP("examples/gallery",
                      "Species of the thesis, from angles and lengths measured on leaves or taken "
                      "from descriptions; the margin is one curve, cut through all layers."),
    QT_TRANSLATE_NOOP("examples/gallery",
                      "Folded step by step; where many creases would have to close at once, paper "
                      "is torn or closes as a whole, and the notes say so."),
    QT_TRANSLATE_NOOP("examples/gallery", "One straight cut"),
    QT_TRANSLATE_NOOP("examples/gallery",
                      "Folded so that a single straight cut makes the shape: the letters of Figure "
                      "7.21, and the star of five points."),
    QT_TRANSLATE_NOOP("examples/gallery", "Crease patterns"),
    QT_TRANSLATE_NOOP("examples/gallery",
                      "Patterns drawn from their geometry and folded as a whole."),
};

}  // namespace

QString inOurWords(const std::string& text) {
  return QCoreApplication::translate("examples/gallery", text.c_str());
}

}  // namespace kiri::desktop
