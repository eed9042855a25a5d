// Finds the main veins among the creases and reads lengths and angles off the margin.
// SPDX-License-Identifier: MIT
#include "core/leaf/oiv_measures.h"

#include <algorithm>
#include <cmath>

#include "core/geometry/rigid.h"

namespace kiri {
namespace {

/// A vein may miss the tip by so many degrees: a margin that is not quite symmetric about it.
constexpr double kAside = 1;
constexpr int kMostVeins = 4;

/// Whether a crease leaves the petiole in the direction of the tip.
bool hasVein(const CreasePattern& pattern, Vec2 petiole, Vec2 tip) {
  const double within = pattern.tolerance.match();
  return std::any_of(pattern.edges.begin(), pattern.edges.end(), [&](const Edge& edge) {
    if (edge.kind != EdgeKind::Hinge) return false;
    Vec2 from = pattern[edge.from];
    Vec2 to = pattern[edge.to];
    if (distance(to, petiole) <= within) std::swap(from, to);
    if (distance(from, petiole) > within) return false;
    const Vec2 vein = to - from;
    const Vec2 wanted = tip - petiole;
    return std::abs(angleDegrees(dot(vein, wanted), cross(vein, wanted))) <= kAside;
  });
}

/// One half of the leaf, from the mid-vein outward: `side` 1 is the right, -1 the left.
struct HalfLeaf {
  std::vector<MarginPoint> veins;  ///< N1, N2, ...

  HalfLeaf(const std::vector<MarginPoint>& veined, const MarginPoint& midVein, int side)
      : veins{midVein} {
    for (const MarginPoint& tip : veined) {
      if ((tip.angle - midVein.angle) * side > 0) veins.push_back(tip);
    }
    std::sort(veins.begin(), veins.end(), [side](const MarginPoint& a, const MarginPoint& b) {
      return a.angle * side < b.angle * side;
    });
  }

  std::optional<double> length(std::size_t vein) const {
    if (vein >= veins.size()) return std::nullopt;
    return veins[vein].length;
  }
  std::optional<double> angleAfter(std::size_t vein) const {
    if (vein + 1 >= veins.size()) return std::nullopt;
    return std::abs(veins[vein + 1].angle - veins[vein].angle);
  }
  /// Length of the deepest sinus between two neighbouring veins.
  std::optional<double> sinusAfter(std::size_t vein, const std::vector<MarginPoint>& margin) const {
    if (vein + 1 >= veins.size()) return std::nullopt;
    const auto [low, high] = std::minmax(veins[vein].angle, veins[vein + 1].angle);
    std::optional<double> deepest;
    for (const MarginPoint& point : margin) {
      if (point.isLobe || point.angle <= low || point.angle >= high) continue;
      deepest = std::min(deepest.value_or(point.length), point.length);
    }
    return deepest;
  }
};

}  // namespace

int oivAngleClass(double degrees) {
  constexpr double kLimits[] = {30, 45, 55, 70};
  int above = 0;
  for (const double limit : kLimits) above += degrees > limit ? 1 : 0;
  return 2 * above + 1;
}

std::vector<OivMeasure> oivMeasures(const CreasePattern& pattern, Vec2 petiole,
                                    const std::vector<MarginPoint>& margin) {
  std::vector<MarginPoint> veined;
  for (const MarginPoint& point : margin) {
    if (point.isLobe && hasVein(pattern, petiole, point.place)) veined.push_back(point);
  }
  const auto middle = std::min_element(veined.begin(), veined.end(),
                                       [](const MarginPoint& a, const MarginPoint& b) {
                                         return std::abs(a.angle) < std::abs(b.angle);
                                       });
  if (veined.size() < 2 || std::abs(middle->angle) > kAside) return {};
  const HalfLeaf right(veined, *middle, 1);
  const HalfLeaf left(veined, *middle, -1);
  constexpr const char* kLengths[] = {"length of vein N1", "length of vein N2", "length of vein N3",
                                      "length of vein N4"};
  constexpr const char* kSinuses[] = {"petiole sinus to upper lateral sinus",
                                      "petiole sinus to lower lateral sinus"};
  constexpr const char* kAngles[] = {"angle between N1 and N2", "angle between N2 and N3",
                                     "angle between N3 and N4"};
  std::vector<OivMeasure> out;
  const auto add = [&out](int code, const char* name, bool isAngle, std::optional<double> onRight,
                          std::optional<double> onLeft) {
    if (onRight || onLeft) out.push_back({code, name, isAngle, onRight, onLeft});
  };
  for (std::size_t i = 0; i < kMostVeins; ++i) {
    add(601 + static_cast<int>(i), kLengths[i], false, right.length(i), left.length(i));
  }
  for (std::size_t i = 0; i < 2; ++i) {
    add(605 + static_cast<int>(i), kSinuses[i], false, right.sinusAfter(i, margin),
        left.sinusAfter(i, margin));
  }
  for (std::size_t i = 0; i + 1 < kMostVeins; ++i) {
    add(607 + static_cast<int>(i), kAngles[i], true, right.angleAfter(i), left.angleAfter(i));
  }
  return out;
}

}  // namespace kiri
