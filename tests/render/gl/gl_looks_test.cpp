// Lines, textures, grids, tints and light as OpenGL draws them.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <memory>
#include <string>

#include "render/canvas/rasterise.h"
#include "render/mesh/paper_mesh.h"
#include "render/scene/model_scene.h"
#include "tests/render/gl/gl_fixture.h"
#include "tests/render/gl/states.h"
#include "tests/support/model_text.h"

namespace kiri::test {
namespace {

constexpr double kScreen = 96 / 25.4;  // pixels on a mm of a screen

class GlLooks : public GlTest {
 protected:
  GlView viewOf(const ViewSpec& spec, const FoldedState& state, int pixels) {
    const Sphere sphere = sphereOf(state, spec);
    const ViewFrame frame = *frameOf(spec, sphere);
    mesh_ = meshOf(state);
    renderer_->setMesh(mesh_);
    return plainView(frame, boxOf(frame, sphere), pixels, mesh_);
  }

  /// The same view by the CPU. Lines have the widths that they have on a screen.
  static Image byCpu(const FoldedState& state, Appearance appearance, const GlView& view) {
    const double perMm = view.pixelsPerMm;
    const Vec2 half = Vec2{view.width / perMm, view.height / perMm} / 2;
    ModelSceneOptions options;
    options.margin = 0;
    options.box = Box{view.centre - half, view.centre + half};
    appearance.edgeWidth *= kScreen / perMm;
    appearance.creaseWidth = std::max(appearance.creaseWidth * kScreen, 1.0) / perMm;
    return *rasterise(modelScene(state, appearance, view.frame, options), view.width, view.height);
  }

