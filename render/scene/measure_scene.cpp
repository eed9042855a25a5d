// A leaf with its measures drawn in.
// SPDX-License-Identifier: MIT
#include "render/scene/measure_scene.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "core/paper/boxes.h"

namespace kiri {
namespace {

constexpr Color kAxisColor{60, 60, 60};
constexpr Color kLobeColor{200, 40, 40};
constexpr Color kSinusColor{30, 80, 200};
/// Sizes on the page, as parts of the leaf's, so that small and large leaves look alike.
constexpr double kTextPart = 0.028;
constexpr double kLinePart = 0.002;
/// Room for numbers beside the leaf, in heights of the text.
constexpr double kRoom = 9;
/// From one line of numbers to the next, in heights of the text.
constexpr double kLinePitch = 1.35;
/// How much white is mixed into the paper, so that lines and numbers stand out.
constexpr double kWhite = 0.75;

Color paled(Color color) {
  const auto mixed = [](std::uint8_t part) {
    return static_cast<std::uint8_t>(std::lround(part + (255 - part) * kWhite));
  };
  return {mixed(color.red), mixed(color.green), mixed(color.blue)};
}

std::string rounded(double value, int decimals) {
  char buffer[32];
  std::snprintf(buffer, sizeof buffer, "%.*f", decimals, value);
  return buffer;
}

class MeasureItems {
 public:
  MeasureItems(const LeafMeasures& measures, const Affine& toScene, double size)
      : m_(measures), toScene_(toScene), size_(size) {}

  Group axis() const {
    Group group{"axis", "axis", {}, {}};
    const Vec2 apex = m_.petiole + m_.axis * m_.length;
    group.items.push_back(line(m_.petiole, apex, kAxisColor, true));
    return group;
  }

  Group rays(bool ofLobes) const {
    Group group{ofLobes ? "lobes" : "sinuses", ofLobes ? "lobes" : "sinuses", {}, {}};
    for (const MarginPoint& point : m_.margin) {
      if (point.isLobe != ofLobes) continue;
      group.items.push_back(
          line(m_.petiole, point.place, ofLobes ? kLobeColor : kSinusColor, false));
    }
    return group;
  }

  Group numbers(double bottom) const {
    Group group{"numbers", "numbers", {}, {}};
    for (const double side : {-1.0, 1.0}) {
      for (const Label& label : column(side)) addLabel(label, side, group.items);
    }
    for (const MarginPoint& point : m_.margin) {
      if (isOnAxis(point)) group.items.push_back(labelBeyond(point));
    }
    const double height = kTextPart * size_;
    const std::string text = "length " + rounded(m_.length, 1) + " mm, width " +
                             rounded(m_.width, 1) + " mm, area " + rounded(m_.area / 100, 2) +
                             " cm\u00b2, perimeter " + rounded(m_.perimeter, 1) + " mm";
    const double middle = toScene_.apply(m_.petiole).x;
    group.items.push_back(
        {TextItem{{middle, bottom}, text, height, TextAnchor::Middle, false, kAxisColor},
         "measure",
         "",
         {}});
    return group;
  }

 private:
  Item line(Vec2 from, Vec2 to, Color color, bool isDashed) const {
    Stroke stroke;
    stroke.color = color;
    stroke.width = kLinePart * size_;
    if (isDashed) stroke.dashes = {6 * stroke.width, 4 * stroke.width};
    const Arc arc = transformed(toScene_, Arc::line(from, to));
    return {StrokeItem{{{arc}}, stroke}, "measure", "", {}};
  }

  bool isOnAxis(const MarginPoint& point) const {
    return std::abs(cross(m_.axis, point.place - m_.petiole)) < kTextPart * m_.length / 2;
  }

  TextItem numbersOf(const MarginPoint& point, Vec2 at, TextAnchor anchor) const {
    TextItem text;
    text.at = at - Vec2{0, kTextPart * size_ / 3};
    text.text = rounded(std::abs(point.angle), 1) + "\u00b0 " + rounded(point.length, 1);
    text.height = kTextPart * size_;
    text.anchor = anchor;
    text.color = point.isLobe ? kLobeColor : kSinusColor;
    return text;
  }

