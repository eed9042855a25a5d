// One straight cut gives lengths by the kirigami law.
// SPDX-License-Identifier: MIT
#include "core/leaf/straight_margin.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace kiri {
namespace {

double sine(double degrees) { return std::sin(degrees * std::numbers::pi / 180); }

/// Three veins with anti-veins between, cut by the line that meets the mid-vein at `p` degrees.
LeafRecipe straightLeaf(double p) {
  LeafRecipe recipe;
  recipe.antiVeins = {{24, 0}, {70, 0}};
  recipe.veins = {{40, 0}, {92, 0}};
  recipe.base.angle = 110;
  const auto lengthAt = [&](double folded) { return sine(p) / sine(p + folded); };
  recipe.antiVeins[0].length = lengthAt(24);
  recipe.veins[0].length = lengthAt(8);
  recipe.antiVeins[1].length = lengthAt(38);
  recipe.veins[1].length = lengthAt(16);
  recipe.base.length = lengthAt(34);
  return recipe;
}

TEST(StraightMargin, GivesBackTheLengthsOfALeafThatWasCutStraight) {
  const LeafRecipe recipe = straightLeaf(35);
  const FoldedHalf half(recipe, *fanOf(recipe));
  const std::vector<double> lengths = straightLengths(half);
  ASSERT_EQ(lengths.size(), half.creases().size());
  for (std::size_t i = 0; i < lengths.size(); ++i) {
    EXPECT_NEAR(lengths[i], length(half.creases()[i].end), 1e-12) << half.creases()[i].name;
  }
  // The law of the thesis: Ra / Rc = sin(p + alpha - beta) / sin p.
  EXPECT_NEAR(lengths[0] / lengths[2], sine(35 + 24 - 16) / sine(35), 1e-12);
}

TEST(StraightMargin, OfSecondaryLobesRunsOnThroughTheTurnedLobe) {
  LeafRecipe recipe = straightLeaf(35);
  recipe.secondary = {{0, .5, {20, .2}, {30, .3}, false}};
  const FoldedHalf half(recipe, *fanOf(recipe));
  const std::vector<double> lengths = straightLengths(half);
  // Ends of all creases, folded, lie on one line.
  std::vector<Vec2> ends;
  for (std::size_t i = 0; i < lengths.size(); ++i) {
    const LeafCrease& crease = half.creases()[i];
    const Vec2 way = normalized(crease.end - crease.from);
    const double along = dot(crease.from, way);
    const double rest = lengths[i] * lengths[i] - dot(crease.from, crease.from) + along * along;
    const Vec2 end = crease.from + way * (std::sqrt(rest) - along);
    ends.push_back(flatten(half.pose(std::min(i, lengths.size() - 2)).apply(end)));
  }
  for (const Vec2 end : ends) {
    EXPECT_NEAR(cross(normalized(ends.back() - ends.front()), end - ends.front()), 0, 1e-12);
  }
}

}  // namespace
}  // namespace kiri
