// Words on a page: how wide they are, paragraphs, labels.
// SPDX-License-Identifier: MIT
#include "render/scene/page_text.h"

#include <algorithm>

namespace kiri {
namespace {

/// Of the height, a letter of common fonts with what follows it.
constexpr double kLetterPart = 0.56;

std::size_t countLetters(const std::string& text) {
  return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), [](char c) {
    return (static_cast<unsigned char>(c) & 0xC0) != 0x80;  // no further byte of a letter
  }));
}

}  // namespace

double widthOf(const std::string& text, double height) {
  return static_cast<double>(countLetters(text)) * kLetterPart * height;
}

std::vector<std::string> wrapped(const std::string& text, double height, double width) {
  std::vector<std::string> lines;
  std::string line;
  std::size_t at = 0;
  while (at < text.size()) {
    const std::size_t end = std::min(text.find(' ', at), text.size());
    const std::string word = text.substr(at, end - at);
    at = end + 1;
    std::string longer = line;
    if (!longer.empty()) longer += ' ';
    longer += word;
    if (!line.empty() && widthOf(longer, height) > width) {
      lines.push_back(line);
      line = word;
    } else {
      line = longer;
    }
  }
  if (!line.empty()) lines.push_back(line);
  return lines;
}

TextItem centredText(const std::string& text, double height, Vec2 middle, Color color) {
  constexpr double kBaseline = 0.3;  // of the height, below the middle of letters like g and d
  TextItem item;
  item.at = middle - Vec2{0, kBaseline * height};
  item.text = text;
  item.height = height;
  item.anchor = TextAnchor::Middle;
  item.color = color;
  return item;
}

}  // namespace kiri
