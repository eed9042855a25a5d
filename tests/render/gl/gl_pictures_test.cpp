// What OpenGL draws equals the exact pictures of the CPU, from any side.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string>
#include <vector>

#include "render/canvas/rasterise.h"
#include "render/gl/renderer.h"
#include "render/mesh/paper_mesh.h"
#include "render/scene/model_scene.h"
#include "render/scene/spread.h"
#include "render/scene/view_spec.h"
#include "tests/render/gl/headless_gl.h"
#include "tests/render/gl/states.h"
#include "tests/support/model_text.h"
#include "tests/support/random_steps.h"

namespace kiri::test {
namespace {

constexpr int kPixels = 240;

/// A colour for each facet; neighbours in number differ in all channels.
Color colorOf(std::uint32_t facet) {
  const std::uint32_t mixed = (facet + 1) * 2654435761U;
  return {static_cast<std::uint8_t>(32 + (mixed >> 24) % 192),
          static_cast<std::uint8_t>(32 + (mixed >> 16) % 192),
          static_cast<std::uint8_t>(32 + (mixed >> 8) % 192)};
}

Image byCpu(const FoldedState& state, const ViewFrame& view, const Box& box) {
  ModelSceneOptions options;
  options.margin = 0;
  options.box = box;
  Appearance plain;
  plain.showEdges = plain.showCreases = false;
  Scene scene = modelScene(state, plain, view, options);
  std::vector<Group> paper;
  for (Group& group : scene.groups) {
    if (group.id != "paper") continue;
    for (Item& item : group.items) {
      const auto facet = static_cast<std::uint32_t>(std::stoi(item.id.substr(6)));
      std::get<FillItem>(item.shape).fill.color = colorOf(facet);
    }
    paper.push_back(std::move(group));
  }
  scene.groups = std::move(paper);
  return *rasterise(scene, kPixels, kPixels);
}

/// The depths of all corners, with a little room.
void fitDepth(const PaperMesh& mesh, GlView& view) {
  double low = 1e30;
  double high = -1e30;
  for (const MeshVertex& v : mesh.vertices) {
    const Vec3 p = mesh.origin + Vec3{v.position[0], v.position[1], v.position[2]};
    low = std::min(low, view.frame.depth(p));
    high = std::max(high, view.frame.depth(p));
  }
  const double room = 1 + 0.05 * (high - low);
  view.nearDepth = high + room;
  view.farDepth = low - room;
}

class GlPictures : public ::testing::TestWithParam<GlKind> {
 protected:
  void SetUp() override {
    std::string why;
    gl_ = HeadlessGl::create(GetParam(), why);
    if (!gl_) GTEST_SKIP() << "not tested: " << why;
    renderer_ = *GlRenderer::create();
    gl_->begin(kPixels, kPixels);
  }
  void TearDown() override { renderer_.reset(); }

  Image byGl(const FoldedState& state, const ViewFrame& frame, const Box& box) {
    const PaperMesh mesh = meshOf(state);
    std::vector<TintColor> tints;
    for (std::uint32_t f = 0; f < mesh.facetCount; ++f) {
      const Color c = colorOf(f);
      tints.push_back({c.red, c.green, c.blue, 255});
    }
    renderer_->setMesh(mesh);
    renderer_->setTints(tints);
    GlView view;
    view.frame = frame;
    view.centre = (box.low + box.high) / 2;
    view.width = view.height = kPixels;
    view.pixelsPerMm = kPixels / (box.high.x - box.low.x);
    view.background = {255, 255, 255};
    view.showsEdges = view.showsCreases = view.showsBorders = view.isShaded = false;
    fitDepth(mesh, view);
    renderer_->draw(view);
    EXPECT_EQ(gl_->error(), 0U);
    return gl_->finish();
  }

