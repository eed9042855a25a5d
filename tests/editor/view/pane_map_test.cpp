// From paper to pixels and back.
// SPDX-License-Identifier: MIT
#include "editor/view/pane_map.h"

#include <gtest/gtest.h>

#include "tests/support/model_text.h"
#include "tests/support/views.h"

namespace kiri::testing {
namespace {

TEST(PaneMap, PixelsRunDownAndToTheRightOnTheFrontOfTheSheet) {
  const FoldedState state = test::run("square 100");
  const PaneMap map = test::frontCamera(state).map();
  const Vec2 low = map.toPixels(Vec3{0, 0, 0});
  const Vec2 high = map.toPixels(Vec3{100, 100, 0});
  EXPECT_LT(low.x, high.x);
  EXPECT_GT(low.y, high.y);
  EXPECT_NEAR((low.x + high.x) / 2, 400, 1e-9);
  EXPECT_NEAR((low.y + high.y) / 2, 300, 1e-9);
}

TEST(PaneMap, APointOfAFacetIsFoundAgainAtItsPixelFromEverySide) {
  int found = 0;
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    const FoldedState state = test::randomState(seed);
    test::Random random(seed * 77);
    const PaneMap map = test::randomCamera(random, state).map();
    for (std::uint32_t i = 0; i < state.pattern.facets.size(); ++i) {
      const FacetId facet(i);
      const Vec2 place = interiorPointOf(state.pattern, facet);
      const std::optional<Vec2> back =
          map.onPlaneOf(state, facet, map.toPixels(state, {facet, place}));
      if (!back) continue;  // edge-on
      EXPECT_LE(distance(*back, place), 1e-8) << "seed " << seed << " facet " << i;
      ++found;
    }
  }
  EXPECT_GT(found, 300);
}

TEST(PaneMap, ThePlaceOnAPlaneAppearsAtThePixelAlsoBeyondThePaper) {
  const FoldedState state = test::run("square 100; fold valley 70 50,0 50,100 left");
  test::Random random(5);
  int found = 0;
  for (int i = 0; i < 200; ++i) {
    const PaneMap map = test::randomCamera(random, state).map();
    const Vec2 pixels{random.between(-300, 1500), random.between(-300, 1500)};
    for (const FacetId facet : {FacetId(std::size_t{0}), FacetId(std::size_t{1})}) {
      const std::optional<Vec2> paper = map.onPlaneOf(state, facet, pixels);
      if (!paper) continue;
      ++found;
      const Vec3 place = map.placeOf(state, {facet, *paper});
      EXPECT_GT(map.frame.enlargement(place), 0) << "it lies before the eye";
      if (distance(*paper, {50, 50}) > 1000) continue;
      EXPECT_LE(distance(map.toPixels(place), pixels), 1e-6);
    }
  }
  EXPECT_GT(found, 300);
}

TEST(PaneMap, AFacetSeenEdgeOnHasNoPlaceUnderAnyPixel) {
  const FoldedState state = test::run("square 100; fold valley 90 50,0 50,100 left");
  const PaneMap map = test::frontCamera(state).map();
  const FacetId flat = facetAt(state.pattern, {75, 50}).value();
  const FacetId upright = facetAt(state.pattern, {25, 50}).value();
  EXPECT_TRUE(map.onPlaneOf(state, flat, {400, 300}).has_value());
  EXPECT_FALSE(map.onPlaneOf(state, upright, {400, 300}).has_value());
}

TEST(PaneMap, APlaneThatIsMetBehindTheEyeHasNoPlaceThere) {
  // The line of sight through the lower edge of a wide picture passes below the horizon of the
  // upright plane only behind the eye.
  const FoldedState state = test::run("square 100; fold valley 80 50,0 50,100 left");
  Camera camera = test::frontCamera(state);
  camera.setPerspective(100);
  const PaneMap map = camera.map();
  const FacetId steep = facetAt(state.pattern, {25, 50}).value();
  int before = 0;
  int behind = 0;
  for (double x = -8000; x <= 8000; x += 100) {
    const std::optional<Vec2> paper = map.onPlaneOf(state, steep, {x, 300});
    if (paper) {
      ++before;
      EXPECT_GT(map.frame.enlargement(map.placeOf(state, {steep, *paper})), 0);
    } else {
      ++behind;
    }
  }
  EXPECT_GT(before, 10);
  EXPECT_GT(behind, 10);
}

TEST(PaneMap, TheSheetPaneShowsThePaperAsItLiesUnfoldedFromEitherSide) {
  const FoldedState state = test::run("square 100; fold valley 50,0 50,100 left");
  for (const bool showsBack : {false, true}) {
    const PaneMap map = test::sheetCamera(state, showsBack).map();
    const FacetId left = facetAt(state.pattern, {10, 20}).value();
    const FacetId right = facetAt(state.pattern, {90, 20}).value();
    const Vec2 a = map.toPixels(state, {left, {10, 20}});
    const Vec2 b = map.toPixels(state, {right, {90, 20}});
    EXPECT_EQ(a.x < b.x, !showsBack);
    EXPECT_NEAR(a.y, b.y, 1e-9);
    EXPECT_NEAR(distance(a, b), 80 * map.pixelsPerMm, 1e-9);
    EXPECT_EQ(map.showsFront(state, {left, {10, 20}}), !showsBack);
    EXPECT_LE(distance(map.onPlaneOf(state, left, a).value(), {10, 20}), 1e-9);
  }
}

}  // namespace
}  // namespace kiri::testing
