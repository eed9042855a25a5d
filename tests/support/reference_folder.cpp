// A folder of its own for folds through all layers along endless lines.
// SPDX-License-Identifier: MIT
#include "tests/support/reference_folder.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "tests/support/plane_overlap.h"

namespace kiri::test {
namespace {

constexpr double kThin = 1e-9;

double polygonArea(const std::vector<Vec2>& polygon) {
  double twice = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i)
    twice += cross(polygon[i], polygon[(i + 1) % polygon.size()]);
  return std::abs(twice) / 2;
}

/// The part of a convex polygon on the left (sign 1) or right (sign -1) of the line.
std::vector<Vec2> clipped(const std::vector<Vec2>& polygon, Vec2 a, Vec2 b, double sign) {
  std::vector<Vec2> kept;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec2 p = polygon[i];
    const Vec2 q = polygon[(i + 1) % polygon.size()];
    const double hp = sign * cross(b - a, p - a) / distance(a, b);
    const double hq = sign * cross(b - a, q - a) / distance(a, b);
    if (hp >= -kThin) kept.push_back(p);
    if ((hp < -kThin && hq > kThin) || (hp > kThin && hq < -kThin))
      kept.push_back(lerp(p, q, hp / (hp - hq)));
  }
  return kept;
}

Vec2 mirrored(Vec2 p, Vec2 a, Vec2 b) {
  const Vec2 u = normalized(b - a);
  const Vec2 r = p - a;
  return a + u * (2 * dot(r, u)) - r;
}

ReferenceFacet turnedOver(const ReferenceFacet& facet, Vec2 a, Vec2 b) {
  ReferenceFacet turned = facet;
  turned.isFlipped = !facet.isFlipped;
  for (Vec2& p : turned.folded) p = mirrored(p, a, b);
  // A reflection is its own inverse: back to the paper is first the reflection, then the old way
  // back.
  const auto back = [&facet, a, b](Vec2 p) { return facet.toPaper(mirrored(p, a, b)); };
  turned.origin = back({0, 0});
  turned.x = back({1, 0}) - turned.origin;
  turned.y = back({0, 1}) - turned.origin;
  return turned;
}

Vec2 middleOf(const std::vector<Vec2>& polygon) {
  Vec2 sum;
  double weight = 0;
  for (std::size_t i = 1; i + 1 < polygon.size(); ++i) {
    const double w = cross(polygon[i] - polygon[0], polygon[i + 1] - polygon[0]);
    sum = sum + (polygon[0] + polygon[i] + polygon[i + 1]) * (w / 3);
    weight += w;
  }
  return sum / weight;
}

Loops loopsOf(const ReferenceFacet& facet) { return {facet.folded}; }

/// The kernel's facet for each of ours; none where there is no such facet.
std::vector<std::optional<FacetId>> counterparts(const ReferenceStack& stack,
                                                 const FoldedState& state) {
  std::vector<std::optional<FacetId>> found;
  for (const ReferenceFacet& facet : stack)
    found.push_back(facetAt(state.pattern, facet.toPaper(middleOf(facet.folded))));
  return found;
}

void comparePlace(const ReferenceFacet& facet, FacetId f, const FoldedState& state,
                  std::vector<std::string>& found) {
  const double size = state.tolerance().sheetSize();
  const std::string name = "facet " + std::to_string(f.index);
  if (std::abs(polygonArea(facet.folded) - test::areaOf(flatLoopsOf(state.pattern, f))) >
      1e-7 * size * size) {
    found.push_back(name + " has another area");
  }
  for (const Vec2 corner : facet.folded) {
    const Vec3 there = state.poseOf(f).apply(facet.toPaper(corner));
    if (distance(there, Vec3{corner.x, corner.y, 0}) > 1e-9 * size)
      found.push_back(name + " lies elsewhere");
  }
  if ((state.poseOf(f).normal().z < 0) != facet.isFlipped)
    found.push_back(name + " shows its other side");
}

