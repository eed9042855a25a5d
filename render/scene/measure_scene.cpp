// A leaf with its measures drawn in.
// SPDX-License-Identifier: MIT
#include "render/scene/measure_scene.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numeric>
#include <tuple>

#include "core/paper/boxes.h"
#include "core/paper/contours.h"
#include "render/scene/label_room.h"
#include "render/scene/page_text.h"
#include "render/scene/paled.h"

namespace kiri {
namespace {

constexpr Color kAxisColor{60, 60, 60};
constexpr Color kLobeColor{200, 40, 40};
constexpr Color kSinusColor{30, 80, 200};
constexpr Color kCreaseColor{170, 170, 170};
/// Sizes on the page, as parts of the leaf's, so that small and large leaves look alike.
constexpr double kTextPart = 0.028;
constexpr double kLinePart = 0.002;
constexpr double kBorderPart = 0.003;
/// Room for numbers beside the leaf, in heights of the text.
constexpr double kRoom = 9;
/// How far off a tooth its label may stand, in heights too.
constexpr double kMinorReach = 12;
/// How much white is mixed into the paper, so that lines and numbers stand out.
constexpr double kWhite = 0.75;

/// What is nearer than this is one number, so that both sides of a leaf are rounded alike.
double settled(double value) {
  constexpr double kSteps = 10000;
  return std::round(value * kSteps) / kSteps;
}

std::string rounded(double value, int decimals) {
  char buffer[32];
  std::snprintf(buffer, sizeof buffer, "%.*f", decimals, settled(value));
  return buffer;
}

/// The paper's borders on the page, in sides no longer than `side`.
std::vector<std::vector<Vec2>> borderLoops(const CreasePattern& pattern, const Affine& toScene,
                                           double side) {
  std::vector<std::vector<Vec2>> loops;
  for (const auto& contour : contoursOf(pattern)) {
    std::vector<Vec2>& loop = loops.emplace_back();
    for (const EdgeUse use : contour) {
      const Arc arc = transformed(toScene, arcOf(pattern, use));
      const int count = static_cast<int>(std::ceil(distance(arc.start, arc.end) / side)) + 1;
      for (int i = 0; i < count; ++i) {
        loop.push_back(pointAt(arc, static_cast<double>(i) / count));
      }
    }
  }
  return loops;
}

/// Creases are but a hint here: the colours are those of lobes and sinuses.
void paleCreases(Scene& scene) {
  for (Group& group : scene.groups) {
    if (group.id == "print" || group.id == "cut") continue;
    for (Item& item : group.items) {
      if (auto* stroke = std::get_if<StrokeItem>(&item.shape)) stroke->stroke.color = kCreaseColor;
    }
  }
}

class MeasureItems {
 public:
  MeasureItems(const LeafMeasures& measures, const Affine& toScene, double size)
      : m_(measures), toScene_(toScene), size_(size) {}

  Group axis() const {
    Group group{"axis", "axis", {}, {}};
    const Vec2 apex = m_.petiole + m_.axis * m_.length;
    group.items.push_back(
        line(toScene_.apply(m_.petiole), toScene_.apply(apex), kAxisColor, 1, true));
    return group;
  }

  Group rays(bool ofLobes) const {
    Group group{ofLobes ? "lobes" : "sinuses", ofLobes ? "lobes" : "sinuses", {}, {}};
    for (std::size_t i = 0; i < m_.margin.size(); ++i) {
      const MarginPoint& point = m_.margin[i];
      if (point.isLobe != ofLobes) continue;
      group.items.push_back(line(toScene_.apply(m_.petiole), toScene_.apply(point.place),
                                 colorOf(point), isMinor(i) ? 0.5 : 1, false));
    }
    return group;
  }

  /// Labels that find a place.
  Group numbers(LabelRoom places, const Vec2& caption) const {
    Group group{"numbers", "numbers", {}, {}};
    for (const std::size_t i : inOrderOfWeight()) addLabel(i, places, group);
    const std::string text = "length " + rounded(m_.length, 1) + " mm, width " +
                             rounded(m_.width, 1) + " mm, area " + rounded(m_.area / 100, 2) +
                             " cm\u00b2, perimeter " + rounded(m_.perimeter, 1) + " mm";
    group.items.push_back(
        {TextItem{caption, text, kTextPart * size_, TextAnchor::Middle, false, kAxisColor},
         "measure",
         "",
         {}});
    return group;
  }

