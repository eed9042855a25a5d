// Levels of facets in their planes, against looking up points.
// SPDX-License-Identifier: MIT
#include "core/layers/layer_levels.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <vector>

#include "core/model/apply.h"
#include "tests/support/model_text.h"
#include "tests/support/random_steps.h"

namespace kiri {
namespace {

FoldedState randomState(std::uint64_t seed) {
  test::Random random(seed);
  FoldedState state = test::startOf(test::randomSheet(random));
  for (int i = 1; i <= 10; ++i) {
    const Result<FoldedState> next = apply(state, test::randomStep(random, state, {}), i);
    if (next.isOk()) state = *next;
  }
  return state;
}

TEST(LayerLevels, HeaveWhatLiesAboveAndNothingElse) {
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    const FoldedState state = randomState(seed);
    const std::vector<std::uint32_t> levels = layerLevels(state);
    test::Random random(seed);
    for (const LayerSet& set : state.layers.sets()) {
      if (!set.exceptions.empty()) continue;
      for (const FacetId upper : set.upward) {
        // Points of the upper facet, looked up in the others.
        bool restsOnLower = levels[upper.index] == 0;
        const Box box = boundsOf(regionOf(state.pattern, upper));
        for (int i = 0; i < 2000; ++i) {
          const Vec2 p{random.between(box.low.x, box.high.x),
                       random.between(box.low.y, box.high.y)};
          if (locate(regionOf(state.pattern, upper), p, 1e-3) != Where::Inside) continue;
          for (const FacetId lower : set.upward) {
            const Vec2 q = state.poseOf(lower).pullBack(state.poseOf(upper).apply(p));
            if (lower == upper || !state.layers.isAbove(upper, lower)) continue;
            if (locate(regionOf(state.pattern, lower), q, 1e-3) != Where::Inside) continue;
            EXPECT_GT(levels[upper.index], levels[lower.index]) << "seed " << seed;
            if (levels[upper.index] == levels[lower.index] + 1) restsOnLower = true;
          }
        }
        // Points can miss a small overlap, so only wide facets are asked.
        if (areaOf(regionOf(state.pattern, upper)) > 1000) {
          EXPECT_TRUE(restsOnLower) << "seed " << seed;
        }
      }
    }
  }
}

TEST(LayerLevels, AreZeroForPaperThatWasUnfolded) {
  const FoldedState state = test::run(
      "square 100\nfold a valley 50,0 50,100 left\nfold b valley m:50,50 m:100,50 @model left\n"
      "unfold all");
  EXPECT_EQ(layerLevels(state), std::vector<std::uint32_t>(state.pattern.facets.size(), 0));
}

TEST(LayerLevels, TakeExceptionsBeforeTheList) {
  FoldedState state = test::run("square 100\nfold a valley 50,0 50,100 left");
  ASSERT_EQ(state.layers.sets().size(), 1u);
  LayerSet set = state.layers.sets()[0];
  const FacetId below = set.upward[0];
  const FacetId above = set.upward[1];
  EXPECT_EQ(layerLevels(state)[above.index], 1u);
  set.exceptions = {{below, above}};
  state.layers = LayerOrder({set});
  EXPECT_EQ(layerLevels(state)[above.index], 0u);
  EXPECT_EQ(layerLevels(state)[below.index], 1u);
}

}  // namespace
}  // namespace kiri
