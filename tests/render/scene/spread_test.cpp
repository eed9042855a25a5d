// Layers lifted off each other: every picture of them is of the paper, which stays as it is.
// SPDX-License-Identifier: MIT
#include "render/scene/spread.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "render/scene/model_scene.h"
#include "render/visibility/visible_regions.h"
#include "tests/support/model_text.h"
#include "tests/support/random_steps.h"

namespace kiri {
namespace {

constexpr const char* kFlaps =
    "square 100; fold valley 30,0 30,100 left; fold valley 85,0 85,100 right";

TEST(Spread, FacetsSideBySideStayLevel) {
  const FoldedState state = test::run(kFlaps);
  const FoldedState lifted = spread(state, 2, false);
  ASSERT_EQ(lifted.poses.size(), 3U);
  for (const Vec2 place : {Vec2{10, 50}, Vec2{50, 50}, Vec2{90, 50}}) {
    const FacetId facet = *facetAt(state.pattern, place);
    const Vec3 rise = lifted.poseOf(facet).apply(place) - state.poseOf(facet).apply(place);
    EXPECT_EQ(rise, (Vec3{0, 0, place.x == 50 ? 0.0 : 2.0})) << "the flaps do not overlap";
  }
}

TEST(Spread, SeenFromTheFrontNothingChanges) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    test::Random random(seed);
    const Model model = test::randomSheet(random);
    FoldedState state = test::startOf(model);
    for (int i = 0; i < 6; ++i) {
      const Step step = test::randomStep(random, state, {true, true, false, 40});
      if (Result<FoldedState> next = test::tryAfter(state, test::textOf(step)))
        state = std::move(*next);
    }
    if (!state.collisions.empty() || !isFlat(state)) continue;
    const bool hasRings = std::any_of(state.layers.sets().begin(), state.layers.sets().end(),
                                      [](const LayerSet& set) { return !set.exceptions.empty(); });
    if (hasRings) continue;
    const VisibleRegions flat = visibleRegions(state, frontView());
    const VisibleRegions lifted = visibleRegions(spread(state, 0.3, false), frontView());
    ASSERT_EQ(flat.facets.size(), lifted.facets.size()) << "seed " << seed;
    for (std::size_t i = 0; i < flat.facets.size(); ++i) {
      EXPECT_EQ(flat.facets[i].facet, lifted.facets[i].facet);
      EXPECT_NEAR(areaOf(flat.facets[i]), areaOf(lifted.facets[i]), 1e-3);
    }
  }
}

TEST(Spread, StripsCloseTheStepsAtTheHinges) {
  const FoldedState state = test::run(kFlaps);
  const FoldedState lifted = spread(state, 2, true);
  ASSERT_EQ(lifted.pattern.facets.size(), 5U) << "one strip for each folded hinge";
  for (std::size_t f = 3; f < 5; ++f) {
    const Region strip = regionOf(lifted.pattern, FacetId(f));
    EXPECT_NEAR(areaOf(strip), 200, 1e-9);
    for (const Arc& arc : strip.loops.front()) {
      const Vec3 p = lifted.poses[f].apply(arc.start);
      EXPECT_NEAR(std::abs(p.x - 57.5), 27.5, 1e-9);
      EXPECT_NEAR(std::abs(p.z - 1), 1, 1e-9) << "from one layer to the other";
    }
  }
  // From the side the outside of the bend is seen, which is the back of the paper at a valley.
  const VisibleRegions side = visibleRegions(lifted, viewFrom(90, 10));
  const auto strip = std::find_if(side.facets.begin(), side.facets.end(),
                                  [](const VisibleFacet& f) { return f.facet.index >= 3; });
  ASSERT_NE(strip, side.facets.end());
  EXPECT_FALSE(strip->showsFront);
  EXPECT_NEAR(areaOf(*strip), 200 * std::cos(10 * M_PI / 180), 1e-6);
}

TEST(Spread, OutermostStripOfNestedFoldsIsSeen) {
  const FoldedState state =
      test::run("square 100; fold valley 50,0 50,100 left; fold valley m:50,50 m:100,50 left");
  const FoldedState lifted = spread(state, 1, true);
  const VisibleRegions side = visibleRegions(lifted, viewFrom(180, 5));
  double widest = 0;
  for (const VisibleFacet& f : side.facets) {
    if (f.facet.index >= state.pattern.facets.size()) widest = std::max(widest, areaOf(f));
  }
  EXPECT_NEAR(widest, 50 * 3 * std::cos(5 * M_PI / 180), 1e-6) << "three layers high, 50 mm long";
}

TEST(Spread, PartlyFoldedFlapLiftsAlongItsOwnPlane) {
  const FoldedState state = test::run(
      "square 100; fold valley 50,0 50,100 left; fold valley m:50,50 m:100,50 left; angle p:75,50 "
      "90");
  const FoldedState lifted = spread(state, 2, false);
  for (std::size_t f = 0; f < state.poses.size(); ++f) {
    const Vec3 rise = lifted.poses[f].origin - state.poses[f].origin;
    EXPECT_LE(length(cross(rise, state.poses[f].normal())), 1e-12);
  }
}

