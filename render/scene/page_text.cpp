// Words on a page: labels that keep out of each other's way, and paragraphs.
// SPDX-License-Identifier: MIT
#include "render/scene/page_text.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

namespace kiri {
namespace {

/// Of the height, a letter of common fonts with what follows it.
constexpr double kLetterPart = 0.56;

std::size_t countLetters(const std::string& text) {
  return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), [](char c) {
    return (static_cast<unsigned char>(c) & 0xC0) != 0x80;  // no further byte of a letter
  }));
}

double areaOf(const Box& box) {
  return std::max(0.0, box.high.x - box.low.x) * std::max(0.0, box.high.y - box.low.y);
}

Box common(const Box& a, const Box& b) {
  return {{std::max(a.low.x, b.low.x), std::max(a.low.y, b.low.y)},
          {std::min(a.high.x, b.high.x), std::min(a.high.y, b.high.y)}};
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

double LabelPlaces::covered(const Box& box) const {
  // Outside the page is worse than over another label.
  double sum = 10 * (areaOf(box) - areaOf(common(box, page_)));
  for (const Box& other : taken_) sum += areaOf(common(box, other));
  return sum;
}

TextItem LabelPlaces::place(const std::string& text, double height, Vec2 point, double away,
                            Color color) {
  constexpr int kDirections = 12;
  constexpr int kDistances = 4;
  const Vec2 half{widthOf(text, height) / 2, height / 2};
  double least = std::numeric_limits<double>::infinity();
  Box best;
  for (int ring = 0; ring < kDistances && least > 0; ++ring) {
    const double reach = away + ring * height * 0.8;
    for (int i = 0; i < kDirections && least > 0; ++i) {
      const double angle = 2 * std::numbers::pi * (i + 0.5) / kDirections;
      const Vec2 way{std::cos(angle), std::sin(angle)};
      const Vec2 middle = point + way * reach + Vec2{way.x * half.x, way.y * half.y};
      const Box box{middle - half, middle + half};
      const double sum = covered(box);
      if (sum >= least) continue;
      least = sum;
      best = box;
    }
  }
  // Pushed into the page whatever it covers there.
  const Vec2 push{
      std::max(0.0, page_.low.x - best.low.x) - std::max(0.0, best.high.x - page_.high.x),
      std::max(0.0, page_.low.y - best.low.y) - std::max(0.0, best.high.y - page_.high.y)};
  best = {best.low + push, best.high + push};
  taken_.push_back(best);
  constexpr double kBaseline = 0.2;  // of the height, above the lower end of letters like g
  TextItem item;
  item.at = {(best.low.x + best.high.x) / 2, best.low.y + kBaseline * height};
  item.text = text;
  item.height = height;
  item.anchor = TextAnchor::Middle;
  item.color = color;
  return item;
}

}  // namespace kiri