bool isAboveInModel(const FoldedState& state, FacetId a, FacetId b) {
  const LayerSet& set = state.layers.sets()[state.layers.setOf(a)];
  return state.layers.isAbove(a, b) == (set.normal.z > 0);
}

}  // namespace

ReferenceStack unfolded(std::vector<Vec2> sheet) {
  ReferenceFacet facet;
  facet.folded = std::move(sheet);
  return {facet};
}

ReferenceStack folded(const ReferenceStack& stack, Vec2 a, Vec2 b, bool isValley) {
  ReferenceStack resting;
  ReferenceStack turned;
  for (const ReferenceFacet& facet : stack) {
    ReferenceFacet left = facet;
    ReferenceFacet right = facet;
    left.folded = clipped(facet.folded, a, b, 1);
    right.folded = clipped(facet.folded, a, b, -1);
    if (polygonArea(right.folded) > kThin) resting.push_back(right);
    if (polygonArea(left.folded) > kThin) turned.push_back(turnedOver(left, a, b));
  }
  std::reverse(turned.begin(), turned.end());
  ReferenceStack& below = isValley ? resting : turned;
  const ReferenceStack& above = isValley ? turned : resting;
  below.insert(below.end(), above.begin(), above.end());
  return below;
}

std::pair<Vec2, Vec2> boxOf(const ReferenceStack& stack) {
  Vec2 low = stack.front().folded.front();
  Vec2 high = low;
  for (const ReferenceFacet& facet : stack) {
    for (const Vec2 p : facet.folded) {
      low = {std::min(low.x, p.x), std::min(low.y, p.y)};
      high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    }
  }
  return {low, high};
}

double areaOf(const ReferenceStack& stack) {
  double sum = 0;
  for (const ReferenceFacet& facet : stack) sum += polygonArea(facet.folded);
  return sum;
}

std::vector<std::string> differences(const ReferenceStack& stack, const FoldedState& state) {
  std::vector<std::string> found;
  if (stack.size() != state.pattern.facets.size()) {
    return {std::to_string(state.pattern.facets.size()) + " facets instead of " +
            std::to_string(stack.size())};
  }
  const std::vector<std::optional<FacetId>> facets = counterparts(stack, state);
  for (std::size_t i = 0; i < stack.size(); ++i) {
    if (!facets[i]) return {"there is no facet where one should be"};
    comparePlace(stack[i], *facets[i], state, found);
  }
  int wrong = 0;
  int pairs = 0;
  const double size = state.tolerance().sheetSize();
  for (std::size_t low = 0; low < stack.size(); ++low) {
    const Loops a = loopsOf(stack[low]);
    for (std::size_t high = low + 1; high < stack.size(); ++high) {
      const Loops b = loopsOf(stack[high]);
      if (commonOf({&a, &b}).fatness() <= 1e-6 * size) continue;
      ++pairs;
      if (!state.layers.areCoplanar(*facets[low], *facets[high]) ||
          !isAboveInModel(state, *facets[high], *facets[low])) {
        ++wrong;
      }
    }
  }
  if (wrong != 0)
    found.push_back(std::to_string(wrong) + " of " + std::to_string(pairs) +
                    " layer relations are wrong");
  return found;
}

std::pair<Vec2, Vec2> lineOf(FoldSequence sequence, const ReferenceStack& stack, int number) {
  const auto [low, high] = boxOf(stack);
  const Vec2 size = high - low;
  const double reach = 10 * (size.x + size.y);
  Vec2 middle = lerp(low, high, 0.5);
  double degrees = number % 2 == 0 ? 90 : 0;
  if (sequence != FoldSequence::Half) degrees = 137.508 * number;
  const double radians = degrees * std::numbers::pi / 180;
  Vec2 along{std::cos(radians), std::sin(radians)};
  if (sequence == FoldSequence::Half) along = number % 2 == 0 ? Vec2{0, 1} : Vec2{1, 0};
  if (sequence == FoldSequence::Offset) middle = middle + Vec2{0.15 * size.x, 0.15 * size.y};
  return {middle - along * reach, middle + along * reach};
}

}  // namespace kiri::test
