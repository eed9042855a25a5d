// What is seen of the finished models of examples/, from the front and from behind.
// SPDX-License-Identifier: MIT
#include <algorithm>

#include "core/paper/boxes.h"
#include "render/visibility/visible_regions.h"
#include "tests/examples/example_models.h"
#include "tests/support/depth_buffer.h"

namespace kiri::test {
namespace {

constexpr int kAcross = 240;

class EveryFinishedExample : public ExampleTest {};

/// The box of the model in the view, a little wider, so that its rim is looked at too, and uneven,
/// so that samples of symmetric models do not lie on creases.
Box boxSeen(const FoldedState& state, const ViewFrame& view) {
  const ModelBox box = modelBoxOf(state);
  const Vec2 a = view.project(box.low);
  const Vec2 b = view.project(box.high);
  const double room = 0.02 * (distance(a, b) + 1);
  return {{std::min(a.x, b.x) - room, std::min(a.y, b.y) - room},
          {std::max(a.x, b.x) + 1.37 * room, std::max(a.y, b.y) + 1.71 * room}};
}

DepthPicture pictureOfRegions(const VisibleRegions& regions, const Box& box) {
  std::vector<SeenLoops> seen;
  for (const VisibleFacet& part : regions.facets) {
    SeenLoops& loops = seen.emplace_back();
    loops.facet = static_cast<std::int32_t>(part.facet.index);
    for (const auto& loop : part.loops) {
      std::vector<Arc>& arcs = loops.loops.emplace_back();
      for (const BoundaryPiece& piece : loop) arcs.push_back(piece.arc);
    }
  }
  return pictureOf(seen, box, kAcross, kAcross);
}

/// Samples of paper, and those where the layers give no answer.
struct Samples {
  long paper = 0;
  long unclear = 0;
};

Samples samplesOf(const DepthPicture& picture) {
  Samples out;
  for (const std::int32_t sample : picture.samples) {
    out.paper += sample >= 0 ? 1 : 0;
    out.unclear += sample == DepthPicture::kUnclear ? 1 : 0;
  }
  return out;
}

TEST_P(EveryFinishedExample, ShowsTheTopmostLayerOnBothSides) {
  const FoldedState& state = example().last();
  for (const ViewFrame& view : {frontView(), backView()}) {
    const char* side = view.toEye.z > 0 ? "front" : "back";
    const Box box = boxSeen(state, view);
    const VisibleRegions regions = visibleRegions(state, view);
    EXPECT_FALSE(regions.facets.empty()) << side;
    const Eye eye{view.right, view.up, view.toEye, {}, 0};
    const DepthPicture truth = depthPicture(state, eye, box, kAcross, kAcross);
    const Samples samples = samplesOf(truth);
    EXPECT_GT(samples.paper, kAcross * kAcross / 20) << side;
    EXPECT_LE(samples.unclear * 100, samples.paper) << side;
    EXPECT_EQ(wrongSamples(pictureOfRegions(regions, box), truth), 0) << side;
  }
}

KIRI_FOR_EVERY_EXAMPLE(EveryFinishedExample);

TEST(SeenOfExamples, AWronglyHiddenFacetIsNoticed) {
  const FoldedState& state = exampleModel("origami_cup").last();
  const Box box = boxSeen(state, frontView());
  VisibleRegions regions = visibleRegions(state, frontView());
  ASSERT_GT(regions.facets.size(), 1u);
  regions.facets.pop_back();
  const Eye eye{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {}, 0};
  EXPECT_GT(
      wrongSamples(pictureOfRegions(regions, box), depthPicture(state, eye, box, kAcross, kAcross)),
      0);
}

}  // namespace
}  // namespace kiri::test
