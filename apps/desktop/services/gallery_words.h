// What the gallery of the examples says, in the language of the window.
// SPDX-License-Identifier: MIT
#pragma once

#include <QString>
#include <string>

namespace kiri::desktop {

/// A title or sentence of examples/gallery.json; one that the translators do not know stays as it
/// is.
QString inOurWords(const std::string& text);

}  // namespace kiri::desktop
