// Pictures from any side equal a depth buffer, sample by sample: as vectors and as PNG.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "core/paper/loose_facet.h"
#include "render/canvas/png.h"
#include "render/canvas/write.h"
#include "render/scene/model_scene.h"
#include "render/scene/spread.h"
#include "render/visibility/visible_regions.h"
#include "tests/support/depth_buffer.h"
#include "tests/support/model_text.h"
#include "tests/support/random_steps.h"
#include "tests/support/sanitized.h"

namespace kiri {
namespace {

constexpr int kFiner = 4;
constexpr double kPixels = 110;  // of the longer side of the PNG

test::Eye eyeOf(const ViewFrame& view) {
  return {view.right, view.up, view.toEye, view.centre, view.eyeDistance};
}

std::vector<test::SeenLoops> loopsOf(const VisibleRegions& regions) {
  std::vector<test::SeenLoops> out;
  for (const VisibleFacet& facet : regions.facets) {
    test::SeenLoops& seen = out.emplace_back();
    seen.facet = static_cast<std::int32_t>(facet.facet.index);
    for (const auto& loop : facet.loops) {
      std::vector<Arc>& arcs = seen.loops.emplace_back();
      for (const BoundaryPiece& piece : loop) arcs.push_back(piece.arc);
    }
  }
  return out;
}

Color colorOf(std::int32_t facet) {
  return {static_cast<std::uint8_t>(facet & 255), static_cast<std::uint8_t>(facet >> 8), 200};
}

/// The scene with one colour for each facet and no lines.
void paintByFacet(Scene& scene) {
  std::vector<Group> paper;
  for (Group& group : scene.groups) {
    if (group.id != "paper") continue;
    for (Item& item : group.items) {
      std::get<FillItem>(item.shape).fill.color = colorOf(std::stoi(item.id.substr(6)));
    }
    paper.push_back(std::move(group));
  }
  scene.groups = std::move(paper);
}

/// The facet that fills a pixel; kUnclear when there are several.
std::int32_t filling(const test::DepthPicture& truth, int x, int y) {
  const std::int32_t id = truth.at(kFiner * x, kFiner * y);
  for (int dy = 0; dy < kFiner; ++dy) {
    for (int dx = 0; dx < kFiner; ++dx) {
      if (truth.at(kFiner * x + dx, kFiner * y + dy) != id) return test::DepthPicture::kUnclear;
    }
  }
  return id;
}

/// Which pixels a border passes through or comes near: even a needle too thin for any sample tints
/// them.
std::vector<bool> edgePixels(const VisibleRegions& regions, const Box& box, int width, int height) {
  std::vector<bool> isEdge(static_cast<std::size_t>(width * height), false);
  const double pixel = (box.high.x - box.low.x) / width;
  const auto mark = [&](Vec2 p) {
    const int x = static_cast<int>(std::floor((p.x - box.low.x) / pixel));
    const int y = static_cast<int>(std::floor((box.high.y - p.y) / pixel));
    if (x >= 0 && y >= 0 && x < width && y < height) {
      isEdge[static_cast<std::size_t>(y * width + x)] = true;
    }
  };
  for (const VisibleFacet& facet : regions.facets) {
    for (const auto& loop : facet.loops) {
      for (const BoundaryPiece& piece : loop) {
        const int steps = 8 + static_cast<int>(16 * lengthOf(piece.arc, pixel) / pixel);
        for (int i = 0; i <= steps; ++i) {
          const Vec2 p = pointAt(piece.arc, 1.0 * i / steps);
          for (const double dx : {-0.2, 0.2}) {
            for (const double dy : {-0.2, 0.2}) mark(p + Vec2{dx, dy} * pixel);
          }
        }
      }
    }
  }
  return isEdge;
}

struct Tally {
  int pictures = 0;
  int perspective = 0;
  int collided = 0;
  int severalPlanes = 0;
  long samples = 0;
  long unclear = 0;
  long pixels = 0;
};

void expectExact(const FoldedState& state, const ViewSpec& spec, Tally& tally) {
  const ViewFrame view = *frameOf(spec, sphereOf(state, spec));
  const VisibleRegions regions = visibleRegions(state, view);
  if (regions.facets.empty()) return;
  ModelSceneOptions options;
  options.margin = 0;
  Scene scene = *modelScene(state, {}, spec, options);
  const double perMm = kPixels / std::max(scene.width, scene.height);
  constexpr double kInch = 25.4;
  paintByFacet(scene);
  const Image image = *decodePng(*writePng(scene, {perMm * kInch}));
  const Vec2 low = boundsOf(regions).low;
  const double top = low.y + scene.height;
  const Box box{{low.x, top - image.height / perMm}, {low.x + image.width / perMm, top}};

  const int width = kFiner * image.width;
  const int height = kFiner * image.height;
  const test::DepthPicture truth = test::depthPicture(state, eyeOf(view), box, width, height);
  const test::DepthPicture drawn = test::pictureOf(loopsOf(regions), box, width, height);
  EXPECT_EQ(test::wrongSamples(drawn, truth), 0);
  const std::vector<bool> isEdge = edgePixels(regions, box, image.width, image.height);
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      if (isEdge[static_cast<std::size_t>(y * image.width + x)]) continue;
      const std::int32_t id = filling(truth, x, y);
      if (id == test::DepthPicture::kUnclear) continue;
      const std::uint8_t* p = &image.rgba[static_cast<std::size_t>(y * image.width + x) * 4];
      ++tally.pixels;
      if (id == test::DepthPicture::kNothing) {
        ASSERT_EQ(p[3], 0) << "pixel " << x << ", " << y;
      } else {
        ASSERT_EQ((Color{p[0], p[1], p[2]}), colorOf(id)) << "pixel " << x << ", " << y;
        ASSERT_EQ(p[3], 255) << "pixel " << x << ", " << y;
      }
    }
  }
  ++tally.pictures;
  tally.perspective += view.isPerspective() ? 1 : 0;
  tally.collided += state.collisions.empty() ? 0 : 1;
  tally.severalPlanes += state.layers.sets().size() > 2 ? 1 : 0;
  tally.samples += width * height;
  tally.unclear +=
      std::count(truth.samples.begin(), truth.samples.end(), test::DepthPicture::kUnclear);
}

