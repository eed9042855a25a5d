// What a point that is being drawn is caught by.
// SPDX-License-Identifier: MIT
#include "editor/snap/snap.h"

#include <gtest/gtest.h>

#include <cmath>
#include <optional>
#include <string>
#include <variant>

#include "core/paper/boxes.h"
#include "editor/snap/snap_dragged.h"
#include "editor/view/seen_places.h"
#include "tests/support/model_text.h"
#include "tests/support/views.h"

namespace kiri::testing {
namespace {

FacetId facetOf(const FoldedState& state, Vec2 paper) {
  return facetAt(state.pattern, paper).value();
}

SnapSettings only(SnapKind kind) {
  SnapSettings settings;
  settings.toVertices = kind == SnapKind::Vertex;
  settings.toMidpoints = kind == SnapKind::Midpoint;
  settings.toCrossings = kind == SnapKind::Crossing;
  settings.toEdges = kind == SnapKind::Edge;
  return settings;
}

std::string labelOf(const std::optional<Snapped>& snapped) {
  return snapped ? inEnglish(snapped->label) : "(nothing)";
}

/// A catch is shown by a point, a word, and for lines a path.
void expectShown(const Snapped& snapped) {
  int points = 0;
  int texts = 0;
  for (const Mark& mark : snapped.marks) {
    if (std::get_if<PointMark>(&mark)) ++points;
    if (const TextMark* text = std::get_if<TextMark>(&mark)) {
      ++texts;
      EXPECT_EQ(text->text, snapped.label);
    }
  }
  const bool isCaught = snapped.kind != SnapKind::None;
  EXPECT_EQ(points, isCaught ? 1 : 0);
  EXPECT_EQ(texts, isCaught ? 1 : 0);
  EXPECT_EQ(snapped.label.isEmpty(), !isCaught);
}

TEST(SnapPoint, CatchesACornerAMiddleADivisionAndAnEdgeInBothPanes) {
  const FoldedState state = test::run("square 90; fold valley 45,0 45,90 left; unfold all");
  SnapSettings settings;
  settings.divisions = 3;
  for (const PaneMap& map :
       {test::frontCamera(state).map(), test::backCamera(state).map(),
        test::sheetCamera(state).map(), test::sheetCamera(state, true).map()}) {
    const auto at = [&](Vec2 paper, Vec2 off) {
      const auto snapped =
          snapPoint(state, map, map.toPixels(Vec3{paper.x, paper.y, 0}) + off, settings);
      if (snapped) expectShown(*snapped);
      return snapped;
    };
    const auto corner = at({90, 90}, {2, -3});
    EXPECT_EQ(labelOf(corner), "corner");
    EXPECT_EQ(corner->spot.paper, (Vec2{90, 90}));
    const auto vertex = at({45, 90}, {1, 2});
    EXPECT_EQ(labelOf(vertex), "vertex");
    EXPECT_EQ(vertex->spot.paper, (Vec2{45, 90}));
    const auto middle = at({90, 45}, {-2, 2});
    EXPECT_EQ(labelOf(middle), "middle");
    EXPECT_EQ(middle->spot.paper, (Vec2{90, 45}));
    const auto third = at({45, 30}, {2, 2});
    EXPECT_EQ(labelOf(third), "1/3");
    EXPECT_LE(distance(third->spot.paper, {45, 30}), 1e-12);
    EXPECT_EQ(labelOf(at({45, 20}, {3, 0})), "crease");
    const auto edge = at({90, 20}, {3, 0});
    EXPECT_EQ(labelOf(edge), "edge");
    EXPECT_EQ(edge->spot.paper.x, 90);
    const auto free = at({70, 20}, {0, 0});
    EXPECT_EQ(free->kind, SnapKind::None);
    EXPECT_LE(distance(free->spot.paper, {70, 20}), 1e-9);
    EXPECT_FALSE(at({110, 110}, {0, 0}).has_value()) << "no paper near";
  }
}

TEST(SnapPoint, WhatIsNearerWinsAndPointsWinOverEdges) {
  const FoldedState state = test::run("square 100");
  const PaneMap map = test::frontCamera(state).map();
  const Vec2 corner = map.toPixels(Vec3{100, 100, 0});
  const auto kindAt = [&](Vec2 off) { return snapPoint(state, map, corner + off, {})->kind; };
  EXPECT_EQ(kindAt({0, 4}), SnapKind::Vertex) << "the edge is nearer, but not by much";
  EXPECT_EQ(kindAt({0, 9}), SnapKind::Edge);
  EXPECT_EQ(kindAt({6, 6}), SnapKind::Vertex) << "from beside the paper";
  SnapSettings settings;
  settings.isOn = false;
  EXPECT_EQ(snapPoint(state, map, corner + Vec2{-2, 2}, settings)->kind, SnapKind::None);
  EXPECT_FALSE(snapPoint(state, map, corner + Vec2{2, -2}, settings).has_value());
}

TEST(SnapPoint, VerticesOfThePlaneAreExactInTheFrameOfTheLine) {
  // Two flaps on one sheet, turned by an odd angle: nothing has round coordinates.
  const FoldedState state = test::run(
      "square 100; rotate 17.3; fold valley 0,30 30,0 to 1,1; fold right valley 100,37 63,0 to "
      "99,1");
  const PaneMap map = test::frontCamera(state).map();
  const FacetId base = facetOf(state, {50, 60});
  const FacetId flap = facetOf(state, {1, 1});
  for (const FacetId frame : {base, flap}) {
    for (const FacetId owner : {base, flap}) {
      for (const EdgeUse use : state.pattern[owner].border) {
        const Vec2 vertex = state.pattern[startOf(state.pattern, use)];
        const Vec3 place = state.poseOf(owner).apply(vertex);
        const auto snapped =
            snapPoint(state, map, map.toPixels(place) + Vec2{1, 1}, only(SnapKind::Vertex), frame);
        ASSERT_TRUE(snapped.has_value());
        if (snapped->kind == SnapKind::None) continue;  // under the flaps
        EXPECT_EQ(snapped->spot.facet, frame);
        EXPECT_LE(distance(map.placeOf(state, snapped->spot), place), 1e-12 * 100);
        bool isOwn = false;
        for (const EdgeUse own : state.pattern[frame].border) {
          const Vec2 other = state.pattern[startOf(state.pattern, own)];
          if (distance(other, snapped->spot.paper) > 1e-6) continue;
          isOwn = true;
          EXPECT_EQ(snapped->spot.paper, other) << "to the last bit";
        }
        if (owner == frame) EXPECT_TRUE(isOwn);
      }
    }
  }
  const auto tip = snapPoint(state, map, map.toPixels(state, {flap, {0, 0}}), {}, base);
  EXPECT_EQ(labelOf(tip), "corner") << "a corner of the flap, for a line on the sheet below it";
}

TEST(SnapPoint, OnTheSheetAllVerticesCountAsTheyAre) {
  const FoldedState state = test::run("square 100; fold valley 40,0 61,100 left");
  const PaneMap map = test::sheetCamera(state).map();
  const FacetId right = facetOf(state, {90, 50});
  for (const Vec2 vertex : state.pattern.vertices) {
    const Vec2 pixels = map.toPixels(Vec3{vertex.x, vertex.y, 0});
    const auto snapped = snapPoint(state, map, pixels + Vec2{2, 2}, {}, right);
    ASSERT_TRUE(snapped.has_value());
    EXPECT_EQ(snapped->kind, SnapKind::Vertex);
    EXPECT_EQ(snapped->spot.facet, right);
    EXPECT_EQ(snapped->spot.paper, vertex);
  }
}

TEST(SnapPoint, WithAFrameOnlyItsPlaneCounts) {
  const FoldedState state = test::run("square 100; fold valley 60 50,0 50,100 left");
  const PaneMap map = test::frontCamera(state).map();
  const FacetId flat = facetOf(state, {90, 50});
  const FacetId raised = facetOf(state, {10, 50});
  const Vec2 tip = map.toPixels(state, {raised, {0, 100}});
  EXPECT_EQ(snapPoint(state, map, tip, {})->spot.paper, (Vec2{0, 100}));
  EXPECT_EQ(snapPoint(state, map, tip, {}, raised)->spot.paper, (Vec2{0, 100}));
  const auto inPlane = snapPoint(state, map, tip, only(SnapKind::Vertex), flat);
  EXPECT_EQ(inPlane->kind, SnapKind::None) << "it is above the plane of the line";
  EXPECT_EQ(inPlane->spot.facet, flat);
  EXPECT_LE(distance(map.toPixels(state, inPlane->spot), tip), 1e-9);
}

TEST(SnapPoint, APlaneSeenEdgeOnTakesNoPoint) {
  const FoldedState state = test::run("square 100; fold valley 90 50,0 50,100 left");
  const PaneMap map = test::frontCamera(state).map();
  EXPECT_FALSE(snapPoint(state, map, {400, 300}, {}, facetOf(state, {10, 50})).has_value());
}

TEST(SnapPoint, WhatLiesUnderOtherPaperIsNotCaught) {
  // The tip of a mountain-folded corner, under the sheet.
  const FoldedState state = test::run("square 90; fold mountain 0,40 40,0 to 1,1");
  const PaneMap front = test::frontCamera(state).map();
  const PaneMap back = test::backCamera(state).map();
  const Vec3 tip = state.poseOf(facetOf(state, {1, 1})).apply(Vec2{0, 0});
  EXPECT_EQ(snapPoint(state, front, front.toPixels(tip), {})->kind, SnapKind::None);
  EXPECT_EQ(snapPoint(state, back, back.toPixels(tip), {})->spot.paper, (Vec2{0, 0}));
}

TEST(SnapPoint, AnEdgeOverACreaseGivesTheirCrossing) {
  // A crease at y = 45; the folded corner's border stands on it at x = 60.
  const FoldedState state = test::run(
      "square 90; fold valley 0,45 90,45 left; unfold all; fold corner valley 0,60 60,0 to 1,1");
  const PaneMap map = test::frontCamera(state).map();
  const Vec2 pixels = map.toPixels(Vec3{60, 45, 0});
  for (const auto frame : {std::optional<FacetId>{}, std::optional{facetOf(state, {80, 80})}}) {
    const auto snapped =
        snapPoint(state, map, pixels + Vec2{2, 1}, only(SnapKind::Crossing), frame);
    ASSERT_EQ(labelOf(snapped), "crossing");
    EXPECT_LE(distance(map.placeOf(state, snapped->spot), {60, 45, 0}), 1e-9);
    expectShown(*snapped);
  }
  // Where the crease runs on under the corner nothing crosses that is seen.
  const Vec2 under = map.toPixels(Vec3{30, 45, 0});
  EXPECT_EQ(snapPoint(state, map, under, only(SnapKind::Crossing))->kind, SnapKind::None);
}

TEST(SnapPoint, AngleStepsCountFromTheEdgeOfTheStart) {
  const FoldedState state = test::run("polygon 0,0 80,60 20,140 -60,80");  // a leaning square
  const PaneMap map = test::frontCamera(state).map();
  const FacetId facet = facetOf(state, {10, 70});
  SnapSettings settings = only(SnapKind::None);
  settings.angleStep = 22.5;
  const Vec2 from{40, 30};  // the middle of the lowest side
  const Vec2 side = Vec2{80, 60} / 100;
  for (int k = 1; k < 8; ++k) {
    const double a = k * 22.5 * M_PI / 180;
    const Vec2 along = side * std::cos(a) + perpendicular(side) * std::sin(a);
    const Vec2 meant = from + along * 37;
    const Vec2 pixels = map.toPixels(state, {facet, meant + perpendicular(along) * 0.8});
    const auto snapped = snapPoint(state, map, pixels, settings, facet, from);
    ASSERT_EQ(snapped->kind, SnapKind::Angle) << k;
    EXPECT_LE(distance(snapped->spot.paper, meant), 1e-9);
    const char* labels[] = {"22.5°", "45°", "67.5°", "90°", "112.5°", "135°", "157.5°"};
    EXPECT_EQ(labelOf(snapped), labels[k - 1]);
    expectShown(*snapped);
  }
  // From the middle of the paper they count from the x axis.
  const Vec2 inner{10, 70};
  const Vec2 pixels = map.toPixels(state, {facet, inner + Vec2{30, 0.5}});
  const auto level = snapPoint(state, map, pixels, settings, facet, inner);
  EXPECT_EQ(labelOf(level), "0°");
  EXPECT_EQ(level->spot.paper.y, 70);
}

TEST(SnapPoint, ADirectionEndsOnAnEdgeExactly) {
  const FoldedState state = test::run("square 100");
  const PaneMap map = test::frontCamera(state).map();
  const FacetId facet(std::size_t{0});
  SnapSettings settings;
  settings.angleStep = 22.5;
  const Vec2 meant{100, 100 * std::tan(22.5 * M_PI / 180)};
  for (const Vec2 off : {Vec2{0, 0}, Vec2{3, 2}, Vec2{-3, -4}, Vec2{5, 0}}) {
    const auto snapped = snapPoint(state, map, map.toPixels(state, {facet, meant}) + off, settings,
                                   facet, Vec2{0, 0});
    ASSERT_TRUE(snapped.has_value());
    EXPECT_EQ(labelOf(snapped), "22.5°");
    EXPECT_LE(distance(snapped->spot.paper, meant), 1e-10);
  }
}

TEST(SnapPoint, TheGridIsThatOfThePaper) {
  const FoldedState state = test::run("square 100; rotate 30; fold valley 50,0 50,100 left");
  const PaneMap map = test::frontCamera(state).map();
  SnapSettings settings = only(SnapKind::None);
  settings.gridSpacing = 12.5;
  const FacetId facet = facetOf(state, {90, 50});
  const auto snapped =
      snapPoint(state, map, map.toPixels(state, {facet, {87.9, 37.2}}), settings, facet);
  EXPECT_EQ(labelOf(snapped), "grid");
  EXPECT_EQ(snapped->spot.paper, (Vec2{87.5, 37.5}));
  expectShown(*snapped);
}

TEST(SnapPoint, CurvedEdgesAreCaughtOnTheCurve) {
  const FoldedState state = test::run("disc 100");
  const Box box = paperBoxOf(state.pattern);
  const Vec2 centre = (box.low + box.high) / 2;
  const double radius = (box.high.x - box.low.x) / 2;
  const PaneMap map = test::frontCamera(state).map();
  for (int i = 0; i < 40; ++i) {
    const double a = i * 0.157;
    const Vec2 rim = centre + Vec2{std::cos(a), std::sin(a)} * radius;
    const auto snapped = snapPoint(state, map, map.toPixels(Vec3{rim.x, rim.y, 0}) + Vec2{4, 3},
                                   only(SnapKind::Edge));
    ASSERT_TRUE(snapped.has_value());
    EXPECT_EQ(snapped->kind, SnapKind::Edge);
    EXPECT_NEAR(distance(snapped->spot.paper, centre), radius, 1e-6);
  }
}

TEST(SnapPoint, OnRandomPaperACatchIsNearIsSeenAndLiesInThePlane) {
  int caught = 0;
  int framed = 0;
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    const FoldedState state = test::randomState(seed);
    test::Random random(seed * 19);
    const bool isSheet = random.chance(0.2);
    const PaneMap map = isSheet ? test::sheetCamera(state, random.chance(0.5)).map()
                                : test::randomCamera(random, state).map();
    SnapSettings settings;
    settings.divisions = static_cast<int>(random.below(6));
    settings.angleStep = random.chance(0.5) ? 22.5 : 0;
    settings.gridSpacing = random.chance(0.3) ? 10 : 0;
    for (int i = 0; i < 40; ++i) {
      const FacetId target(random.below(state.pattern.facets.size()));
      const auto& border = state.pattern[target].border;
      const Arc arc = arcOf(state.pattern, border[random.below(border.size())]);
      const Vec2 pixels = map.toPixels(state, {target, pointAt(arc, random.unit())}) +
                          Vec2{random.between(-12, 12), random.between(-12, 12)};
      std::optional<FacetId> frame;
      std::optional<Vec2> from;
      if (random.chance(0.5)) frame = FacetId(random.below(state.pattern.facets.size()));
      if (frame && random.chance(0.7)) from = interiorPointOf(state.pattern, *frame);
      const auto snapped = snapPoint(state, map, pixels, settings, frame, from);
      if (!snapped) continue;
      expectShown(*snapped);
      if (frame) {
        ++framed;
        EXPECT_EQ(snapped->spot.facet, *frame);
      }
      const Vec2 at = map.toPixels(state, snapped->spot);
      EXPECT_LE(distance(at, pixels), settings.radius + 1e-6) << "seed " << seed << " try " << i;
      if (snapped->kind == SnapKind::None) {
        EXPECT_LE(distance(at, pixels), 1e-6);
        continue;
      }
      ++caught;
      if (snapped->kind == SnapKind::Angle || snapped->kind == SnapKind::Grid) continue;
      // The mark names the paper that has it, and that paper is seen there.
      for (const Mark& mark : snapped->marks) {
        const PointMark* point = std::get_if<PointMark>(&mark);
        if (!point) continue;
        const Spot spot = std::get<Spot>(point->at);
        EXPECT_LE(distance(map.toPixels(state, spot), at), 1e-6);
        const Neighbourhood near(state, map, at, 1);
        SeenPlaces seen(near);
        EXPECT_TRUE(seen.has(spot.facet, at)) << "seed " << seed << " try " << i;
      }
    }
  }
  EXPECT_GT(caught, 700);
  EXPECT_GT(framed, 500);
}

TEST(SnapPoint, AVertexThatIsPickedNearbyIsCaught) {
  int compared = 0;
  int same = 0;
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    const FoldedState state = test::randomState(seed);
    test::Random random(seed * 3);
    const PaneMap map = test::randomCamera(random, state).map();
    for (const Vec2 vertex : state.pattern.vertices) {
      const auto facet = facetAt(state.pattern, vertex);
      if (!facet) continue;
      const Vec2 pixels = map.toPixels(state, {*facet, vertex}) +
                          Vec2{random.between(-2, 2), random.between(-2, 2)};
      const auto picked = pickVertex(state, map, pixels, 3);
      if (!picked) continue;
      const auto snapped = snapPoint(state, map, pixels, only(SnapKind::Vertex));
      ASSERT_TRUE(snapped.has_value());
      EXPECT_EQ(snapped->kind, SnapKind::Vertex);
      // Of vertices that a hand cannot tell apart either may be meant.
      EXPECT_LE(distance(map.toPixels(state, snapped->spot), map.toPixels(state, picked->spot)), 1)
          << "seed " << seed;
      if (snapped->spot.paper == picked->spot.paper) ++same;
      ++compared;
    }
  }
  EXPECT_GT(compared, 200);
  EXPECT_GT(same, compared * 9 / 10);
}