  /// Every pixel whose neighbours all show the same facet shows that facet.
  void expectSame(const FoldedState& state, const ViewSpec& spec) {
    const Sphere sphere = sphereOf(state, spec);
    const ViewFrame frame = *frameOf(spec, sphere);
    const Box box = boxOf(frame, sphere);
    const Image cpu = byCpu(state, frame, box);
    const Image gpu = byGl(state, frame, box);
    ASSERT_EQ(cpu.rgba.size(), gpu.rgba.size());
    int wrong = 0;
    std::string first;
    for (int y = 1; y + 1 < kPixels; ++y) {
      for (int x = 1; x + 1 < kPixels; ++x) {
        if (!isCalm(cpu, x, y)) continue;
        ++compared_;
        if (differenceAt(cpu, gpu, x, y) <= 1) continue;
        if (wrong++ == 0) first = std::to_string(x) + ", " + std::to_string(y);
      }
    }
    EXPECT_EQ(wrong, 0) << "view " << spec.azimuth << " " << spec.elevation << " "
                        << spec.fieldOfView << ", first at pixel " << first;
    if (wrong > 0) keep(cpu, gpu);
    ++pictures_;
  }

  static const std::uint8_t* at(const Image& image, int x, int y) {
    return &image.rgba[static_cast<std::size_t>(y * image.width + x) * 4];
  }
  static bool isCalm(const Image& image, int x, int y) {
    for (int dy = -1; dy <= 1; ++dy) {
      for (int dx = -1; dx <= 1; ++dx) {
        if (!std::equal(at(image, x, y), at(image, x, y) + 3, at(image, x + dx, y + dy)))
          return false;
      }
    }
    return true;
  }
  static int differenceAt(const Image& a, const Image& b, int x, int y) {
    int most = 0;
    for (int c = 0; c < 3; ++c) most = std::max(most, std::abs(at(a, x, y)[c] - at(b, x, y)[c]));
    return most;
  }
  static void keep(const Image& cpu, const Image& gpu) {
    keepPicture(cpu, "cpu");
    keepPicture(gpu, "gpu");
  }

  std::unique_ptr<HeadlessGl> gl_;
  std::unique_ptr<GlRenderer> renderer_;
  long compared_ = 0;
  int pictures_ = 0;
};

ViewSpec randomView(Random& random) {
  ViewSpec spec{random.between(-180, 180), random.between(-90, 90)};
  if (random.chance(0.5)) spec.fieldOfView = random.between(5, 110);
  return spec;
}

TEST_P(GlPictures, OfRandomStatesEqualTheExactOnes) {
  int inSpace = 0;
  int collided = 0;
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    SCOPED_TRACE(::testing::Message() << "seed " << seed);
    Random random(seed * 6151);
    const FoldedState state = randomFolded(random);
    inSpace += state.layers.sets().size() > 2 ? 1 : 0;
    collided += state.collisions.empty() ? 0 : 1;
    for (int i = 0; i < 4; ++i) expectSame(state, randomView(random));
    if (HasFailure()) return;
  }
  EXPECT_GT(inSpace, 10);
  EXPECT_GT(collided, 3);
  EXPECT_GT(compared_, pictures_ * 20000L);
}

TEST_P(GlPictures, OfAllExamplesEqualTheExactOnes) {
  for (const Example& example : allExamples()) {
    SCOPED_TRACE(example.name);
    Random random(3);
    for (const FoldedState& state : example.states) {
      expectSame(state, frontSpec());
      expectSame(state, backSpec());
      for (int i = 0; i < 2; ++i) expectSame(state, randomView(random));
      if (HasFailure()) return;
    }
  }
  EXPECT_GT(pictures_, 40);
}

TEST_P(GlPictures, ShowTheLayersOfOnePlaneInOrderFromBothSides) {
  const FoldedState state =
      run("square 100; fold a valley 180 0,50 100,50 right; fold b mountain 180 @model 50,0 50,100 "
          "right; fold c valley 180 @model 20,40 60,90 right");
  ASSERT_GT(state.pattern.facets.size(), 6U);
  for (const double elevation : {90.0, -90.0, 60.0, -35.0}) expectSame(state, {20, elevation, 0});
  for (const double elevation : {90.0, -90.0, 60.0, -35.0}) expectSame(state, {20, elevation, 70});
}

std::string nameOf(const ::testing::TestParamInfo<GlKind>& parameter) {
  return parameter.param == GlKind::Desktop33 ? "OpenGl33" : "OpenGlEs30";
}

INSTANTIATE_TEST_SUITE_P(Contexts, GlPictures, ::testing::Values(GlKind::Desktop33, GlKind::Es30),
                         nameOf);

}  // namespace
}  // namespace kiri::test