ViewSpec randomView(test::Random& random) {
  ViewSpec spec{random.between(-180, 180), random.between(-90, 90)};
  if (random.chance(0.5)) spec.fieldOfView = random.between(5, 110);
  return spec;
}

FoldedState randomState(test::Random& random) {
  FoldedState state = test::startOf(test::randomSheet(random));
  for (int i = 0; i < 10; ++i) {
    const Step step = test::randomStep(random, state, {});
    if (Result<FoldedState> next = test::tryAfter(state, test::textOf(step)))
      state = std::move(*next);
  }
  // Open what lies flat, so that most states stand in space.
  for (int i = 0; i < 3 && !state.lines.empty(); ++i) {
    const std::string& name = state.lines[random.below(state.lines.size())].name;
    const std::string angle = std::to_string(random.between(-175, 175));
    if (Result<FoldedState> next = test::tryAfter(state, "angle " + name + " " + angle))
      state = std::move(*next);
  }
  return state;
}

constexpr int kPictures = test::casesOf(300, 60);

TEST(ExactPictures, RandomStatesFromRandomSidesEqualADepthBuffer) {
  Tally tally;
  for (std::uint64_t seed = 1; tally.pictures < kPictures; ++seed) {
    ASSERT_LT(seed, 600U);
    SCOPED_TRACE(::testing::Message() << "seed " << seed);
    test::Random random(seed * 7919);
    const FoldedState state = randomState(random);
    expectExact(state, randomView(random), tally);
    if (::testing::Test::HasFailure()) return;
  }
  EXPECT_GT(tally.perspective, kPictures / 5);
  EXPECT_GT(tally.collided, kPictures / 15);
  EXPECT_GT(tally.severalPlanes, kPictures / 5);
  EXPECT_LT(tally.unclear, tally.samples / 1000);
  EXPECT_GT(tally.pixels, kPictures * 1500);
}

/// Four arms folded onto the middle of a plus, each over the next, and then opened a little or not.
FoldedState pinwheel(const std::string& more) {
  FoldedState state = test::run(
      "polygon 10,-10 20,-10 20,10 10,10 10,20 -10,20 -10,10 -20,10 -20,-10 -10,-10 -10,-20 "
      "10,-20; fold w valley 180 -10,-20 -10,20 moving -15,0; fold s valley 180 -20,-10 20,-10 "
      "moving 0,-15; fold e valley 180 10,-20 10,20 moving 15,0; fold n valley 180 -20,10 20,10 "
      "moving 0,15" +
      more);
  return state;
}

