// Pictures asked for in words: from which side, on which page.
// SPDX-License-Identifier: MIT
#include "render/scene/view_spec.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "render/scene/model_scene.h"
#include "tests/support/model_text.h"

namespace kiri {
namespace {

FoldedState tent() {
  return test::run("square 100; fold valley 50,0 50,100 left; angle p:50,50 70");
}

TEST(ViewSpec, NumbersThatMeanNothingAreRefusedByName) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto sentence = [](ViewSpec spec) {
    const Status status = checkViewSpec(spec);
    return status.isOk() ? std::string() : status.error().message;
  };
  EXPECT_EQ(sentence({30, 40}), "");
  EXPECT_NE(sentence({nan, 40}).find("azimuth"), std::string::npos);
  EXPECT_NE(sentence({361, 40}).find("azimuth"), std::string::npos);
  EXPECT_NE(sentence({0, 91}).find("elevation"), std::string::npos);
  EXPECT_FALSE(modelScene(tent(), {}, ViewSpec{0, nan}).isOk());
}

TEST(ViewSpec, SphereHoldsTheModelAndJoinedHoldsBoth) {
  const FoldedState state = tent();
  const Sphere a = sphereOf(state);
  for (std::size_t i = 0; i < state.pattern.facets.size(); ++i) {
    for (const EdgeUse use : state.pattern.facets[i].border) {
      const Vec3 p = state.poses[i].apply(arcOf(state.pattern, use).start);
      EXPECT_LE(distance(a.centre, p), a.radius * (1 + 1e-12));
    }
  }
  const Sphere b{{300, 20, -5}, 12};
  const Sphere both = joined(a, b);
  EXPECT_NEAR(distance(both.centre, a.centre) + a.radius, both.radius, 1e-9);
  EXPECT_NEAR(distance(both.centre, b.centre) + b.radius, both.radius, 1e-9);
  EXPECT_EQ(joined(a, Sphere{a.centre, 1}).radius, a.radius);
  EXPECT_EQ(joined(Sphere{a.centre, 1}, a).radius, a.radius);
}

TEST(ViewSpec, PictureLiesInTheBoxOfItsSphereFromEverySide) {
  const FoldedState state = tent();
  const Sphere sphere = sphereOf(state);
  for (double azimuth = 0; azimuth < 360; azimuth += 45) {
    for (double elevation = -90; elevation <= 90; elevation += 30) {
      const ViewSpec spec{azimuth, elevation};
      const Box all = boxOf(*frameOf(spec, sphere), sphere);
      const Box box = *pictureBox(state, spec);
      EXPECT_LE(all.low.x, box.low.x + 1e-9);
      EXPECT_LE(all.low.y, box.low.y + 1e-9);
      EXPECT_GE(all.high.x, box.high.x - 1e-9);
      EXPECT_GE(all.high.y, box.high.y - 1e-9);
      EXPECT_NEAR(all.high.x - all.low.x, 2 * sphere.radius, 1e-9);
    }
  }
}

TEST(ViewSpec, PagesWithOneBoxHaveOneSizeAndThePaperAtItsPlace) {
  const ViewSpec spec{30, 40};
  ModelSceneOptions options;
  options.box = Box{{-100, -50}, {200, 150}};
  options.scale = 2;
  options.margin = 3;
  const FoldedState flat = test::run("square 100");
  const Result<Scene> a = modelScene(flat, {}, spec, options);
  const Result<Scene> b = modelScene(tent(), {}, spec, options);
  ASSERT_TRUE(a.isOk() && b.isOk());
  EXPECT_EQ(a->width, 2 * 300 + 2 * 3);
  EXPECT_EQ(a->height, 2 * 200 + 2 * 3);
  EXPECT_EQ(a->width, b->width);
  EXPECT_EQ(a->height, b->height);
  // The lower left corner of the sheet lies at the origin of the model frame.
  const Vec2 corner{3 + 2 * 100, 3 + 2 * 50};
  double nearest = std::numeric_limits<double>::infinity();
  for (const Group& group : a->groups) {
    if (group.id != "paper") continue;
    for (const Loop& loop : std::get<FillItem>(group.items.front().shape).loops) {
      for (const Arc& arc : loop) nearest = std::min(nearest, distance(arc.start, corner));
    }
  }
  EXPECT_LE(nearest, 1e-9);
}

TEST(ViewSpec, PictureBoxIsThatOfTheDrawnPage) {
  const ViewSpec spec{30, 40};
  const Result<Scene> scene = modelScene(tent(), {}, spec);
  const Result<Box> box = pictureBox(tent(), spec);
  ASSERT_TRUE(scene.isOk() && box.isOk());
  EXPECT_NEAR(scene->width, box->high.x - box->low.x + 10, 1e-12);
  EXPECT_NEAR(scene->height, box->high.y - box->low.y + 10, 1e-12);
}

}  // namespace
}  // namespace kiri
