// What pictures of crease patterns share: a page with a title above and a legend below.
// SPDX-License-Identifier: MIT
#include "render/scene/pattern_page.h"

#include <algorithm>
#include <utility>

#include "render/scene/page_text.h"

namespace kiri {
namespace {

constexpr double kHeadingHeight = 5;
constexpr double kLineStep = 1.5 * kWordHeight;
constexpr double kIndent = 5;  // mm, of the words behind a sign
constexpr double kNarrowest = 90;

}  // namespace

PatternPage::PatternPage(Vec2 pictures, std::vector<LegendLine> legend,
                         const PatternCheckOptions& options)
    : pictures_(pictures), title_(options.title), margin_(options.margin) {
  const double inner = std::max({pictures.x, kNarrowest, widthOf(title_, kHeadingHeight)});
  width_ = inner + 2 * margin_;
  if (!options.verdict.empty()) legend.insert(legend.begin(), LegendLine{{}, options.verdict, {}});
  for (const LegendLine& line : legend) {
    LegendLine next = line;
    for (const std::string& words : wrapped(line.text, kWordHeight, inner - kIndent)) {
      next.text = words;
      legend_.push_back(next);
      next.sign = LegendLine::Sign::None;
    }
  }
  const double below = static_cast<double>(legend_.size()) * kLineStep;
  corner_ = {margin_ + (inner - pictures.x) / 2, margin_ + below + (below > 0 ? margin_ : 0)};
  height_ = corner_.y + pictures.y + margin_ + (title_.empty() ? 0 : kHeadingHeight * 1.6);
}

Scene PatternPage::scene(std::vector<Group> groups) const {
  Scene scene;
  scene.width = width_;
  scene.height = height_;
  scene.title = title_;
  scene.background = Color{255, 255, 255};
  scene.groups = std::move(groups);
  Group legend = legendGroup();
  if (!legend.items.empty()) scene.groups.push_back(std::move(legend));
  return scene;
}

Group PatternPage::legendGroup() const {
  Group group{"legend", "legend", {}, {}};
  if (!title_.empty()) {
    TextItem item;
    item.at = {width_ / 2, height_ - margin_ - kHeadingHeight * 0.8};
    item.text = title_;
    item.height = kHeadingHeight;
    item.anchor = TextAnchor::Middle;
    group.items.push_back({item, "title", "", {}});
  }
  double y = margin_ + static_cast<double>(legend_.size()) * kLineStep;
  for (const LegendLine& line : legend_) {
    y -= kLineStep;
    const Vec2 sign{margin_ + kIndent / 3, y + kWordHeight * 0.35};
    constexpr double kSign = 1.2;
    if (line.sign == LegendLine::Sign::Ring) {
      group.items.push_back(ringMark(sign, kSign, line.color, "sign"));
    } else if (line.sign == LegendLine::Sign::Square) {
      group.items.push_back(squareMark(sign, kSign, line.color, "sign"));
    }
    TextItem item;
    item.at = {margin_ + kIndent, y};
    item.text = line.text;
    item.height = kWordHeight;
    group.items.push_back({item, "words", "", {}});
  }
  return group;
}

Item ringMark(Vec2 at, double radius, Color color, const std::string& kind) {
  // Four cubics are a circle to a fortieth of a percent.
  constexpr double kReach = 0.5522847498307936;
  const Vec2 ways[] = {{1, 0}, {0, 1}, {-1, 0}, {0, -1}};
  StrokeItem item;
  std::vector<Arc>& ring = item.chains.emplace_back();
  for (std::size_t i = 0; i < 4; ++i) {
    const Vec2 a = ways[i] * radius;
    const Vec2 b = ways[(i + 1) % 4] * radius;
    ring.push_back(Arc::cubic(at + a, at + a + b * kReach, at + b + a * kReach, at + b));
  }
  item.stroke.color = color;
  item.stroke.width = kMarkWidth;
  return {std::move(item), kind, "", {}};
}

Item squareMark(Vec2 at, double half, Color color, const std::string& kind) {
  const Vec2 corners[] = {at + Vec2{-half, -half}, at + Vec2{half, -half}, at + Vec2{half, half},
                          at + Vec2{-half, half}};
  StrokeItem item;
  std::vector<Arc>& square = item.chains.emplace_back();
  for (std::size_t i = 0; i < 4; ++i) square.push_back(Arc::line(corners[i], corners[(i + 1) % 4]));
  item.stroke.color = color;
  item.stroke.width = kMarkWidth;
  return {std::move(item), kind, "", {}};
}

}  // namespace kiri
