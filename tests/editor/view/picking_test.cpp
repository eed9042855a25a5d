// What lies under the pointer, against slow answers found in other ways.
// SPDX-License-Identifier: MIT
#include "editor/view/picking.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "core/paper/boxes.h"
#include "editor/view/neighbourhood.h"
#include "render/visibility/facet_view.h"
#include "render/visibility/visible_regions.h"
#include "tests/support/depth_buffer.h"
#include "tests/support/model_text.h"
#include "tests/support/views.h"

namespace kiri::testing {
namespace {

FacetId facetOf(const FoldedState& state, Vec2 paper) {
  return facetAt(state.pattern, paper).value();
}

/// Four arms folded onto the middle of a plus, each over the next: no list says that.
FoldedState pinwheel() {
  FoldedState state = test::run(
      "polygon 10,-10 20,-10 20,10 10,10 10,20 -10,20 -10,10 -20,10 -20,-10 -10,-10 -10,-20 "
      "10,-20; fold w valley 180 -10,-20 -10,20 moving -15,0; fold s valley 180 -20,-10 20,-10 "
      "moving 0,-15; fold e valley 180 10,-20 10,20 moving 15,0; fold n valley 180 -20,10 20,10 "
      "moving 0,15");
  std::vector<LayerSet> sets = state.layers.sets();
  const FacetId west = facetOf(state, {-15, 0});
  const FacetId north = facetOf(state, {0, 15});
  const bool isUp = state.layers.isAbove(north, west);
  sets[0].exceptions.insert(isUp ? std::pair{west, north} : std::pair{north, west});
  state.layers = LayerOrder(std::move(sets));
  return state;
}

/// Pixels of a map as a slow depth buffer sees them, which shares no code with picking.
test::DepthPicture depthPictureOf(const FoldedState& state, const PaneMap& map, int step) {
  const ViewFrame& f = map.frame;
  const Vec2 low = map.toView({0, map.size.y});
  const Vec2 high = map.toView({map.size.x, 0});
  return test::depthPicture(state, {f.right, f.up, f.toEye, f.centre, f.eyeDistance}, {low, high},
                            static_cast<int>(map.size.x) / step,
                            static_cast<int>(map.size.y) / step);
}

struct Tally {
  int samples = 0;
  int onPaper = 0;
  int wrong = 0;
};

void compareWithDepthBuffer(const FoldedState& state, const PaneMap& map, Tally& tally) {
  const test::DepthPicture truth = depthPictureOf(state, map, 8);
  const Vec2 cell{map.size.x / truth.width, map.size.y / truth.height};
  test::DepthPicture picked = truth;
  for (int y = 0; y < truth.height; ++y) {
    for (int x = 0; x < truth.width; ++x) {
      const Vec2 pixels{(x + 0.5) * cell.x, (y + 0.5) * cell.y};
      const std::optional<PaperPick> pick = pickPaper(state, map, pixels);
      const auto at = static_cast<std::size_t>(y * truth.width + x);
      picked.samples[at] =
          pick ? static_cast<std::int32_t>(pick->spot.facet.index) : test::DepthPicture::kNothing;
      ++tally.samples;
      if (!pick) continue;
      ++tally.onPaper;
      EXPECT_LE(distance(map.toPixels(state, pick->spot), pixels), 1e-6);
      EXPECT_LE(distance(map.toPixels(pick->place), pixels), 1e-6);
      EXPECT_EQ(pick->showsFront, map.showsFront(state, pick->spot));
    }
  }
  tally.wrong += test::wrongSamples(picked, truth);
}

TEST(PickPaper, EqualsADepthBufferOnRandomPaperFromRandomSides) {
  Tally tally;
  for (std::uint64_t seed = 1; seed <= 25; ++seed) {
    const FoldedState state = test::randomState(seed);
    test::Random random(seed * 31);
    for (int i = 0; i < 2; ++i) {
      const int before = tally.wrong;
      compareWithDepthBuffer(state, test::randomCamera(random, state).map(), tally);
      EXPECT_EQ(tally.wrong, before) << "seed " << seed << " view " << i;
    }
  }
  EXPECT_GT(tally.onPaper, 12000);
  EXPECT_EQ(tally.wrong, 0);
}

/// Paper that was pushed through paper may lie in a ring over one place: then nothing is uppermost.
bool contradictsItself(const FoldedState& state, const PaneMap& map, Vec2 pixels) {
  const std::vector<PaperPick> stack = pickStack(state, map, pixels);
  const Neighbourhood near(state, map, pixels, 0);
  for (std::size_t i = 0; i < stack.size(); ++i) {
    for (std::size_t k = i + 1; k < stack.size(); ++k) {
      if (near.isOver(stack[k].spot.facet, stack[i].spot.facet, pixels)) return true;
    }
  }
  return false;
}

TEST(PickPaper, FindsTheFacetWhoseVisibleRegionHoldsThePixel) {
  int compared = 0;
  for (std::uint64_t seed = 100; seed <= 150; ++seed) {
    const FoldedState state = test::randomState(seed);
    test::Random random(seed);
    const PaneMap map = test::randomCamera(random, state).map();
    for (const VisibleFacet& visible : visibleRegions(state, map.frame).facets) {
      Region region;
      for (const auto& loop : visible.loops) {
        region.loops.emplace_back();
        for (const BoundaryPiece& piece : loop) region.loops.back().push_back(piece.arc);
      }
      const Box box = boundsOf(region);
      for (int i = 0; i < 20; ++i) {
        const Vec2 p{random.between(box.low.x, box.high.x), random.between(box.low.y, box.high.y)};
        if (locate(region, p, 1e-4) != Where::Inside) continue;
        const Vec2 off = p - map.centre;
        const Vec2 pixels{map.size.x / 2 + off.x * map.pixelsPerMm,
                          map.size.y / 2 - off.y * map.pixelsPerMm};
        const std::optional<PaperPick> pick = pickPaper(state, map, pixels);
        ASSERT_TRUE(pick.has_value()) << "seed " << seed;
        if (contradictsItself(state, map, pixels)) continue;
        EXPECT_EQ(pick->spot.facet.index, visible.facet.index) << "seed " << seed;
        EXPECT_EQ(pick->showsFront, visible.showsFront);
        ++compared;
      }
    }
  }
  EXPECT_GT(compared, 1500);
}

TEST(PickPaper, FlapsThatLieInARingArePickedAsTheyLie) {
  const FoldedState state = pinwheel();
  for (const bool isBack : {false, true}) {
    Tally tally;
    const Camera camera = isBack ? test::backCamera(state) : test::frontCamera(state);
    compareWithDepthBuffer(state, camera.map(), tally);
    EXPECT_EQ(tally.wrong, 0);
    EXPECT_GT(tally.onPaper, 300);
  }
  const PaneMap map = test::frontCamera(state).map();
  const auto at = [&](Vec2 model) {
    return pickPaper(state, map, map.toPixels(Vec3{model.x, model.y, 0}))->spot.facet;
  };
  std::vector<FacetId> seen{at({-5, 5}), at({5, 5}), at({5, -5}), at({-5, -5})};
  std::sort(seen.begin(), seen.end());
  EXPECT_EQ(std::unique(seen.begin(), seen.end()) - seen.begin(), 4) << "a quarter of each arm";
}

TEST(PickPaper, TrimsAndHolesAreNoPaper) {
  const FoldedState state =
      test::run("square 100; curve m:50,20 m:80,20 m:80,80 m:20,80 m:20,20 closed free keep 5,5");
  const PaneMap map = test::frontCamera(state).map();
  EXPECT_FALSE(pickPaper(state, map, map.toPixels(Vec3{50, 50, 0})).has_value());
  EXPECT_TRUE(pickPaper(state, map, map.toPixels(Vec3{5, 50, 0})).has_value());
  EXPECT_FALSE(pickPaper(state, map, map.toPixels(Vec3{-1, 50, 0})).has_value());
  const PaneMap sheet = test::sheetCamera(state).map();
  EXPECT_FALSE(pickPaper(state, sheet, sheet.toPixels(Vec3{50, 50, 0})).has_value());
  EXPECT_TRUE(pickPaper(state, sheet, sheet.toPixels(Vec3{5, 50, 0})).has_value());
}

TEST(PickPaper, ACreaseExactlyUnderThePixelLeavesNoCrack) {
  const FoldedState state = test::run(
      "square 100; fold valley 50,0 50,100 left; unfold all; fold valley 0,50 100,50 left; unfold "
      "all");
  for (const PaneMap& map : {test::frontCamera(state).map(), test::sheetCamera(state).map()}) {
    for (double at = 1; at < 100; at += 1) {
      EXPECT_TRUE(pickPaper(state, map, map.toPixels(Vec3{50, at, 0})).has_value());
      EXPECT_TRUE(pickPaper(state, map, map.toPixels(Vec3{at, 50, 0})).has_value());
    }
  }
}

TEST(PickStack, ListsAllLayersFromTheEyeOnBothSides) {
  const FoldedState state = test::run(
      "square 100; fold valley 50,0 50,100 left; fold valley m:50,50 m:100,50 left; fold mountain "
      "m:75,0 m:75,100 left");
  const PaneMap front = test::frontCamera(state).map();
  const PaneMap back = test::backCamera(state).map();
  const Vec3 place{90, 20, 0};
  std::vector<PaperPick> above = pickStack(state, front, front.toPixels(place));
  std::vector<PaperPick> below = pickStack(state, back, back.toPixels(place));
  ASSERT_EQ(above.size(), 8U);
  ASSERT_EQ(below.size(), 8U);
  for (std::size_t i = 0; i < 8; ++i) {
    EXPECT_EQ(above[i].spot.facet.index, below[7 - i].spot.facet.index);
    EXPECT_EQ(above[i].showsFront, !below[7 - i].showsFront);
    if (i > 0) EXPECT_TRUE(state.layers.isAbove(above[i - 1].spot.facet, above[i].spot.facet));
  }
  EXPECT_EQ(above.front().spot.facet, pickPaper(state, front, front.toPixels(place))->spot.facet);
}

TEST(PickStack, HoldsEveryFacetThatALineOfSightPierces) {
  int deepest = 0;
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    const FoldedState state = test::randomState(seed);
    test::Random random(seed * 13);
    const PaneMap map = test::randomCamera(random, state).map();
    for (int i = 0; i < 60; ++i) {
      const Vec2 pixels{random.between(0, map.size.x), random.between(0, map.size.y)};
      std::vector<std::uint32_t> expected;
      bool isClear = true;
      for (std::uint32_t f = 0; f < state.pattern.facets.size(); ++f) {
        const std::optional<Vec2> paper = map.onPlaneOf(state, FacetId(f), pixels);
        if (!paper) continue;
        const Where where = locate(regionOf(state.pattern, FacetId(f)), *paper, 1e-4);
        isClear = isClear && where != Where::OnBorder;
        if (where == Where::Inside) expected.push_back(f);
      }
      if (!isClear) continue;
      const std::vector<PaperPick> stack = pickStack(state, map, pixels);
      std::vector<std::uint32_t> found;
      for (const PaperPick& pick : stack) found.push_back(pick.spot.facet.index);
      for (std::size_t k = 1; k < found.size(); ++k) {
        const FacetId over(found[k - 1]), under(found[k]);
        if (state.layers.areCoplanar(over, under)) continue;
        EXPECT_GE(map.frame.depth(stack[k - 1].place), map.frame.depth(stack[k].place) - 1e-6);
      }
      std::sort(found.begin(), found.end());
      EXPECT_EQ(found, expected) << "seed " << seed;
      deepest = std::max(deepest, static_cast<int>(found.size()));
      if (stack.empty())
        EXPECT_FALSE(pickPaper(state, map, pixels).has_value());
      else
        EXPECT_EQ(stack.front().spot.facet, pickPaper(state, map, pixels)->spot.facet);
    }
  }
  EXPECT_GT(deepest, 3);
}

/// In how many directions next to each other, of so many, paper of the facet is seen right beside a
/// pixel. Few may be no more than a border along which nothing is told apart.
int seenDirections(const FoldedState& state, const PaneMap& map, FacetId facet, Vec2 pixels,
                   int directions = 1440) {
  const double step = state.tolerance().thin() * map.pixelsPerMm;
  int run = 0;
  int most = 0;
  for (int i = 0; i < directions; ++i) {
    const double a = (i + 0.3) * 2 * M_PI / directions;
    const std::optional<PaperPick> pick =
        pickPaper(state, map, pixels + Vec2{std::cos(a), std::sin(a)} * step);
    run = pick && pick->spot.facet == facet ? run + 1 : 0;
    most = std::max(most, run);
  }
  return most;
}

TEST(PickVertex, FindsTheNearestVertexThatIsSeen) {
  int found = 0;
  int none = 0;
  std::vector<std::uint64_t> seeds{522};  // corners that touch the middle of a steep flap
  for (std::uint64_t seed = 1; seed <= 24; ++seed) seeds.push_back(seed);
  for (const std::uint64_t seed : seeds) {
    const FoldedState state = test::randomState(seed);
    test::Random random(seed * 7);
    const PaneMap map = test::randomCamera(random, state).map();
    for (int i = 0; i < 16; ++i) {
      const FacetId target(random.below(state.pattern.facets.size()));
      const auto& border = state.pattern[target].border;
      const VertexId aim = startOf(state.pattern, border[random.below(border.size())]);
      const Vec2 pixels = map.toPixels(state, {target, state.pattern[aim]}) +
                          Vec2{random.between(-12, 12), random.between(-12, 12)};
      double nearest = 10;
      for (std::uint32_t f = 0; f < state.pattern.facets.size(); ++f) {
        if (isEdgeOn(state.poses[f], map.frame, state.tolerance())) continue;
        for (const EdgeUse use : state.pattern.facets[f].border) {
          const Vec2 at =
              map.toPixels(state, {FacetId(f), state.pattern[startOf(state.pattern, use)]});
          if (distance(at, pixels) >= nearest) continue;
          if (seenDirections(state, map, FacetId(f), at) > 7) nearest = distance(at, pixels);
        }
      }
      const std::optional<VertexPick> pick = pickVertex(state, map, pixels, 10);
      if (nearest < 10) ASSERT_TRUE(pick.has_value()) << "seed " << seed << " try " << i;
      ++(pick ? found : none);
      if (!pick) continue;
      // It may be nearer: a sliver that the slow search does not count.
      EXPECT_LE(pick->pixels, nearest + 0.5 + 1e-6) << "seed " << seed;
      EXPECT_EQ(pick->spot.paper, state.pattern[pick->vertex]);
      const Vec2 at = map.toPixels(state, pick->spot);
      EXPECT_NEAR(distance(at, pixels), pick->pixels, 1e-9);
      EXPECT_GT(seenDirections(state, map, pick->spot.facet, at), 0) << "seed " << seed;
    }
  }
  EXPECT_GT(found, 100);
  EXPECT_GT(none, 20);
}

TEST(PickVertex, ACornerIsCaughtFromBesideThePaper) {
  const FoldedState state = test::run("square 100");
  for (const PaneMap& map :
       {test::frontCamera(state).map(), test::backCamera(state).map(),
        test::sheetCamera(state).map(), test::sheetCamera(state, true).map()}) {
    const Vec2 corner = map.toPixels(Vec3{100, 100, 0});
    const Vec2 outward = normalized(corner - map.toPixels(Vec3{50, 50, 0}));
    const std::optional<VertexPick> pick = pickVertex(state, map, corner + outward * 6, 8);
    ASSERT_TRUE(pick.has_value());
    EXPECT_EQ(pick->spot.paper, (Vec2{100, 100}));
    EXPECT_NEAR(pick->pixels, 6, 1e-9);
    EXPECT_FALSE(pickVertex(state, map, corner + outward * 9, 8).has_value());
    const Vec2 middle = (corner + map.toPixels(Vec3{100, 0, 0})) / 2;
    const Vec2 across = normalized(middle - map.toPixels(Vec3{50, 50, 0}));
    const std::optional<EdgePick> edge = pickEdge(state, map, middle + across * 6, 8);
    ASSERT_TRUE(edge.has_value());
    EXPECT_LE(distance(edge->spot.paper, {100, 50}), 1e-9);
    EXPECT_FALSE(pickEdge(state, map, middle + across * 9, 8).has_value());
  }
}

TEST(PickVertex, OfCornersThatLieOnEachOtherTheUppermostIsTaken) {
  const FoldedState state = test::run("square 100; fold valley 50,0 50,100 left");
  const PaneMap front = test::frontCamera(state).map();
  const PaneMap back = test::backCamera(state).map();
  const Vec3 corner{100, 100, 0};
  EXPECT_EQ(pickVertex(state, front, front.toPixels(corner) + Vec2{3, -3}, 8)->spot.paper,
            (Vec2{0, 100}));
  EXPECT_EQ(pickVertex(state, back, back.toPixels(corner) + Vec2{-3, -3}, 8)->spot.paper,
            (Vec2{100, 100}));
}

TEST(PickVertex, ACornerUnderOtherPaperIsNotFound) {
  // The left third, folded over, hides the lower left corner of nothing; its own corners lie on
  // the middle of the sheet. From the back they are hidden.
  const FoldedState state = test::run("square 90; fold valley 30,0 30,90 left");
  const PaneMap front = test::frontCamera(state).map();
  const PaneMap back = test::backCamera(state).map();
  ASSERT_TRUE(pickVertex(state, front, front.toPixels(Vec3{60, 90, 0}), 8).has_value());
  // From the back the corners lie on the border of the paper that hides them, which is no cover.
  ASSERT_TRUE(pickVertex(state, back, back.toPixels(Vec3{60, 45, 0}), 8) == std::nullopt);
  const FoldedState inner = test::run("square 90; fold valley 0,40 40,0 to 1,1");
  const PaneMap above = test::frontCamera(inner).map();
  const PaneMap below = test::backCamera(inner).map();
  const Vec3 tip = inner.poseOf(facetOf(inner, {1, 1})).apply(Vec2{0, 0});
  EXPECT_LE(distance(tip, {40, 40, 0}), 1e-9);
  EXPECT_EQ(pickVertex(inner, above, above.toPixels(tip), 8)->spot.paper, (Vec2{0, 0}));
  EXPECT_FALSE(pickVertex(inner, below, below.toPixels(tip), 8).has_value());
}

TEST(PickVertex, TheFacetUnderThePointerIsPreferred) {
  const FoldedState state = test::run("square 100; fold valley 50,0 50,100 left; unfold all");
  const PaneMap map = test::frontCamera(state).map();
  const Vec2 end = map.toPixels(Vec3{50, 100, 0});
  for (const double side : {-3.0, 3.0}) {
    const VertexPick pick = pickVertex(state, map, end + Vec2{side, 3}, 8).value();
    EXPECT_EQ(pick.spot.facet, facetOf(state, {side < 0 ? 10.0 : 90.0, 50}));
    const EdgePick edge = pickEdge(state, map, end + Vec2{side, 40}, 8).value();
    EXPECT_EQ(edge.spot.facet, facetOf(state, {side < 0 ? 10.0 : 90.0, 50}));
    EXPECT_NEAR(edge.spot.paper.x, 50, 1e-12);
  }
}

TEST(PickVertex, WorksWhereTheHandHasZoomedInAsFarAsItGoes) {
  const FoldedState state = test::run("square 100; fold valley 50,0 50,100 left");
  Camera camera = test::frontCamera(state);
  const Vec3 corner{100, 100, 0};
  for (int i = 0; i < 60; ++i) camera.zoom(camera.map().toPixels(corner), 1.5);
  const PaneMap map = camera.map();
  EXPECT_GT(map.pixelsPerMm, 5000);
  const Vec2 at = map.toPixels(corner);
  for (const Vec2 off : {Vec2{0, 0}, Vec2{3, 4}, Vec2{-5, 5}}) {
    const std::optional<VertexPick> vertex = pickVertex(state, map, at + off, 8);
    ASSERT_TRUE(vertex.has_value());
    EXPECT_EQ(vertex->spot.paper, (Vec2{0, 100})) << "the uppermost";
  }
  const std::optional<EdgePick> edge = pickEdge(state, map, at + Vec2{5, 90}, 8);
  ASSERT_TRUE(edge.has_value());
  EXPECT_NEAR(edge->pixels, 5, 1e-3);
  EXPECT_EQ(edge->spot.facet, facetOf(state, {10, 50}));
}

TEST(PickEdge, InAStackTheUppermostOfEqualEdgesIsFoundFromEitherSide) {
  const FoldedState state = test::run(
      "square 80; fold a valley m:40,0 m:40,80 left; fold b valley m:0,40 m:80,40 left; fold c "
      "valley m:60,0 m:60,80 left; fold d valley m:60,20 m:80,20 left; fold e valley m:70,0 "
      "m:70,20 "
      "left");
  ASSERT_EQ(state.pattern.facets.size(), 32U);
  const ModelBox box = modelBoxOf(state);
  const Vec3 middle = box.middle();
  for (const bool isBack : {false, true}) {
    const PaneMap map = (isBack ? test::backCamera(state) : test::frontCamera(state)).map();
    const Vec2 inwards = map.toPixels(middle);
    for (const Vec3 place : {Vec3{box.low.x, middle.y, 0}, Vec3{box.high.x, middle.y, 0},
                             Vec3{middle.x, box.low.y, 0}, Vec3{middle.x, box.high.y, 0}}) {
      const Vec2 pixels = map.toPixels(place);
      const std::optional<PaperPick> top = pickPaper(state, map, lerp(pixels, inwards, 0.1));
      ASSERT_TRUE(top.has_value());
      const std::optional<EdgePick> edge = pickEdge(state, map, lerp(pixels, inwards, -0.02), 12);
      ASSERT_TRUE(edge.has_value());
      EXPECT_EQ(edge->spot.facet.index, top->spot.facet.index);
    }
  }
}

TEST(PickEdge, FindsTheNearestPointOfWhatIsSeenOfAnyEdge) {
  int found = 0;
  int none = 0;
  for (std::uint64_t seed = 1; seed <= 24; ++seed) {
    const FoldedState state = test::randomState(seed);
    test::Random random(seed * 11);
    const PaneMap map = test::randomCamera(random, state).map();
    for (int i = 0; i < 16; ++i) {
      const Vec2 pixels{random.between(0, map.size.x), random.between(0, map.size.y)};
      constexpr double kRadius = 30;
      double nearest = kRadius;
      for (std::uint32_t f = 0; f < state.pattern.facets.size(); ++f) {
        if (isEdgeOn(state.poses[f], map.frame, state.tolerance())) continue;
        for (const EdgeUse use : state.pattern.facets[f].border) {
          const Arc arc = arcOf(state.pattern, use);
          for (int k = 0; k <= 250; ++k) {
            const Vec2 at = map.toPixels(state, {FacetId(f), pointAt(arc, k / 250.0)});
            if (distance(at, pixels) >= nearest) continue;
            if (seenDirections(state, map, FacetId(f), at, 90) > 0) nearest = distance(at, pixels);
          }
        }
      }
      const std::optional<EdgePick> pick = pickEdge(state, map, pixels, kRadius);
      if (!pick) {
        EXPECT_GT(nearest, kRadius - 0.5) << "seed " << seed << " try " << i;
        ++none;
        continue;
      }
      ++found;
      // Between points of an edge the slow search may miss up to its step.
      EXPECT_LE(pick->pixels, nearest + 0.5 + 1e-6) << "seed " << seed << " try " << i;
      const Vec2 at = map.toPixels(state, pick->spot);
      EXPECT_NEAR(distance(at, pixels), pick->pixels, 0.05);
      EXPECT_GT(seenDirections(state, map, pick->spot.facet, at), 0) << "seed " << seed;
      const Arc arc = arcOf(state.pattern, pick->edge);
      EXPECT_LE(nearestOn(arc, pick->spot.paper).distance, 1e-9);
    }
  }
  EXPECT_GT(found, 50);
  EXPECT_GT(none, 30);
}

TEST(PickEdge, AnEdgeThatGoesUnderOtherPaperIsFoundWhereItComesOut) {
  // A crease across the sheet, half of it under the folded corner.
  const FoldedState state =
      test::run("square 90; fold valley 0,45 90,45 left; unfold all; fold valley 0,60 60,0 to 1,1");
  const PaneMap map = test::frontCamera(state).map();
  // The corner's border runs from (60, 0) to (60, 60); the crease comes out at x = 60.
  const Vec2 hidden = map.toPixels(Vec3{59.2, 45, 0});
  const EdgePick pick = pickEdge(state, map, hidden + Vec2{-2, 0}, 40).value();
  EXPECT_GT(pick.pixels, 0);
  const Vec3 place = map.placeOf(state, pick.spot);
  EXPECT_NEAR(place.x, 60, 0.01) << "the border of the corner is the nearest edge";
}

TEST(FacetsWithin, ARectangleHoldsWholeFacetsOnly) {
  const FoldedState state = test::run(
      "square 100; fold valley 50,0 50,100 left; unfold all; fold valley 0,50 100,50 left; unfold "
      "all");
  const PaneMap map = test::frontCamera(state).map();
  const auto within = [&](Vec2 a, Vec2 b) {
    return facetsWithin(state, map, map.toPixels(Vec3{a.x, a.y, 0}),
                        map.toPixels(Vec3{b.x, b.y, 0}));
  };
  EXPECT_EQ(within({-1, -1}, {101, 101}).size(), 4U);
  EXPECT_EQ(within({101, -1}, {-1, 101}).size(), 4U) << "drawn in any direction";
  EXPECT_EQ(within({-1, -1}, {51, 51}), std::vector{facetOf(state, {10, 10})});
  EXPECT_EQ(within({-1, -1}, {101, 51}).size(), 2U);
  EXPECT_TRUE(within({10, 10}, {40, 40}).empty());
}

}  // namespace
}  // namespace kiri::testing