  PaperMesh mesh_;
};

/// White paper and black lines.
Appearance ink() {
  Appearance out;
  out.front.color = out.back.color = {255, 255, 255};
  out.edgeColor = out.creaseColor = {0, 0, 0};
  return out;
}

void showAllLines(GlView& view) { view.showsEdges = view.showsCreases = view.showsBorders = true; }

TEST_P(GlLooks, LinesAreWhereTheExactPictureHasThem) {
  int pictures = 0;
  long dark = 0;
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    SCOPED_TRACE(::testing::Message() << "seed " << seed);
    Random random(seed * 7349);
    const FoldedState state = randomFolded(random);
    if (!state.collisions.empty()) continue;  // there the CPU draws where paper meets paper, too
    renderer_->setAppearance(ink());
    for (int i = 0; i < 2; ++i) {
      GlView view = viewOf(randomView(random), state, 320);
      showAllLines(view);
      const Image cpu = blurred(byCpu(state, ink(), view), 1);
      const Image gpu = blurred(drawn(view), 1);
      int wrong = 0;
      for (int y = 0; y < view.height; ++y) {
        for (int x = 0; x < view.width; ++x) {
          dark += *pixelAt(cpu, x, y) < 200 ? 1 : 0;
          wrong += differenceAt(cpu, gpu, x, y) > 70 ? 1 : 0;
        }
      }
      // Where lines run into each other the two put them together a little differently.
      constexpr int kFew = 16;
      EXPECT_LE(wrong, kFew);
      if (wrong > kFew) {
        keepPicture(byCpu(state, ink(), view), "cpu" + std::to_string(seed));
        keepPicture(drawn(view), "gpu" + std::to_string(seed));
      }
      ++pictures;
    }
  }
  EXPECT_GT(pictures, 50);
  EXPECT_GT(dark, pictures * 500L);
}

/// Smooth, and another colour everywhere.
std::shared_ptr<const Image> blend(bool isBack) {
  constexpr int kSize = 64;
  auto image = std::make_shared<Image>(Image{kSize, kSize, {}});
  for (int y = 0; y < kSize; ++y) {
    for (int x = 0; x < kSize; ++x) {
      const auto across = static_cast<std::uint8_t>(3 * x + 30);
      const auto down = static_cast<std::uint8_t>(3 * y + 30);
      const std::uint8_t third = isBack ? 200 : 40;
      const std::uint8_t alpha = y > kSize / 2 ? 128 : 255;
      image->rgba.insert(image->rgba.end(), {across, down, third, alpha});
    }
  }
  return image;
}

TEST_P(GlLooks, TexturesLieAsInTheExactPicture) {
  Appearance looks;
  looks.showEdges = looks.showCreases = false;
  looks.front.texture = blend(false);
  looks.back.texture = blend(true);
  looks.textureBox = {{0, 0}, {100, 100}};
  renderer_->setAppearance(looks);
  const FoldedState state =
      run("square 100; fold a valley 180 0,60 100,40 right; fold b mountain 70 @model 80,-50 "
          "90,150 right");
  long compared = 0;
  for (const ViewSpec& spec :
       {ViewSpec{20, 60, 0}, ViewSpec{20, -60, 0}, ViewSpec{130, 30, 50}, ViewSpec{-30, -50, 80}}) {
    const GlView view = viewOf(spec, state, 200);
    const Image cpu = byCpu(state, looks, view);
    const Image gpu = drawn(view);
    for (int y = 2; y + 2 < view.height; ++y) {
      for (int x = 2; x + 2 < view.width; ++x) {
        const auto isNear = [&](int dx, int dy) {
          int most = 0;
          for (int c = 0; c < 3; ++c) {
            const int step = pixelAt(cpu, x, y)[c] - pixelAt(cpu, x + dx, y + dy)[c];
            most = std::max(most, std::abs(step));
          }
          return most < 12;
        };
        if (!isNear(2, 0) || !isNear(-2, 0) || !isNear(0, 2) || !isNear(0, -2)) continue;
        ++compared;
        ASSERT_LT(differenceAt(cpu, gpu, x, y), 14) << x << ", " << y;
      }
    }
  }
  EXPECT_GT(compared, 4 * 20000);
}

TEST_P(GlLooks, PaperThatFacesTheEyeHasItsOwnColourInAnyLight) {
  renderer_->setAppearance({});
  const FoldedState state = run("square 100");
  GlView view = viewOf(frontSpec(), state, 60);
  view.isShaded = true;
  const Image front = drawn(view);
  const Color expected = Appearance{}.front.color;
  EXPECT_EQ(
      (Color{pixelAt(front, 30, 30)[0], pixelAt(front, 30, 30)[1], pixelAt(front, 30, 30)[2]}),
      expected);
  view = viewOf(backSpec(), state, 60);
  view.isShaded = true;
  const Image back = drawn(view);
  const Color other = Appearance{}.back.color;
  EXPECT_EQ((Color{pixelAt(back, 30, 30)[0], pixelAt(back, 30, 30)[1], pixelAt(back, 30, 30)[2]}),
            other);
}

TEST_P(GlLooks, PaperThatTurnsAwayFromTheLampIsDarker) {
  Appearance plain;
  plain.back = plain.front;
  renderer_->setAppearance(plain);
  const FoldedState state = run("square 100");
  const auto greenAt = [&](double azimuth, double elevation) {
    GlView view = viewOf({azimuth, elevation, 0}, state, 60);
    view.isShaded = true;
    return *(pixelAt(drawn(view), 30, 30) + 1);
  };
  const int away = greenAt(0, -40);  // its lower rim is near, its face looks down
  EXPECT_LT(away, greenAt(0, 40));
  EXPECT_GT(away, plain.front.color.green / 2);
}

TEST_P(GlLooks, TheGridHasItsLinesOnThePaper) {
  Appearance white;
  white.front.color = {255, 255, 255};
  renderer_->setAppearance(white);
  const FoldedState state = run("square 100");
  GlView view = viewOf(frontSpec(), state, 400);
  view.gridSpacing = 10;
  const Image image = drawn(view);
  // The middle of the picture is the middle of the sheet, 50 mm from its left rim.
  int lines = 0;
  for (int mm = 5; mm < 95; ++mm) {
    const double x = 200 + (mm - 50) * view.pixelsPerMm;
    const double y = 200 + 3.5 * view.pixelsPerMm;
    const bool isDark = *pixelAt(image, static_cast<int>(x), static_cast<int>(y)) < 240 ||
                        *pixelAt(image, static_cast<int>(x) - 1, static_cast<int>(y)) < 240;
    EXPECT_EQ(isDark, mm % 10 == 0) << mm;
    lines += isDark ? 1 : 0;
  }
  EXPECT_EQ(lines, 9);
}

TEST_P(GlLooks, LinesAreTwiceAsWideOnAScreenTwiceAsFine) {
  renderer_->setAppearance(ink());
  const FoldedState state = run("square 100; fold a valley 90 0,50 100,50 right");
  GlView view = viewOf({0, 60, 0}, state, 300);
  showAllLines(view);
  const auto darkness = [&] {
    const Image image = drawn(view);
    long sum = 0;
    for (std::size_t i = 0; i < image.rgba.size(); i += 4) sum += 255 - image.rgba[i];
    return static_cast<double>(sum);
  };
  const double once = darkness();
  view.lineScale = 2;
  EXPECT_NEAR(darkness() / once, 2, 0.12);  // corners overlap
  view.showsEdges = view.showsBorders = view.showsCreases = false;
  EXPECT_EQ(darkness(), 0);
}

TEST_P(GlLooks, AShadowFallsOnTheTableBesideThePaper) {
  renderer_->setAppearance({});
  // The right half stands up; light comes from the upper left.
  const FoldedState state = run("square 100; fold a valley 80 60,0 60,100 right");
  GlView view = viewOf({0, 70, 0}, state, 200);
  const Image without = drawn(view);
  view.hasShadow = true;
  const auto compare = [&](const Image& with) {
    int darker = 0;
    int lightest = 255;
    for (int y = 1; y < 199; ++y) {
      for (int x = 1; x < 199; ++x) {
        if (!isCalm(without, x, y)) continue;
        const int change = *pixelAt(without, x, y) - *pixelAt(with, x, y);
        EXPECT_GE(change, 0);
        darker += change > 8 ? 1 : 0;
        if (*pixelAt(without, x, y) < 250) {
          EXPECT_EQ(change, 0) << "shadow on paper";
        } else {
          lightest = std::min<int>(lightest, *pixelAt(with, x, y));
        }
      }
    }
    EXPECT_GT(darker, 500);
    EXPECT_NEAR(lightest, 255 * (1 - 0.26), 3);
    return darker;
  };
  const int first = compare(drawn(view));
  EXPECT_EQ(compare(drawn(view)), first);  // the second time it is there already
  view.frame = viewFrom(0, -60);
  const Image below = drawn(view);
  view.hasShadow = false;
  EXPECT_EQ(below.rgba, drawn(view).rgba);
}

TEST_P(GlLooks, LeaveTheContextAsTheyFoundIt) {
  GlView view = viewOf(frontSpec(), run("square 100; fold a valley 90 0,50 100,50 right"), 100);
  showAllLines(view);
  view.isShaded = view.hasShadow = true;
  (void)drawn(view);
  EXPECT_EQ(gl_->changedState(), "");
}

INSTANTIATE_TEST_SUITE_P(Contexts, GlLooks, ::testing::Values(GlKind::Desktop33, GlKind::Es30),
                         nameOf);

}  // namespace
}  // namespace kiri::test
