// What is seen of paper that the kernel has folded.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "render/visibility/visible_regions.h"
#include "tests/render/visibility/stacks.h"
#include "tests/support/model_text.h"
#include "tests/support/random_steps.h"

namespace kiri::testing {
namespace {

void checkPixels(const FoldedState& state, int n) {
  for (const ViewFrame& view : {frontView(), backView()}) {
    const VisibleRegions regions = visibleRegions(state, view);
    expectSound(state, view, regions);
    expectEqualsPixels(state, view, regions, n);
  }
}

TEST(VisibleRegionsOfModels, HalvedSquareShowsOneFacetFromEachSide) {
  const FoldedState state = test::run(
      "square 100; fold valley 50,0 50,100 left; fold valley m:50,50 m:100,50 left; fold valley "
      "m:75,0 m:75,100 left");
  EXPECT_EQ(state.pattern.facets.size(), 8U);
  EXPECT_EQ(visibleRegions(state, frontView()).facets.size(), 1U);
  EXPECT_EQ(visibleRegions(state, backView()).facets.size(), 1U);
  checkPixels(state, 30);
}

TEST(VisibleRegionsOfModels, UnfoldedSheetShowsAllFacetsAndPairsItsSeams) {
  const FoldedState state = test::run(
      "square 100; fold valley 37,0 61,100 left; fold valley m:20,20 m:95,64 right; unfold all");
  const VisibleRegions regions = visibleRegions(state, frontView());
  EXPECT_EQ(regions.facets.size(), state.pattern.facets.size());
  double sum = 0;
  for (const VisibleFacet& facet : regions.facets) sum += areaOf(facet);
  EXPECT_NEAR(sum, 10000, 1e-7);
  checkPixels(state, 40);
}

TEST(VisibleRegionsOfModels, PartlyFoldedPaperIsSeenByDepth) {
  for (const char* angle : {"20", "60", "100", "140", "170"}) {
    const FoldedState state =
        test::run(std::string("square 100; fold valley 40,0 60,100 left; angle p:41,5 ") + angle +
                  "; fold mountain 120 p:70,0 p:95,100 right");
    checkPixels(state, 40);
  }
}

// Found by random steps: what had gone wrong once.
TEST(VisibleRegionsOfModels, FacetsPassThroughEachOtherUpToACurvedBorder) {
  checkPixels(
      test::run("disc 100; curve @model 130.79636578702636,30.865828381745512 "
                "105.57608920708294,59.741001817810123 76.05244507741752,45.499507629909303 "
                "71.958259811454894,13.257549419600409 103.55589889004361,8.2081614263937084 "
                "closed free top 4;"
                "turn horizontal; fold valley 26.370057665477766 @model "
                "68.915041123412564,97.35378937564407 "
                "35.774786635311465,99.302094967380384 left top 3; fold mountain "
                "14.203310746784549 @model "
                "101.09287496189347,48.099330235671111 39.698098121833674,64.292101811585667 to "
                "p:52.877322664033379,1.0545667521245121"),
      30);
}

TEST(VisibleRegionsOfModels, NeedleThinnerThanTheToleranceHasNoInside) {
  checkPixels(
      test::run(
          "square 100; fold mountain 180 @model 230.39815675503053,1.2070656530969393 "
          "-153.59877117002034,-0.8047104353979595 right; fold mountain 180 "
          "124.59825752284534,0.54686727249060318 -20.565505015230229,-0.36457818166040212 right"),
      30);
}

/// In perspective, the middle of the model's facets in the middle, the eye `times` as far away as
/// the paper is large.
ViewFrame fromEye(const FoldedState& state, double azimuth, double elevation, double times) {
  ViewFrame view = viewFrom(azimuth, elevation);
  view.centre = state.poses.front().apply(interiorPointOf(state.pattern, FacetId(0)));
  view.eyeDistance = times * state.tolerance().sheetSize();
  return view;
}

TEST(VisibleRegionsOfModels, PerspectiveKeepsLinesStraightAndCurvesSmooth) {
  const FoldedState state = test::run(
      "disc 100; curve 50,20 80,20 80,80 50,80 free; fold valley 60 30,0 30,100 left; fold "
      "mountain 100 80,0 60,100 right");
  for (const double times : {1.2, 2.0, 10.0}) {
    const ViewFrame view = fromEye(state, 30, 50, times);
    const VisibleRegions regions = visibleRegions(state, view);
    expectSound(state, view, regions);
    expectEqualsPixels(state, view, regions, 60);
  }
}

TEST(VisibleRegionsOfModels, FarEyeSeesWhatAnOrthographicViewShows) {
  const FoldedState state = test::run("square 100; fold valley 60 30,0 40,100 left");
  const ViewFrame far = fromEye(state, 30, 50, 1e6);
  const VisibleRegions a = visibleRegions(state, far);
  const VisibleRegions b = visibleRegions(state, viewFrom(30, 50));
  ASSERT_EQ(a.facets.size(), b.facets.size());
  for (std::size_t i = 0; i < a.facets.size(); ++i) {
    EXPECT_EQ(a.facets[i].facet, b.facets[i].facet);
    EXPECT_NEAR(areaOf(a.facets[i]), areaOf(b.facets[i]), 0.05);
  }
}

TEST(VisibleRegionsOfModels, RandomModelsEqualThePixelOracle) {
  int checked = 0;
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    SCOPED_TRACE(::testing::Message() << "seed " << seed);
    test::Random random(seed);
    const Model model = test::randomSheet(random);
    FoldedState state = test::startOf(model);
    for (int i = 0; i < 6; ++i) {
      const Step step = test::randomStep(random, state, {});
      if (Result<FoldedState> next = test::tryAfter(state, test::textOf(step)))
        state = std::move(*next);
    }
    if (!state.collisions.empty()) continue;
    checkPixels(state, 24);
    ++checked;
    if (::testing::Test::HasFailure()) return;
  }
  EXPECT_GT(checked, 20);
}

}  // namespace
}  // namespace kiri::testing
