// How many layers lie on each other, against counting at many points.
// SPDX-License-Identifier: MIT
#include "core/layers/layer_count.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "core/model/apply.h"
#include "tests/support/model_text.h"
#include "tests/support/random_steps.h"

namespace kiri {
namespace {

/// The same by brute force: facets of one set that hold a point, at many points of every facet.
std::uint32_t countAtPoints(const FoldedState& state, test::Random& random) {
  std::uint32_t deepest = 0;
  for (const LayerSet& set : state.layers.sets()) {
    for (const FacetId facet : set.upward) {
      const Box box = boundsOf(regionOf(state.pattern, facet));
      for (int i = 0; i < 200; ++i) {
        const Vec2 p{random.between(box.low.x, box.high.x), random.between(box.low.y, box.high.y)};
        if (locate(regionOf(state.pattern, facet), p, 0) != Where::Inside) continue;
        const Vec3 place = state.poseOf(facet).apply(p);
        std::uint32_t count = 0;
        for (const FacetId other : set.upward) {
          const Vec2 q = state.poseOf(other).pullBack(place);
          if (locate(regionOf(state.pattern, other), q, 0) == Where::Inside) ++count;
        }
        deepest = std::max(deepest, count);
      }
    }
  }
  return deepest;
}

TEST(LayerCount, CountsTheLayersOfHalvings) {
  FoldedState state = test::startOf(test::modelOf("square 128"));
  EXPECT_EQ(maxLayerCount(state), 1u);
  double low = 0;
  for (int i = 1; i <= 10; ++i) {
    const std::string middle = std::to_string((low + 128) / 2);
    state = test::after(state, "fold f" + std::to_string(i) + " valley m:" + middle +
                                   ",-1 m:" + middle + ",129 @model left");
    low = (low + 128) / 2;
    EXPECT_EQ(maxLayerCount(state), 1u << i);
  }
}

TEST(LayerCount, CountsOnlyLayersThatShareAPlace) {
  EXPECT_EQ(maxLayerCount(test::run(
                "rectangle 100 20\nfold a valley 20,0 20,20 left\nfold b valley 80,0 80,20 right")),
            2u);
  EXPECT_EQ(maxLayerCount(test::run(
                "rectangle 100 20\nfold a valley 30,0 30,20 left\nfold b valley 70,0 70,20 right")),
            3u);
  EXPECT_EQ(maxLayerCount(test::run("rectangle 100 20\nfold a valley 90 40,0 40,20 left")), 1u);
}

TEST(LayerCount, CountsLayersWithTheSameCurvedMargin) {
  // Mirrored copies of a margin agree but for rounding, in hundreds of places.
  const std::string folded =
      "square 120; fold a valley 60,0 60,120 right; fold b valley @model 0,60 60,60 left;"
      "fold c valley @model 0,0 60,60 left;";
  const FoldedState state =
      test::run(folded + "curve @model 70,45 50,40 45,25 35,20 30,-10 keep m:57,4");
  EXPECT_FALSE(state.pattern.curves.empty());
  EXPECT_EQ(maxLayerCount(state), 8u);
}

TEST(LayerCount, AgreesWithCountingAtPointsOnRandomModels) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    test::Random random(seed);
    FoldedState state = test::startOf(test::randomSheet(random));
    for (int i = 1; i <= 8; ++i) {
      const Result<FoldedState> next = apply(state, test::randomStep(random, state, {}), i);
      if (next.isOk()) state = *next;
    }
    // Points can miss the deepest place when it is small, never find a deeper one.
    const std::uint32_t exact = maxLayerCount(state);
    const std::uint32_t sampled = countAtPoints(state, random);
    EXPECT_LE(sampled, exact) << "seed " << seed;
    EXPECT_GE(sampled + 1, exact) << "seed " << seed;
  }
}

}  // namespace
}  // namespace kiri
