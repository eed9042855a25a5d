// What is seen of stacks and of partly folded paper.
// SPDX-License-Identifier: MIT
#include "render/visibility/visible_regions.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <random>

#include "tests/render/visibility/stacks.h"

namespace kiri::testing {
namespace {

double areaSum(const VisibleRegions& regions) {
  return std::accumulate(regions.facets.begin(), regions.facets.end(), 0.0,
                         [](double sum, const VisibleFacet& f) { return sum + areaOf(f); });
}

const VisibleFacet* find(const VisibleRegions& regions, FacetId facet) {
  for (const VisibleFacet& f : regions.facets) {
    if (f.facet == facet) return &f;
  }
  return nullptr;
}

double areaOfFacet(const VisibleRegions& regions, FacetId facet) {
  const VisibleFacet* found = find(regions, facet);
  return found == nullptr ? 0 : areaOf(*found);
}

/// All the checks of a flat state with straight edges.
void check(const FoldedState& state, double slack, int pixels = 60) {
  for (const ViewFrame& view : {frontView(), backView()}) {
    const VisibleRegions regions = visibleRegions(state, view);
    expectSound(state, view, regions);
    expectEqualsPixels(state, view, regions, pixels);
    const std::vector<double> expected = areasByTrapezoids(state, view);
    for (std::size_t i = 0; i < expected.size(); ++i) {
      EXPECT_NEAR(areaOfFacet(regions, FacetId(i)), expected[i], slack) << "facet " << i;
    }
  }
}

TEST(VisibleRegions, OneFacetIsSeenWhole) {
  StackBuilder stack(150);
  const FacetId f = stack.add(square(0, 0, 100));
  const FoldedState state = stack.stacked();
  const VisibleRegions regions = visibleRegions(state, frontView());
  ASSERT_EQ(regions.facets.size(), 1U);
  EXPECT_EQ(regions.facets[0].facet, f);
  EXPECT_TRUE(regions.facets[0].showsFront);
  ASSERT_EQ(regions.facets[0].loops.size(), 1U);
  EXPECT_EQ(regions.facets[0].loops[0].size(), 4U);
  for (const BoundaryPiece& piece : regions.facets[0].loops[0]) {
    EXPECT_TRUE(piece.isSilhouette());
    EXPECT_EQ(piece.facet, f);
    EXPECT_EQ(piece.from, 0);
    EXPECT_EQ(piece.to, 1);
  }
  EXPECT_FALSE(visibleRegions(state, backView()).facets[0].showsFront);
}

TEST(VisibleRegions, OnlyTheTopOfCoincidentSquaresIsSeen) {
  StackBuilder stack(150);
  for (int i = 0; i < 50; ++i) {
    if (i % 2 == 0) {
      stack.add(square(0, 0, 100));
    } else {
      stack.addBackUp(square(0, 0, 100));
    }
  }
  const FoldedState state = stack.stacked();
  const VisibleRegions front = visibleRegions(state, frontView());
  ASSERT_EQ(front.facets.size(), 1U);
  EXPECT_EQ(front.facets[0].facet, FacetId(49));
  EXPECT_FALSE(front.facets[0].showsFront);
  const VisibleRegions back = visibleRegions(state, backView());
  ASSERT_EQ(back.facets.size(), 1U);
  EXPECT_EQ(back.facets[0].facet, FacetId(0));
}

TEST(VisibleRegions, PinwheelShowsOneQuarterOfEachArm) {
  const FoldedState state = pinwheel();
  const VisibleRegions regions = visibleRegions(state, frontView());
  ASSERT_EQ(regions.facets.size(), 4U);
  const FacetId w(1), s(2), e(3), n(4);
  for (const VisibleFacet& f : regions.facets) EXPECT_NEAR(areaOf(f), 1, 1e-12);
  const auto sees = [&](FacetId f, Vec2 p) {
    return locate(regionOf(*find(regions, f)), p, 0) == Where::Inside;
  };
  EXPECT_TRUE(sees(n, {0.5, 0.5}));
  EXPECT_TRUE(sees(e, {0.5, -0.5}));
  EXPECT_TRUE(sees(s, {-0.5, -0.5}));
  EXPECT_TRUE(sees(w, {-0.5, 0.5}));
  check(state, 1e-9);
  const VisibleRegions back = visibleRegions(state, backView());
  ASSERT_EQ(back.facets.size(), 1U);
  EXPECT_NEAR(areaOf(back.facets[0]), 4, 1e-12);
}

// Thesis Fig 5.16 to 5.18: one-dimensional stacks, as strips of height 1.
TEST(VisibleRegions, StairsShowOneStripOfEachLayer) {
  StackBuilder stack(100);
  const int n = 40;
  for (int i = n; i-- > 0;) stack.add(rectangle(0, 0, 10 + i, 1));
  const VisibleRegions regions = visibleRegions(stack.stacked(), frontView());
  EXPECT_EQ(regions.facets.size(), static_cast<std::size_t>(n));
  check(stack.stacked(), 1e-9);
}

TEST(VisibleRegions, NestedStripsShowTwoPiecesOfEachLayer) {
  StackBuilder stack(100);
  const int n = 20;
  for (int i = n; i-- > 0;) stack.add(rectangle(-1 - i, 0, 1 + i, 1));
  const FoldedState state = stack.stacked();
  std::size_t loops = 0;
  for (const VisibleFacet& f : visibleRegions(state, frontView()).facets) loops += f.loops.size();
  EXPECT_EQ(loops, static_cast<std::size_t>(2 * n - 1));
  check(state, 1e-9);
}

TEST(VisibleRegions, GapInTheLayersAboveShowsWhatLiesBelow) {
  // The window of the thesis's efficient form closes this gap (guide/algorithms.md 3.1).
  StackBuilder stack(10);
  const FacetId low = stack.add(rectangle(0.5, 0, 3.5, 1));
  stack.add(rectangle(3, 0, 4, 1));
  stack.add(rectangle(0, 0, 1, 1));
  const FoldedState state = stack.stacked();
  EXPECT_NEAR(areaOfFacet(visibleRegions(state, frontView()), low), 2, 1e-12);
  check(state, 1e-9);
}

TEST(VisibleRegions, HoleShowsTheLayerBelowAndItsSeamsPair) {
  StackBuilder stack(20);
  const FacetId low = stack.add(rectangle(2, 2, 12, 5));
  Loop outer, hole;
  const std::vector<Vec2> o = square(0, 0, 10);
  const std::vector<Vec2> h = {{3, 3}, {3, 7}, {7, 7}, {7, 3}};
  for (std::size_t i = 0; i < 4; ++i) {
    outer.push_back(Arc::line(o[i], o[(i + 1) % 4]));
    hole.push_back(Arc::line(h[i], h[(i + 1) % 4]));
  }
  const FacetId ring = stack.add(std::vector<Loop>{outer, hole});
  const FoldedState state = stack.stacked();
  const VisibleRegions regions = visibleRegions(state, frontView());
  EXPECT_NEAR(areaOfFacet(regions, ring), 84, 1e-9);
  EXPECT_NEAR(areaOfFacet(regions, low), 8 + 6, 1e-9);
  check(state, 1e-9);
}

TEST(VisibleRegions, CurvedMarginStaysAnExactCubic) {
  StackBuilder stack(20);
  const Arc curve = Arc::cubic({0, 5}, {3, 9}, {7, 1}, {10, 5});
  const FacetId leaf =
      stack.add(std::vector<Loop>{{Arc::line({0, 0}, {10, 0}), Arc::line({10, 0}, {10, 5}),
                                   reversed(curve), Arc::line({0, 5}, {0, 0})}});
  const FacetId flap = stack.add(rectangle(4, -1, 5, 11));
  const FoldedState state = stack.stacked();
  const VisibleRegions regions = visibleRegions(state, frontView());
  expectSound(state, frontView(), regions);
  expectEqualsPixels(state, frontView(), regions, 80);
  const VisibleFacet* seen = find(regions, leaf);
  ASSERT_NE(seen, nullptr);
  EXPECT_EQ(seen->loops.size(), 2U);
  int curves = 0;
  for (const auto& loop : seen->loops) {
    for (const BoundaryPiece& piece : loop) {
      if (!piece.arc.isCurved) continue;
      ++curves;
      for (const double t : {0.2, 0.5, 0.8}) {
        EXPECT_LE(nearestOn(curve, pointAt(piece.arc, t)).distance, 1e-9);
      }
    }
  }
  EXPECT_EQ(curves, 2);
  EXPECT_NEAR(areaOfFacet(regions, flap), 12, 1e-9);
  EXPECT_NEAR(areaSum(regions),
              areaOf(kiri::regionOf(state.pattern, leaf)) + 12 -
                  (areaOf(kiri::regionOf(state.pattern, leaf)) - areaOfFacet(regions, leaf)),
              1e-9);
}

TEST(VisibleRegions, LayersCutAlongOneCurveHideEachOther) {
  // Ten layers with the same curved margin, half of them mirrored paper, some cut into two at other
  // places.
  StackBuilder stack(20);
  const Arc c = Arc::cubic({10, 0}, {14, 4}, {6, 8}, {10, 10});
  for (int i = 0; i < 10; ++i) {
    const double at = 0.1 * i + 0.05;
    const Vec2 p = pointAt(c, at);
    stack.add(std::vector<Loop>{{Arc::line({0, 0}, {10, 0}), part(c, 0, at), Arc::line(p, {0, p.y}),
                                 Arc::line({0, p.y}, {0, 0})}});
    stack.add(std::vector<Loop>{{Arc::line({0, p.y}, p), part(c, at, 1),
                                 Arc::line({10, 10}, {0, 10}), Arc::line({0, 10}, {0, p.y})}});
  }
  const FoldedState state = stack.stacked();
  for (const ViewFrame& view : {frontView(), backView()}) {
    const VisibleRegions regions = visibleRegions(state, view);
    EXPECT_EQ(regions.facets.size(), 2U);
    expectSound(state, view, regions);
    expectEqualsPixels(state, view, regions, 60);
  }
}

std::vector<Vec2> randomConvex(std::mt19937& random, double scale, double noise) {
  std::uniform_int_distribution<int> lattice(0, 12);
  std::uniform_real_distribution<double> jitter(-noise, noise);
  const auto coordinate = [&] {
    return lattice(random) * scale / 12 + (noise > 0 ? jitter(random) : 0);
  };
  std::vector<Vec2> points;
  while (true) {
    points = {
        {coordinate(), coordinate()}, {coordinate(), coordinate()}, {coordinate(), coordinate()}};
    const double area = cross(points[1] - points[0], points[2] - points[0]);
    if (std::abs(area) < scale * scale / 100) continue;
    if (area < 0) std::swap(points[1], points[2]);
    return points;
  }
}

TEST(VisibleRegions, RandomStacksEqualBothOracles) {
  for (const double noise : {0.0, 1e-12, 1e-10, 1e-9}) {
    for (unsigned seed = 1; seed <= 12; ++seed) {
      SCOPED_TRACE(::testing::Message() << "seed " << seed << " noise " << noise);
      std::mt19937 random(seed);
      StackBuilder stack(100 * std::sqrt(2));
      for (int i = 0; i < 14; ++i) {
        const std::vector<Vec2> polygon = randomConvex(random, 100, noise * 100);
        if (random() % 2 == 0) {
          stack.add(polygon);
        } else {
          stack.addBackUp(polygon);
        }
      }
      check(stack.stacked(), 1e-4 * noise / 1e-9 + 1e-6, 40);
      if (::testing::Test::HasFailure()) return;
    }
  }
}

TEST(VisibleRegions, FrontAndBackAreMirrored) {
  // Turning every facet's place in the list round and mirroring the view shows the same areas.
  for (unsigned seed = 1; seed <= 8; ++seed) {
    std::mt19937 random(seed);
    std::vector<std::vector<Vec2>> polygons;
    for (int i = 0; i < 15; ++i) polygons.push_back(randomConvex(random, 100, 0));
    StackBuilder up(140), down(140);
    for (std::size_t i = 0; i < 15; ++i) up.add(polygons[i]);
    for (std::size_t i = 0; i < 15; ++i) down.add(polygons[14 - i]);
    const VisibleRegions front = visibleRegions(up.stacked(), frontView());
    const VisibleRegions back = visibleRegions(down.stacked(), backView());
    ASSERT_EQ(front.facets.size(), back.facets.size());
    for (std::size_t i = 0; i < 15; ++i) {
      EXPECT_NEAR(areaOfFacet(front, FacetId(i)), areaOfFacet(back, FacetId(14 - i)), 1e-9);
    }
  }
}

/// A strip folded to a V seen from the front, beside a flat facet; and one that pokes through
/// another.
Rigid tilted(double degrees) { return rotationAbout({0, 0, 0}, {0, 1, 0}, degrees); }

TEST(VisibleRegions, TiltedFacetShowsItsShadow) {
  StackBuilder stack(40);
  const FacetId flat = stack.add(rectangle(-10, 0, 0, 10));
  const FacetId wing = stack.add(rectangle(0, 0, 10, 10), tilted(-60));
  stack.set({{0, 0, 1}, {flat}, {}});
  stack.set({tilted(-60).normal(), {wing}, {}});
  const FoldedState state = stack.state();
  const VisibleRegions regions = visibleRegions(state, frontView());
  EXPECT_NEAR(areaOfFacet(regions, wing), 50, 1e-9);
  expectSound(state, frontView(), regions);
  expectEqualsPixels(state, frontView(), regions, 50);
}

TEST(VisibleRegions, FlapBentBackOverItsNeighbourHidesItAndEndsAtTheHinge) {
  StackBuilder stack(40);
  const FacetId flat = stack.add(rectangle(0, 0, 10, 10));
  const FacetId wing = stack.add(rectangle(0, 0, 10, 6), tilted(-40));
  stack.set({{0, 0, 1}, {flat}, {}});
  stack.set({tilted(-40).normal(), {wing}, {}});
  const FoldedState state = stack.state();
  for (const ViewFrame& view : {frontView(), backView()}) {
    const VisibleRegions regions = visibleRegions(state, view);
    expectSound(state, view, regions);
    expectEqualsPixels(state, view, regions, 60);
  }
  EXPECT_NEAR(areaOfFacet(visibleRegions(state, frontView()), flat),
              100 - 60 * std::cos(40 * M_PI / 180), 1e-9);
  EXPECT_NEAR(areaOfFacet(visibleRegions(state, backView()), wing), 0, 1e-9);
}

TEST(VisibleRegions, EdgeOnFacetIsNotSeen) {
  StackBuilder stack(40);
  const FacetId flat = stack.add(rectangle(-10, 0, 10, 10));
  const FacetId wall = stack.add(rectangle(0, 0, 10, 6), tilted(-90));
  stack.set({{0, 0, 1}, {flat}, {}});
  stack.set({tilted(-90).normal(), {wall}, {}});
  const VisibleRegions regions = visibleRegions(stack.state(), frontView());
  ASSERT_EQ(regions.facets.size(), 1U);
  EXPECT_EQ(regions.facets[0].facet, flat);
}

TEST(VisibleRegions, FacetsThatPassThroughEachOtherMeetInALine) {
  StackBuilder stack(40);
  const FacetId flat = stack.add(rectangle(-10, -10, 10, 10));
  const FacetId blade = stack.add(rectangle(-6, -5, 6, 5), tilted(30));
  stack.set({{0, 0, 1}, {flat}, {}});
  stack.set({tilted(30).normal(), {blade}, {}});
  const FoldedState state = stack.state();
  for (const ViewFrame& view : {frontView(), backView()}) {
    const VisibleRegions regions = visibleRegions(state, view);
    EXPECT_NEAR(areaOfFacet(regions, blade), 60 * std::cos(M_PI / 6), 1e-9);
    EXPECT_NEAR(areaSum(regions), 400, 1e-9);
    expectSound(state, view, regions);
    expectEqualsPixels(state, view, regions, 60);
  }
}

TEST(VisibleRegions, ObliqueViewOfAStackKeepsItsOrder) {
  StackBuilder stack(40);
  stack.add(square(0, 0, 10));
  stack.add(square(5, 5, 10));
  stack.add(square(2, 8, 5));
  const FoldedState state = stack.stacked();
  const double c = std::cos(0.5), s = std::sin(0.5);
  const ViewFrame oblique{{1, 0, 0}, {0, c, s}, {0, -s, c}};
  const VisibleRegions regions = visibleRegions(state, oblique);
  expectSound(state, oblique, regions);
  expectEqualsPixels(state, oblique, regions, 60);
  EXPECT_NEAR(areaSum(regions), areaSum(visibleRegions(state, frontView())) * c, 1e-9);
}

TEST(VisibleRegions, LayersThatContradictEachOtherGiveAPictureAllTheSame) {
  StackBuilder stack(20);
  const FacetId a = stack.add(square(0, 0, 10));
  stack.add(square(1, 1, 10));
  const FacetId c = stack.add(square(2, 2, 10));
  const VisibleRegions regions = visibleRegions(stack.stacked({{a, c}}), frontView());
  EXPECT_NEAR(areaSum(regions), 100 + 19 + 19, 1e-9);
}

TEST(VisibleRegions, NothingIsSeenOfNoPaper) {
  const FoldedState state(CreasePattern(Tolerance(1)));
  EXPECT_TRUE(visibleRegions(state, frontView()).facets.empty());
}

}  // namespace
}  // namespace kiri::testing
