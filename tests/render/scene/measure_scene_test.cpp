// The numbers beside a measured leaf can be read.
// SPDX-License-Identifier: MIT
#include "render/scene/measure_scene.h"

#include <gtest/gtest.h>

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

TEST(MeasureScene, NumbersStandBesideTheLeafWithoutTouching) {
  const Result<LeafModel> leaf = leafModelOf(crowdedLeaf());
  ASSERT_TRUE(leaf) << leaf.error().message;
  const Result<Replay> replayed = replay(leaf->model);
  const FoldedState& state = **replayed->after(leaf->model.steps.size());
  const Result<LeafMeasures> measures = measuresOf(state.pattern);
  ASSERT_TRUE(measures);
  const Scene scene = measureScene(state, *measures, {}, {});
  std::vector<TextItem> numbers;
  for (const Group& group : scene.groups) {
    for (const Item& item : group.items) {
      const auto* text = std::get_if<TextItem>(&item.shape);
      if (text != nullptr && text->text.find("\u00b0") != std::string::npos)
        numbers.push_back(*text);
    }
  }
  // Those of teeth may find no room; lobes and sinuses have theirs, on both sides.
  int shown = 0;
  for (const TextItem& number : numbers) shown += number.color == Color{200, 40, 40} ? 1 : 0;
  EXPECT_GE(shown, measures->royerLobeCount);
  EXPECT_GE(numbers.size(), measures->margin.size() - 2);
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    for (std::size_t k = 0; k < i; ++k) {
      EXPECT_FALSE(areNear(boxOf(numbers[i]), boxOf(numbers[k]), 0))
          << numbers[i].text << " and " << numbers[k].text;
    }
  }
}

}  // namespace
}  // namespace kiri
