// Visible parts of each plane, made once and good for every view.
// SPDX-License-Identifier: MIT
#include "render/visibility/plane_regions.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "render/visibility/visible_regions.h"
#include "tests/render/visibility/stacks.h"
#include "tests/support/model_text.h"
#include "tests/support/random_steps.h"

namespace kiri::testing {
namespace {

FoldedState randomState(test::Random& random, bool hasAngles) {
  const Model model = test::randomSheet(random);
  FoldedState state = test::startOf(model);
  for (int i = 0; i < 8; ++i) {
    const Step step = test::randomStep(random, state, {true, true, hasAngles, 40});
    Result<FoldedState> next = test::tryAfter(state, test::textOf(step));
    if (next && next->collisions.empty()) state = std::move(*next);
  }
  return state;
}

Vec3 inSpace(const ViewFrame& view, Vec2 p, Vec3 point, Vec3 normal) {
  const Vec3 start = view.isPerspective() ? view.eye() : view.right * p.x + view.up * p.y;
  const Vec2 aside = p - view.direction(view.centre);
  const Vec3 ray = view.isPerspective()
                       ? view.right * aside.x + view.up * aside.y - view.toEye * view.eyeDistance
                       : view.toEye;
  return start + ray * (dot(point - start, normal) / dot(ray, normal));
}

TEST(PlaneRegions, OfAFlatStateAreWhatIsSeenFromFrontAndBack) {
  int checked = 0;
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    SCOPED_TRACE(::testing::Message() << "seed " << seed);
    test::Random random(seed);
    const FoldedState state = randomState(random, false);
    if (state.layers.sets().size() != 1) continue;
    ++checked;
    const std::vector<PlaneRegions> planes = planeRegions(state);
    ASSERT_EQ(planes.size(), 1U);
    for (const ViewFrame& view : {frontView(), backView()}) {
      const VisibleRegions expected = visibleRegions(state, view);
      const VisibleRegions& got = planes[0].seenFrom(view);
      ASSERT_EQ(expected.facets.size(), got.facets.size());
      for (std::size_t i = 0; i < got.facets.size(); ++i) {
        EXPECT_EQ(expected.facets[i].facet, got.facets[i].facet);
        EXPECT_EQ(expected.facets[i].showsFront, got.facets[i].showsFront);
        EXPECT_NEAR(areaOf(expected.facets[i]), areaOf(got.facets[i]), 1e-6);
      }
    }
  }
  EXPECT_GT(checked, 20);
}

TEST(PlaneRegions, AreDisjointAndCoverAllFacetsOfThePlane) {
  int planesOfMany = 0;
  for (std::uint64_t seed = 1; seed <= 30; ++seed) {
    SCOPED_TRACE(::testing::Message() << "seed " << seed);
    test::Random random(seed);
    const FoldedState state = randomState(random, true);
    for (const PlaneRegions& plane : planeRegions(state)) {
      const LayerSet& set = state.layers.sets()[plane.set];
      planesOfMany += set.upward.size() > 2 ? 1 : 0;
      for (const bool isAbove : {true, false}) {
        const ViewFrame& view = isAbove ? plane.above : plane.below;
        const VisibleRegions& regions = isAbove ? plane.fromAbove : plane.fromBelow;
        expectSound(state, view, regions);
        const Box box = boundsOf(regions);
        for (int i = 0; i < 300; ++i) {
          const Vec2 p{random.between(box.low.x, box.high.x),
                       random.between(box.low.y, box.high.y)};
          const Vec3 at = inSpace(view, p, plane.point, plane.above.toEye);
          bool isPaper = false;
          bool isNearBorder = false;
          for (const FacetId f : set.upward) {
            const Where where =
                locate(kiri::regionOf(state.pattern, f), state.poseOf(f).pullBack(at), 1e-4);
            isPaper = isPaper || where == Where::Inside;
            isNearBorder = isNearBorder || where == Where::OnBorder;
          }
          if (isNearBorder) continue;
          int parts = 0;
          for (const VisibleFacet& part : regions.facets) {
            if (locate(regionOf(part), p, 0) != Where::Outside) ++parts;
          }
          ASSERT_EQ(parts, isPaper ? 1 : 0);
        }
      }
    }
  }
  EXPECT_GT(planesOfMany, 20);
}

TEST(PlaneRegions, WithADepthBufferShowWhatEveryViewShows) {
  int asked = 0;
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    SCOPED_TRACE(::testing::Message() << "seed " << seed);
    test::Random random(seed);
    const FoldedState state = randomState(random, true);
    const std::vector<PlaneRegions> planes = planeRegions(state);
    for (int turn = 0; turn < 4; ++turn) {
      ViewFrame view = viewFrom(random.between(-180, 180), random.between(-90, 90));
      if (turn % 2 == 1) {
        view.centre = state.poses[0].apply(interiorPointOf(state.pattern, FacetId(0)));
        view.eyeDistance = 3 * state.tolerance().sheetSize();
      }
      const VisibleRegions expected = visibleRegions(state, view);
      const Box box = boundsOf(expected);
      for (int i = 0; i < 100; ++i) {
        const Vec2 p{random.between(box.low.x, box.high.x), random.between(box.low.y, box.high.y)};
        FacetId truth;
        bool isNearBorder = false;
        for (const VisibleFacet& part : expected.facets) {
          const Where where = locate(regionOf(part), p, 1e-3);
          isNearBorder = isNearBorder || where == Where::OnBorder;
          if (where == Where::Inside) truth = part.facet;
        }
        if (isNearBorder) continue;
        FacetId nearest;
        double depth = 0;
        for (const PlaneRegions& plane : planes) {
          if (std::abs(view.facing(plane.above.toEye, plane.point)) < 1e-3) continue;
          const Vec3 at = inSpace(view, p, plane.point, plane.above.toEye);
          const bool isAbove = plane.isSeenFromAbove(view);
          const Vec2 inPlane = (isAbove ? plane.above : plane.below).project(at);
          for (const VisibleFacet& part : plane.seenFrom(view).facets) {
            if (locate(regionOf(part), inPlane, 0) == Where::Outside) continue;
            if (nearest.isValid() && view.depth(at) < depth) continue;
            nearest = part.facet;
            depth = view.depth(at);
          }
        }
        ++asked;
        ASSERT_EQ(nearest, truth);
      }
    }
  }
  EXPECT_GT(asked, 8000);
}

TEST(PlaneRegions, PartsOnThePaperMoveWithTheirFacets) {
  const FoldedState state = test::run(
      "disc 100; fold half valley 50,0 50,100 left; fold quarter valley m:50,40 m:100,45 left; "
      "angle quarter 140");
  for (const PlaneRegions& plane : planeRegions(state)) {
    for (const bool isAbove : {true, false}) {
      const ViewFrame& view = isAbove ? plane.above : plane.below;
      for (const VisibleFacet& part : (isAbove ? plane.fromAbove : plane.fromBelow).facets) {
        const Region region = onPaper(state, part, view);
        EXPECT_NEAR(areaOf(region), areaOf(part), 1e-9);
        for (const Loop& loop : region.loops) {
          for (const Arc& arc : loop) {
            const Vec2 middle = pointAt(arc, 0.5);
            EXPECT_NE(locate(kiri::regionOf(state.pattern, part.facet), middle, 1e-6),
                      Where::Outside);
          }
        }
      }
    }
  }
}

}  // namespace
}  // namespace kiri::testing
