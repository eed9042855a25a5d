// Pictures asked for in words: from which side, on which page.
// SPDX-License-Identifier: MIT
#include "render/scene/view_spec.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <memory>
#include <string>
#include <vector>

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
      for (const double fieldOfView : {0.0, 25.0, 100.0}) {
        const ViewSpec spec{azimuth, elevation, fieldOfView};
        const Box all = boxOf(*frameOf(spec, sphere), sphere);
        const Box box = *pictureBox(state, spec);
        EXPECT_LE(all.low.x, box.low.x + 1e-9);
        EXPECT_LE(all.low.y, box.low.y + 1e-9);
        EXPECT_GE(all.high.x, box.high.x - 1e-9);
        EXPECT_GE(all.high.y, box.high.y - 1e-9);
        if (fieldOfView == 0) {
          EXPECT_NEAR(all.high.x - all.low.x, 2 * sphere.radius, 1e-9);
        }
      }
    }
  }
}

TEST(ViewSpec, EyeInsideTheModelIsRefusedWithTheLeastDistance) {
  const Sphere sphere = sphereOf(tent());
  EXPECT_TRUE(withEye(frontView(), sphere, 2 * sphere.radius).isOk());
  const Result<ViewFrame> inside = withEye(frontView(), sphere, 0.9 * sphere.radius);
  ASSERT_FALSE(inside.isOk());
  EXPECT_NE(inside.error().message.find("choose at least"), std::string::npos);
  ModelSceneOptions options;
  options.sphere = Sphere{sphere.centre, sphere.radius / 3};  // of some smaller state
  EXPECT_FALSE(modelScene(tent(), {}, ViewSpec{30, 40, 100}, options).isOk());
  options.sphere = Sphere{sphere.centre, sphere.radius * 2};
  EXPECT_TRUE(modelScene(tent(), {}, ViewSpec{30, 40, 100}, options).isOk());
}

TEST(ViewSpec, TextureInPerspectiveLiesOnThePaper) {
  // Red grows with x on the paper, green with y.
  auto image = std::make_shared<Image>(Image{128, 128, {}});
  for (int row = 0; row < 128; ++row) {
    for (int column = 0; column < 128; ++column) {
      const auto y = static_cast<std::uint8_t>(2 * (127 - row));
      image->rgba.insert(image->rgba.end(), {static_cast<std::uint8_t>(2 * column), y, 0, 255});
    }
  }
  Appearance looks;
  looks.textureBox = {{0, 0}, {100, 100}};
  looks.front.texture = looks.back.texture = image;
  const FoldedState state = tent();
  ModelSceneOptions options;
  options.margin = 0;
  options.box = Box{{-300, -300}, {300, 300}};
  const ViewSpec spec{20, 50, 90};
  const ViewFrame view = *frameOf(spec, sphereOf(state));
  const Result<Scene> scene = modelScene(state, looks, spec, options);
  ASSERT_TRUE(scene.isOk());
  int asked = 0;
  for (const Group& group : scene->groups) {
    if (group.id != "paper") continue;
    for (const Item& item : group.items) {
      const Fill& fill = std::get<FillItem>(item.shape).fill;
      const auto facet = static_cast<std::size_t>(item.id.back() - '0');
      for (const Vec2 onPaper : {Vec2{10, 20}, Vec2{40, 85}, Vec2{60, 20}, Vec2{90, 85}}) {
        if (facetAt(state.pattern, onPaper)->index != facet) continue;
        const Vec2 at = view.project(state.poses[facet].apply(onPaper)) + Vec2{300, 300};
        const Affine& map = fill.imageToScene;
        const Vec2 unit{(at.x - map.e) / map.a, (at.y - map.f) / map.d};
        const auto column = static_cast<std::size_t>(unit.x * fill.image->width);
        const auto row = static_cast<std::size_t>((1 - unit.y) * fill.image->height);
        const std::uint8_t* pixel =
            &fill.image->rgba[(row * static_cast<std::size_t>(fill.image->width) + column) * 4];
        const double x = item.kind == "front" ? onPaper.x : 100 - onPaper.x;
        EXPECT_NEAR(pixel[0], 2.56 * x, 3);
        EXPECT_NEAR(pixel[1], 2.56 * onPaper.y, 3);
        ++asked;
      }
    }
  }
  EXPECT_EQ(asked, 4);
}

std::vector<Arc> edgesOf(const Scene& scene) {
  std::vector<Arc> out;
  for (const Group& group : scene.groups) {
    if (group.id != "edges") continue;
    for (const auto& chain : std::get<StrokeItem>(group.items.front().shape).chains) {
      out.insert(out.end(), chain.begin(), chain.end());
    }
  }
  return out;
}

TEST(ViewSpec, FlatSheetSeenEdgeOnIsALine) {
  const Scene scene = *modelScene(test::run("square 100"), {}, ViewSpec{0, 0});
  EXPECT_NEAR(scene.width, 110, 1e-9);
  EXPECT_NEAR(scene.height, 10, 1e-9);
  const std::vector<Arc> edges = edgesOf(scene);
  ASSERT_FALSE(edges.empty());
  for (const Arc& edge : edges) EXPECT_NEAR(distance(edge.start, edge.end), 100, 1e-9);
}

TEST(ViewSpec, EdgeOnPaperIsDrawnWhereNothingHidesIt) {
  // A wall 50 mm wide and 100 mm high, and half way up a shelf that sticks out beside it.
  for (const bool isShelfBehind : {true, false}) {
    FoldedState state = test::run("square 100; cut 50,0 50,100");
    ASSERT_EQ(state.poses.size(), 2U);
    const std::size_t left = facetAt(state.pattern, {25, 50})->index;
    state.poses[left] = rotationAbout({0, 0, 0}, {1, 0, 0}, 90);
    state.poses[1 - left] = translation({-30, isShelfBehind ? 1.0 : -101.0, 50});
    std::vector<LayerSet> sets;
    for (std::size_t f = 0; f < 2; ++f) sets.push_back({state.poses[f].normal(), {FacetId(f)}, {}});
    state.layers = LayerOrder(std::move(sets));
    const Scene scene = *modelScene(state, {}, ViewSpec{0, 0});
    double longest = 0;
    double rightmost = 0;
    for (const Arc& edge : edgesOf(scene)) {
      if (std::abs(edge.start.y - 55) > 1e-9 || std::abs(edge.end.y - 55) > 1e-9) continue;
      longest = std::max(longest, distance(edge.start, edge.end));
      rightmost = std::max({rightmost, edge.start.x, edge.end.x});
    }
    EXPECT_NEAR(longest, isShelfBehind ? 20 : 30, 1e-6) << "beside the wall, or before it too";
    EXPECT_NEAR(rightmost, 5 + 70, 1e-6);
    EXPECT_NEAR(scene.width, 80, 1e-9);
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