  /// Beyond the end of the ray: for those on the axis, as the apex.
  Item labelBeyond(const MarginPoint& point) const {
    const Vec2 outward = normalized(toScene_.direction(point.place - m_.petiole));
    const Vec2 at = toScene_.apply(point.place) + outward * (kTextPart * size_);
    return {numbersOf(point, at, TextAnchor::Middle), "measure", "", {}};
  }

  /// A lobe tip or sinus on the page, and the height at which its numbers stand beside the leaf.
  struct Label {
    const MarginPoint* point = nullptr;
    Vec2 end;
    double y = 0;
  };

  /// Those of one side from the bottom up, moved apart where they would touch, and together to
  /// where they belong.
  std::vector<Label> column(double side) const {
    std::vector<Label> labels;
    const double middle = toScene_.apply(m_.petiole).x;
    for (const MarginPoint& point : m_.margin) {
      const Vec2 end = toScene_.apply(point.place);
      if (!isOnAxis(point) && (end.x < middle ? -1 : 1) == side)
        labels.push_back({&point, end, end.y});
    }
    std::sort(labels.begin(), labels.end(), [](const Label& a, const Label& b) {
      return a.end.y != b.end.y ? a.end.y < b.end.y : a.end.x < b.end.x;
    });
    const double apart = kLinePitch * kTextPart * size_;
    double lift = 0;
    for (std::size_t i = 1; i < labels.size(); ++i) {
      labels[i].y = std::max(labels[i].y, labels[i - 1].y + apart);
      lift += (labels[i].y - labels[i].end.y) / static_cast<double>(labels.size());
    }
    for (Label& label : labels) label.y -= lift;
    return labels;
  }

  /// Angle and length beside the leaf, and a thin line that leads to them.
  void addLabel(const Label& label, double side, std::vector<Item>& items) const {
    const double height = kTextPart * size_;
    const Box box = pageBox();
    const double edge = side < 0 ? box.low.x : box.high.x;
    const TextItem text = numbersOf(*label.point, {edge + side * height, label.y},
                                    side < 0 ? TextAnchor::End : TextAnchor::Start);
    Stroke stroke;
    stroke.color = text.color;
    stroke.width = kLinePart * size_ / 2;
    const Arc leader = Arc::line(label.end, {edge + side * height * 0.7, label.y});
    items.push_back({StrokeItem{{{leader}}, stroke}, "measure", "", {}});
    items.push_back({text, "measure", "", {}});
  }

  /// What tips and sinuses reach on the page.
  Box pageBox() const {
    Box box{toScene_.apply(m_.petiole), toScene_.apply(m_.petiole)};
    for (const MarginPoint& point : m_.margin) {
      const Vec2 p = toScene_.apply(point.place);
      box.low = {std::min(box.low.x, p.x), std::min(box.low.y, p.y)};
      box.high = {std::max(box.high.x, p.x), std::max(box.high.y, p.y)};
    }
    return box;
  }

  const LeafMeasures& m_;
  Affine toScene_;
  double size_;  ///< of the leaf on the page, mm
};

}  // namespace

Scene measureScene(const FoldedState& state, const LeafMeasures& measures,
                   const Appearance& appearance, PatternSceneOptions options) {
  Appearance pale = appearance;
  pale.front = {paled(appearance.front.color), nullptr};
  const Box box = paperBoxOf(state.pattern);
  const double size = std::max(box.high.x - box.low.x, box.high.y - box.low.y) * options.scale;
  const double height = kTextPart * size;
  options.margin = std::max(options.margin, kRoom * height);
  Scene scene = patternScene(state, pale, options);
  const MeasureItems items(measures, patternPlacement(state.pattern, options), size);
  scene.groups.push_back(items.axis());
  for (const bool ofLobes : {true, false}) scene.groups.push_back(items.rays(ofLobes));
  scene.groups.push_back(items.numbers(2 * height));
  return scene;
}

}  // namespace kiri