const Group* groupNamed(const Scene& scene, const std::string& id) {
  for (const Group& group : scene.groups) {
    if (group.id == id) return &group;
  }
  return nullptr;
}

TEST(Shade, PaperThatFacesTheEyeKeepsItsColourOnBothSides) {
  Appearance looks;
  ViewSpec spec = frontSpec();
  spec.isShaded = true;
  const Scene scene = *modelScene(test::run(kFlaps), looks, spec);
  for (const Item& item : groupNamed(scene, "paper")->items) {
    EXPECT_EQ(std::get<FillItem>(item.shape).fill.color,
              item.kind == "front" ? looks.front.color : looks.back.color);
  }
}

TEST(Shade, FacetsTurnedFromTheLampAreDarkerAndTexturesGetAVeil) {
  const FoldedState state = test::run(
      "square 100; fold mountain 60 40,0 40,100 left; fold mountain 60 60,0 60,100 right");
  Appearance looks;
  looks.front.color = {200, 100, 50};
  ViewSpec spec = frontSpec();
  spec.isShaded = true;
  const auto redOf = [&](const Scene& scene, Vec2 place) {
    const std::string id = "facet-" + std::to_string(facetAt(state.pattern, place)->index);
    for (const Item& item : groupNamed(scene, "paper")->items) {
      if (item.id == id) return int{std::get<FillItem>(item.shape).fill.color.red};
    }
    return -1;
  };
  const Scene plain = *modelScene(state, looks, spec);
  EXPECT_EQ(redOf(plain, {50, 50}), 200);
  EXPECT_LT(redOf(plain, {80, 50}), redOf(plain, {20, 50})) << "the lamp stands on the left";
  EXPECT_EQ(groupNamed(plain, "shades"), nullptr);
  looks.front.texture = std::make_shared<Image>(Image{1, 1, {0, 0, 0, 255}});
  const Scene textured = *modelScene(state, looks, spec);
  ASSERT_NE(groupNamed(textured, "shades"), nullptr);
  EXPECT_EQ(groupNamed(textured, "shades")->items.size(), 2U) << "the middle needs none";
}

TEST(Shadow, LiesBelowThePaperWithinThePageAndOnlyForAnEyeAboveTheTable) {
  const FoldedState state = test::run("square 100; fold valley 60 30,0 30,100 left");
  ViewSpec spec{20, 35, 40};
  spec.hasShadow = true;
  const Scene scene = *modelScene(state, {}, spec);
  const Group* shadow = groupNamed(scene, "shadow");
  ASSERT_NE(shadow, nullptr);
  EXPECT_EQ(scene.groups.front().id, "shadow") << "the paper is drawn over it";
  for (const Item& item : shadow->items) {
    const FillItem& fill = std::get<FillItem>(item.shape);
    EXPECT_LT(fill.fill.opacity, 0.1);
    for (const Loop& loop : fill.loops) {
      EXPECT_GT(signedAreaOf(loop), 0) << "the silhouette has no holes here";
      for (const Arc& arc : loop) {
        EXPECT_GE(std::min(arc.start.x, arc.start.y), 5 - 1e-9);
        EXPECT_LE(arc.start.x, scene.width - 5 + 1e-9);
        EXPECT_LE(arc.start.y, scene.height - 5 + 1e-9);
      }
    }
  }
  spec.elevation = -20;
  EXPECT_EQ(groupNamed(*modelScene(state, {}, spec), "shadow"), nullptr);
}

TEST(Shadow, CanBeStoppedOnTheWay) {
  ViewSpec spec{20, 35};
  spec.hasShadow = true;
  ModelSceneOptions options;
  int asked = 0;
  options.progress = [&](double) { return ++asked < 5; };
  const Result<Scene> scene = modelScene(test::run(kFlaps), {}, spec, options);
  ASSERT_FALSE(scene.isOk());
  EXPECT_EQ(scene.error().code, ErrorCode::Cancelled);
  EXPECT_EQ(asked, 5);
}

TEST(Shadow, PageHoldsItAsPictureBoxSays) {
  const FoldedState state = test::run(kFlaps);
  ViewSpec spec{20, 35};
  spec.hasShadow = true;
  spec.explode = 10;
  const Scene scene = *modelScene(state, {}, spec);
  const Box box = *pictureBox(state, spec);
  EXPECT_NEAR(scene.width, box.high.x - box.low.x + 10, 1e-12);
  EXPECT_NEAR(scene.height, box.high.y - box.low.y + 10, 1e-12);
  const Sphere sphere = sphereOf(state, spec);
  const Box all = boxOf(*frameOf(spec, sphere), sphere);
  EXPECT_LE(all.low.x, box.low.x + 1e-9);
  EXPECT_GE(all.high.y, box.high.y - 1e-9);
}

}  // namespace
}  // namespace kiri
