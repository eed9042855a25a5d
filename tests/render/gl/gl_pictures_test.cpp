// What OpenGL draws equals the exact pictures of the CPU, from any side.
// SPDX-License-Identifier: MIT
#include <string>
#include <vector>

#include "render/canvas/rasterise.h"
#include "render/mesh/paper_mesh.h"
#include "render/scene/model_scene.h"
#include "tests/render/gl/gl_fixture.h"
#include "tests/render/gl/states.h"
#include "tests/support/model_text.h"
#include "tests/support/sanitized.h"

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
  Scene scene = modelScene(state, {}, view, options);
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

class GlPictures : public GlTest {
 protected:
  Image byGl(const FoldedState& state, const ViewFrame& frame, const Box& box) {
    const PaperMesh mesh = meshOf(state);
    std::vector<TintColor> tints;
    for (std::uint32_t f = 0; f < mesh.facetCount; ++f) {
      const Color c = colorOf(f);
      tints.push_back({c.red, c.green, c.blue, 255});
    }
    renderer_->setMesh(mesh);
    renderer_->setTints(tints);
    return drawn(plainView(frame, box, kPixels, mesh));
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
    if (wrong > 0) {
      keepPicture(cpu, "cpu");
      keepPicture(gpu, "gpu");
    }
    ++pictures_;
  }

  long compared_ = 0;
  int pictures_ = 0;
};

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
  EXPECT_GT(pictures_, casesOf(200, 40));
}

TEST_P(GlPictures, OfAThousandFacetsInAsManyPlanesEqualTheExactOnes) {
  const FoldedState state = miura(32);
  expectSame(state, {25, 40, 0});
  expectSame(state, {-70, -35, 40});
}

TEST_P(GlPictures, ShowTheLayersOfOnePlaneInOrderFromBothSides) {
  const FoldedState state =
      run("square 100; fold a valley 180 0,50 100,50 right; fold b mountain 180 @model 50,0 50,100 "
          "right; fold c valley 180 @model 20,40 60,90 right");
  ASSERT_GT(state.pattern.facets.size(), 6U);
  for (const double elevation : {90.0, -90.0, 60.0, -35.0}) expectSame(state, {20, elevation, 0});
  for (const double elevation : {90.0, -90.0, 60.0, -35.0}) expectSame(state, {20, elevation, 70});
}

INSTANTIATE_TEST_SUITE_P(Contexts, GlPictures, ::testing::Values(GlKind::Desktop33, GlKind::Es30),
                         nameOf);

}  // namespace
}  // namespace kiri::test