TEST(ExactPictures, FlapsThatLieInARingEqualADepthBuffer) {
  FoldedState state = pinwheel("");
  std::vector<LayerSet> sets = state.layers.sets();
  ASSERT_EQ(sets.size(), 1U);
  const FacetId west = *facetAt(state.pattern, {-15, 0});
  const FacetId north = *facetAt(state.pattern, {0, 15});
  const bool isUp = state.layers.isAbove(north, west);
  sets[0].exceptions.insert(isUp ? std::pair{west, north} : std::pair{north, west});
  state.layers = LayerOrder(std::move(sets));
  Tally tally;
  test::Random random(11);
  for (int i = 0; i < 20; ++i) expectExact(state, randomView(random), tally);
  EXPECT_EQ(tally.pictures, 20);
}

/// Planks in space, each over the next at one end and below the one before at the other.
FoldedState ringOfPlanks(int count) {
  FoldedState state(CreasePattern(Tolerance(100)));
  std::vector<LayerSet> sets;
  for (int i = 0; i < count; ++i) {
    const Vec2 corners[] = {{-30, 8}, {30, 8}, {30, 20}, {-30, 20}};
    const FacetId id = addLooseFacet(state.pattern, corners);
    const Rigid tilt = rotationAbout({0, 14, 0}, {0, 1, 0}, 12);
    state.poses.push_back(compose(rotationAbout({0, 0, 0}, {0, 0, 1}, 360.0 * i / count), tilt));
    sets.push_back({state.poses.back().normal(), {id}, {}});
  }
  state.layers = LayerOrder(std::move(sets));
  return state;
}

TEST(ExactPictures, PlanksThatHideEachOtherInARingEqualADepthBuffer) {
  for (const int count : {3, 4, 7}) {
    const FoldedState state = ringOfPlanks(count);
    Tally tally;
    expectExact(state, frontSpec(), tally);
    expectExact(state, backSpec(), tally);
    test::Random random(5);
    for (int i = 0; i < 10; ++i) expectExact(state, randomView(random), tally);
    EXPECT_EQ(tally.pictures, 12);
  }
}

// Where many planes meet in a point, sides as short as the tolerance had contradicted each other,
// and whole facets were left out.
TEST(ExactPictures, PointsWhereManyPlanesMeetLeaveNoHoles) {
  Tally tally;
  expectExact(
      test::run(
          "rectangle 100 70; fold f0 valley 90 -50,-70 200,105 moving p:50,35 top 3; unfold; "
          "fold f1 mountain 180 @model -160.75989733651616,64.734489033772832 "
          "273.83993155767746,15.177007310818112 to p:50,35; fold f2 valley 180 @model "
          "158.0525136505513,94.827127001203792 -63.647678563228808,30.305799368752758 right "
          "top 3; curve @model -29.972335941278608,-222.59656088047504 "
          "-33.392980675304919,-109.20152096282744 16.000195919320738,-9.6889158283166523 "
          "11.340713933870745,104.03176001032951 55.461216113908776,204.93031974633999 "
          "100.49095712633124,305.58988051436575 free; turn horizontal; move -6,-15; angle f1 "
          "6.331804"),
      {-178.07691751485632, -44.122202661244231, 28.224265879823239}, tally);
  expectExact(
      test::run(
          "square 100; fold f0 valley 180 @model 13.364364940862892,266.24723480714385 "
          "86.339725958833327,-173.01384774321753 right; fold f1 mountain 180 @model "
          "66.699062949084023,-18.623278213509288 96.947123204934172,27.934917320263889 to "
          "p:24.644984840226957,50; fold f2 valley 90 @model "
          "48.382141993382362,29.915969940546042 242.49425886314395,-2.7523511000254537 "
          "right; tear 40.222092139099907,100 16.563882820604075,9.6012325406935641 "
          "28.798287051424101,0 layers all; angle f1 90; cut @model "
          "31.890890200228512,-14.594191550950868 283.73536284608906,67.15734184792646; angle "
          "f1 -155.972503; angle f1 93.082479; angle f1 132.896301"),
      {127.99756554767146, 65.298972824302666, 101.78292571853095}, tally);
  EXPECT_EQ(tally.pictures, 2);
}

TEST(ExactPictures, SpreadLayersEqualADepthBuffer) {
  Tally tally;
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    SCOPED_TRACE(::testing::Message() << "seed " << seed);
    test::Random random(seed * 104729);
    const FoldedState state = randomState(random);
    ViewSpec spec = randomView(random);
    expectExact(spread(state, 2, seed % 2 == 0), spec, tally);
  }
}

}  // namespace
}  // namespace kiri
