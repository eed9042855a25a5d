// The numbers beside a measured leaf can be read.
// SPDX-License-Identifier: MIT
#include "render/scene/measure_scene.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/leaf/leaf_model.h"
#include "core/model/replay.h"

namespace kiri {
namespace {

/// Tips and sinuses at nearly one height, so that numbers beside them would lie on each other.
LeafRecipe crowdedLeaf() {
  LeafRecipe recipe;
  recipe.midVein = 120;
  recipe.veins = {{46, .88}, {94, .46}};
  recipe.antiVeins = {{24.85, .55}, {83, .37}};
  recipe.base = {126, .12};
  recipe.margin = {{20.5, .61}};
  recipe.secondary = {{0, .5, {24, .29}, {34, .36}, false},
                      {1, .55, {20.6, .225}, {30.6, .31}, false}};
  return recipe;
}

/// About where the letters of a number are: it is centred.
Box boxOf(const TextItem& number) {
  const double degrees = 1;  // the sign of degrees is two bytes long
  const double width = 0.5 * number.height * (static_cast<double>(number.text.size()) - degrees);
  return {number.at - Vec2{width / 2, 0}, number.at + Vec2{width / 2, 0.8 * number.height}};
}

/// The crowded leaf on its page, and what was measured.
struct MeasuredLeaf {
  LeafMeasures measures;
  Scene scene;

  /// The numbers beside the leaf.
  std::vector<TextItem> numbers() const {
    std::vector<TextItem> found;
    for (const Group& group : scene.groups) {
      for (const Item& item : group.items) {
        const auto* text = std::get_if<TextItem>(&item.shape);
        if (text != nullptr && text->text.find("\u00b0") != std::string::npos)
          found.push_back(*text);
      }
    }
    return found;
  }
};

MeasuredLeaf crowdedLeafMeasured() {
  const Result<LeafModel> leaf = leafModelOf(crowdedLeaf());
  EXPECT_TRUE(leaf) << leaf.error().message;
  const Result<Replay> replayed = replay(leaf->model);
  const FoldedState& state = **replayed->after(leaf->model.steps.size());
  const Result<LeafMeasures> measures = measuresOf(state.pattern);
  EXPECT_TRUE(measures);
  return {*measures, measureScene(state, *measures, {}, {})};
}

TEST(MeasureScene, NumbersStandBesideTheLeafWithoutTouching) {
  const MeasuredLeaf leaf = crowdedLeafMeasured();
  const std::vector<TextItem> numbers = leaf.numbers();
  // Those of teeth may find no room; lobes and sinuses have theirs, on both sides.
  int shown = 0;
  for (const TextItem& number : numbers) shown += number.color == Color{200, 40, 40} ? 1 : 0;
  EXPECT_GE(shown, leaf.measures.royerLobeCount);
  EXPECT_GE(numbers.size(), leaf.measures.margin.size() - 2);
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    for (std::size_t k = 0; k < i; ++k) {
      EXPECT_FALSE(areNear(boxOf(numbers[i]), boxOf(numbers[k]), 0))
          << numbers[i].text << " and " << numbers[k].text;
    }
  }
}

TEST(MeasureScene, BothSidesOfALeafAreLabelledAlike) {
  const MeasuredLeaf leaf = crowdedLeafMeasured();
  const std::vector<TextItem> numbers = leaf.numbers();
  std::size_t alone = 0;
  for (const TextItem& number : numbers) {
    const Vec2 mirrored{leaf.scene.width - number.at.x, number.at.y};
    const bool hasTwin = std::any_of(numbers.begin(), numbers.end(), [&](const TextItem& other) {
      return other.text == number.text && distance(other.at, mirrored) < 1e-3;
    });
    alone += hasTwin ? 0 : 1;
  }
  EXPECT_EQ(alone, 0U);
}

}  // namespace
}  // namespace kiri