TEST(SnapDragged, OnlyEdgesCatchInTheDirectionsOfFolders) {
  const FoldedState state = test::run("square 100");
  const PaneMap map = test::frontCamera(state).map();
  const FacetId sheet(0);
  const double pixel = 1 / map.pixelsPerMm;
  const double exact = 100 * (std::sqrt(2) - 1);  // tan 22.5 degrees of the side
  const auto at = [&](Vec2 mm) {
    const Vec2 pixels = map.toPixels(Vec3{mm.x, mm.y, 0});
    return snapDragged(state, map, pixels, SnapSettings{}, sheet, {0, 0});
  };
  const auto onEdge = at({exact - 2 * pixel, 100 - pixel});
  ASSERT_TRUE(onEdge);
  EXPECT_NEAR(distance(onEdge->spot.paper, {exact, 100}), 0, 1e-9);
  const Vec2 free{exact * 0.6, 60 + pixel};
  EXPECT_EQ(at(free)->kind, SnapKind::None);
  SnapSettings off;
  off.isOn = false;
  const auto unsnapped =
      snapDragged(state, map, map.toPixels(Vec3{exact - 2 * pixel, 100, 0}), off, sheet, {0, 0});
  EXPECT_GT(distance(unsnapped->spot.paper, {exact, 100}), pixel);
}

}  // namespace
}  // namespace kiri::testing
