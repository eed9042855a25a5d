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
    for (const MarginPoint& point : m_.margin) group.items.push_back(label(point));
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

  /// Angle and length beyond the end of the ray, on the side where there is room.
  Item label(const MarginPoint& point) const {
    const double height = kTextPart * size_;
    const Vec2 end = toScene_.apply(point.place);
    const Vec2 outward = normalized(toScene_.direction(point.place - m_.petiole));
    const Vec2 at = end + outward * height - Vec2{0, height / 3};
    const bool isUpright = std::abs(outward.x) < std::abs(outward.y) / 4;
    TextItem text;
    text.at = at;
    text.text = rounded(std::abs(point.angle), 1) + "\u00b0 " + rounded(point.length, 1);
    text.height = height;
    text.anchor = isUpright       ? TextAnchor::Middle
                  : outward.x > 0 ? TextAnchor::Start
                                  : TextAnchor::End;
    text.color = point.isLobe ? kLobeColor : kSinusColor;
    return {text, "measure", "", {}};
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