 private:
  static Color colorOf(const MarginPoint& point) { return point.isLobe ? kLobeColor : kSinusColor; }

  /// A tooth, or a sinus beside one.
  bool isMinor(std::size_t i) const {
    const auto isTooth = [this](std::size_t at) {
      return at < m_.margin.size() && m_.margin[at].isTooth;
    };
    return isTooth(i) || (!m_.margin[i].isLobe && (isTooth(i + 1) || (i > 0 && isTooth(i - 1))));
  }

  /// Lobes first, then sinuses, then teeth and the sinuses beside them; outward from the axis, so
  /// that both sides of a leaf are labelled alike.
  std::vector<std::size_t> inOrderOfWeight() const {
    const auto keyOf = [this](std::size_t i) {
      const MarginPoint& point = m_.margin[i];
      const int weight = isMinor(i) ? 2 : point.isLobe ? 0 : 1;
      return std::tuple(weight, settled(std::abs(point.angle)), i);
    };
    std::vector<std::size_t> order(m_.margin.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::sort(order.begin(), order.end(),
              [&keyOf](std::size_t a, std::size_t b) { return keyOf(a) < keyOf(b); });
    return order;
  }

  Item line(Vec2 from, Vec2 to, Color color, double weight, bool isDashed) const {
    Stroke stroke;
    stroke.color = color;
    stroke.width = weight * kLinePart * size_;
    if (isDashed) stroke.dashes = {6 * stroke.width, 4 * stroke.width};
    return {StrokeItem{{{Arc::line(from, to)}}, stroke}, "measure", "", {}};
  }

  /// Angle and length beyond the end of the ray, where there is room for them.
  void addLabel(std::size_t i, LabelRoom& places, Group& group) const {
    const MarginPoint& point = m_.margin[i];
    const double height = kTextPart * size_;
    const Vec2 end = toScene_.apply(point.place);
    const Vec2 outward = normalized(toScene_.direction(point.place - m_.petiole));
    const std::string number =
        rounded(std::abs(point.angle), 1) + "\u00b0 " + rounded(point.length, 1);
    const Vec2 room{widthOf(number, height), 1.2 * height};
    const auto place =
        places.takeBeyond(end, outward, room, isMinor(i) ? kMinorReach * height : size_);
    if (!place) return;
    if (place->isAway) group.items.push_back(line(end, place->near, colorOf(point), 0.5, true));
    group.items.push_back(
        {centredText(number, height, place->middle, colorOf(point)), "measure", "", {}});
  }

  const LeafMeasures& m_;
  Affine toScene_;
  double size_;  ///< of the leaf on the page, mm
};

}  // namespace

Scene measureScene(const FoldedState& state, const LeafMeasures& measures,
                   const Appearance& appearance, PatternSceneOptions options) {
  Appearance pale = paledFor(appearance, kWhite);
  const Box box = paperBoxOf(state.pattern);
  const double size = std::max(box.high.x - box.low.x, box.high.y - box.low.y) * options.scale;
  const double height = kTextPart * size;
  pale.drawnWidth = std::min(pale.drawnWidth, kBorderPart * size);
  options.margin = std::max(options.margin, kRoom * height);
  Scene scene = patternScene(state, pale, options);
  paleCreases(scene);
  const Affine toScene = patternPlacement(state.pattern, options);
  const Vec2 caption{scene.width / 2, 2 * height};
  const Box free{{height / 2, caption.y + 2 * height},
                 {scene.width - height / 2, scene.height - height / 2}};
  const LabelRoom places(free, borderLoops(state.pattern, toScene, height / 2));
  const MeasureItems items(measures, toScene, size);
  for (const bool ofLobes : {false, true}) scene.groups.push_back(items.rays(ofLobes));
  scene.groups.push_back(items.axis());
  scene.groups.push_back(items.numbers(places, caption));
  return scene;
}

}  // namespace kiri
