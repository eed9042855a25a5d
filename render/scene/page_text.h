// Words on a page: how wide they are, paragraphs, labels.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "render/scene/scene.h"

namespace kiri {

/// About how wide a line of text is, mm.
double widthOf(const std::string& text, double height);

/// The text in lines of at most `width` mm, broken between words.
std::vector<std::string> wrapped(const std::string& text, double height, double width);

/// A line of text around a middle.
TextItem centredText(const std::string& text, double height, Vec2 middle, Color color);

}  // namespace kiri
