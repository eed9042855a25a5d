// glTF, STL and OBJ as another program reads them: the right paper, plates closed.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstring>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "core/model/apply.h"
#include "io/facet_mesh.h"
#include "io/facet_triangles.h"
#include "io/gltf_animation.h"
#include "io/gltf_meshes.h"
#include "io/gltf_writer.h"
#include "io/obj_writer.h"
#include "io/stl_writer.h"
#include "tests/io/glb_reader.h"
#include "tests/support/model_text.h"
#include "tests/support/random_steps.h"
#include "tests/support/sanitized.h"

namespace kiri {
namespace {

using Triangle = std::array<Vec3, 3>;

FoldedState randomState(std::uint64_t seed) {
  test::Random random(seed);
  FoldedState state = test::startOf(test::randomSheet(random));
  for (int i = 1; i <= 10; ++i) {
    const Result<FoldedState> next = apply(state, test::randomStep(random, state, {}), i);
    if (next.isOk()) state = *next;
  }
  return state;
}

Vec3 acrossOf(const Triangle& t) { return cross(t[1] - t[0], t[2] - t[0]); }

double areaOf(const std::vector<Triangle>& triangles) {
  double sum = 0;
  for (const Triangle& t : triangles) sum += length(acrossOf(t)) / 2;
  return sum;
}

/// By the divergence theorem: right for closed surfaces, whatever the origin.
double volumeOf(const std::vector<Triangle>& triangles) {
  double sum = 0;
  for (const Triangle& t : triangles) sum += dot(t[0], cross(t[1], t[2])) / 6;
  return sum;
}

/// How many more times a side is run along forwards than backwards, summed over all sides.
int openSides(const std::vector<Triangle>& triangles) {
  using Point = std::array<double, 3>;
  std::map<std::pair<Point, Point>, int> balance;
  const auto point = [](Vec3 p) { return Point{p.x, p.y, p.z}; };
  for (const Triangle& t : triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      const Point a = point(t[k]);
      const Point b = point(t[(k + 1) % 3]);
      if (a < b) ++balance[{a, b}];
      if (b < a) --balance[{b, a}];
    }
  }
  int open = 0;
  for (const auto& [side, count] : balance) open += std::abs(count);
  return open;
}

std::vector<Triangle> trianglesOfStl(const std::string& bytes) {
  EXPECT_GE(bytes.size(), 84u);
  EXPECT_NE(bytes.substr(0, 5), "solid") << "readers would take it for text";
  std::uint32_t count = 0;
  std::memcpy(&count, bytes.data() + 80, 4);
  EXPECT_EQ(bytes.size(), 84 + std::size_t{50} * count);
  std::vector<Triangle> out;
  for (std::uint32_t i = 0; i < count; ++i) {
    float numbers[12];
    std::memcpy(numbers, bytes.data() + 84 + std::size_t{50} * i, sizeof numbers);
    const auto vector = [&](std::size_t k) {
      const auto number = [&](std::size_t n) { return static_cast<double>(numbers[k + n]); };
      return Vec3{number(0), number(1), number(2)};
    };
    out.push_back({vector(3), vector(6), vector(9)});
    const Vec3 across = acrossOf(out.back());
    if (length(across) > 0.01) {
      EXPECT_GT(dot(normalized(across), vector(0)), 0.99) << "normal of triangle " << i;
    }
  }
  return out;
}

std::vector<Triangle> trianglesOfObj(const std::string& text) {
  std::vector<Vec3> points;
  std::vector<Triangle> out;
  std::istringstream lines(text);
  std::string line;
  while (std::getline(lines, line)) {
    std::istringstream words(line);
    std::string kind;
    words >> kind;
    if (kind == "v") {
      Vec3& p = points.emplace_back();
      words >> p.x >> p.y >> p.z;
    } else if (kind == "f") {
      Triangle& t = out.emplace_back();
      for (Vec3& corner : t) {
        std::string text3;
        words >> text3;
        corner = points.at(std::stoul(text3) - 1);
      }
    }
  }
  return out;
}

TEST(Stl, IsClosedAndHoldsAreaTimesThicknessForRandomModels) {
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    const FoldedState state = randomState(seed);
    const std::vector<Triangle> plates = trianglesOfStl(writeStl(state, {0.5, 0, false}).text);
    EXPECT_EQ(openSides(plates), 0) << "seed " << seed;
    const double area = areaOf(state.pattern);
    EXPECT_NEAR(volumeOf(plates), 0.5 * area, 0.5e-3 * area) << "seed " << seed;
    const std::vector<Triangle> surface = trianglesOfStl(writeStl(state, {0, 0, false}).text);
    EXPECT_NEAR(areaOf(surface), area, 1e-3 * area) << "seed " << seed;
  }
}

TEST(Stl, SpreadsTheLayersOfAHalvedSheetToAPile) {
  const std::string halved =
      "square 100\nfold a valley 50,0 50,100 left\nfold b valley m:50,50 m:100,50 @model left";
  const std::vector<Triangle> plates =
      trianglesOfStl(writeStl(test::run(halved), {0.5, 0.25, false}).text);
  double low = 1000;
  double high = -1000;
  for (const Triangle& t : plates) {
    for (const Vec3 p : t) {
      low = std::min(low, p.z);
      high = std::max(high, p.z);
    }
  }
  EXPECT_NEAR(high - low, 4 * 0.5 + 3 * 0.25, 1e-5);
}

TEST(Obj, WithThicknessIsTheSameSolidAsStl) {
  for (const std::uint64_t seed : {3U, 5U, 8U}) {
    const FoldedState state = randomState(seed);
    ObjOptions options;
    options.thickness = 0.5;
    const std::vector<Triangle> plates = trianglesOfObj(writeObj(state, options).text);
    EXPECT_EQ(openSides(plates), 0) << "seed " << seed;
    EXPECT_NEAR(volumeOf(plates), 0.5 * areaOf(state.pattern), 0.5e-3 * areaOf(state.pattern));
  }
}

TEST(Gltf, QuaternionsAreThePosesOfRandomModels) {
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    for (const Rigid& pose : randomState(seed).poses) {
      const std::array<double, 4> q = quaternionOf(pose);
      const Vec3 u{q[0], q[1], q[2]};
      const auto rotated = [&](Vec3 v) {
        const Vec3 t = cross(u, v) * 2;
        return v + t * q[3] + cross(u, t);
      };
      EXPECT_LT(distance(rotated({1, 0, 0}), pose.x), 1e-12);
      EXPECT_LT(distance(rotated({0, 1, 0}), pose.y), 1e-12);
      EXPECT_LT(distance(rotated({0, 0, 1}), pose.z), 1e-12);
    }
  }
}

/// The model frame, mm, of glTF's axes and metres.
Vec3 turnedBack(Vec3 scene) { return {scene.x, -scene.z, scene.y}; }
Vec3 inModel(Vec3 scene) { return turnedBack(scene) * 1000; }

std::vector<Triangle> trianglesOf(const std::vector<test::GlbPart>& parts,
                                  const std::string& material) {
  std::vector<Triangle> out;
  for (const test::GlbPart& part : parts) {
    for (const test::GlbTriangle& t : part.triangles) {
      if (t.material != material) continue;
      out.push_back({inModel(t.corners[0]), inModel(t.corners[1]), inModel(t.corners[2])});
    }
  }
  return out;
}

TEST(Gltf, ShowsEveryFacetWhereItLiesWithBothSidesOutward) {
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    const FoldedState state = randomState(seed);
    GltfOptions options;
    options.layerGap = 0;
    const test::GlbFile file(writeGlb(state, options).text);
    const std::vector<test::GlbPart> parts = file.at();
    ASSERT_EQ(parts.size(), state.pattern.facets.size());
    for (const test::GlbPart& part : parts) {
      const FacetId facet(std::stoul(part.name.substr(part.name.rfind('_') + 1)));
      const Rigid& pose = state.poseOf(facet);
      for (const test::GlbTriangle& t : part.triangles) {
        const Vec3 across =
            acrossOf({inModel(t.corners[0]), inModel(t.corners[1]), inModel(t.corners[2])});
        const double side = t.material == "front" ? 1 : -1;
        EXPECT_GE(dot(across, pose.normal()) * side, 0) << "seed " << seed;
        for (std::size_t k = 0; k < 3; ++k) {
          EXPECT_LT(distance(turnedBack(t.normals[k]), pose.normal() * side), 1e-6);
          const Vec2 paper = pose.pullBack(inModel(t.corners[k]));
          EXPECT_LT(distance(pose.apply(paper), inModel(t.corners[k])), 1e-3) << "seed " << seed;
          EXPECT_NE(locate(regionOf(state.pattern, facet), paper, 0.01), Where::Outside);
        }
      }
    }
    const double area = areaOf(state.pattern);
    EXPECT_NEAR(areaOf(trianglesOf(parts, "front")), area, 1e-3 * area) << "seed " << seed;
    EXPECT_NEAR(areaOf(trianglesOf(parts, "back")), area, 1e-3 * area) << "seed " << seed;
  }
}

TEST(Gltf, WithThicknessHoldsClosedPlates) {
  GltfOptions options;
  options.thickness = 1;
  const FoldedState state = randomState(8);
  const std::vector<test::GlbPart> parts = test::GlbFile(writeGlb(state, options).text).at();
  double volume = 0;
  for (const std::string material : {"front", "back", "rim"}) {
    volume += volumeOf(trianglesOf(parts, material));
  }
  EXPECT_NEAR(volume, areaOf(state.pattern), 2e-3 * areaOf(state.pattern));
}

/// Points of the facets of a state in the model frame: the corners of their triangles.
std::vector<Vec3> cornersOf(const FoldedState& state) {
  std::vector<Vec3> out;
  for (const FacetTriangles& facet : trianglesOf(state.pattern, meshOf(state.pattern))) {
    for (const auto& triangle : facet.triangles) {
      for (const std::uint32_t corner : triangle) {
        out.push_back(state.poseOf(facet.facet).apply(facet.points[corner]));
      }
    }
  }
  return out;
}

/// The largest distance of one of `a` from the nearest of `b`.
double apart(const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
  double most = 0;
  for (const Vec3 p : a) {
    double least = HUGE_VAL;
    for (const Vec3 q : b) least = std::min(least, distance(p, q));
    most = std::max(most, least);
  }
  return most;
}

/// Holds the animation against the time line at many moments.
void expectSameMotion(const Model& model, const TimelineOptions& time, GltfOptions options = {}) {
  const Result<Timeline> timeline = Timeline::of(model, time);
  ASSERT_TRUE(timeline.isOk()) << timeline.error().message;
  options.layerGap = 0;
  const Result<Exported> exported = writeAnimatedGlb(*timeline, options);
  ASSERT_TRUE(exported.isOk());
  const test::GlbFile file(exported->text);
  EXPECT_NEAR(
      file.duration(),
      timeline->duration() - timeline->phases().back().end + timeline->phases().back().start, 2.0);
  const double size = timeline->stateAfter(0).tolerance().sheetSize();
  constexpr int kMoments = 60;
  for (int i = 0; i <= kMoments; ++i) {
    const double seconds = timeline->duration() * (i + 0.37) / (kMoments + 1);
    const FoldedState state = timeline->stateAt(seconds);
    const std::vector<test::GlbPart> parts = file.at(seconds);
    EXPECT_EQ(parts.size(), state.pattern.facets.size()) << seconds << " s";
    std::vector<Vec3> shown;
    for (const Triangle& t : trianglesOf(parts, "front"))
      shown.insert(shown.end(), t.begin(), t.end());
    const std::vector<Vec3> real = cornersOf(state);
    ASSERT_EQ(shown.size(), real.size()) << seconds << " s";
    EXPECT_LT(apart(shown, real), options.motionError * size) << seconds << " s";
    EXPECT_LT(apart(real, shown), options.motionError * size) << seconds << " s";
  }
}

TEST(Gltf, InMotionShowsThePaperWhereItIsAtEveryMoment) {
  expectSameMotion(test::modelOf("square 100\nfold a valley 50,0 50,100 left\n"
                                 "cut m:0,5 m:101,5 @model keep 60,60\n"
                                 "fold b valley m:50,30 m:100,50 @model left\nunfold all\n"
                                 "turn vertical\nrefold a\nangle a 70"),
                   {});
  TimelineOptions even;
  even.easing = Easing::None;
  even.hold = 0;
  expectSameMotion(test::modelOf("disc 80\nfold a valley 90 40,0 40,80 left\n"
                                 "fold b mountain 10,0 10,80 left\nunfold b"),
                   even);
}

TEST(Gltf, InMotionIsAsCoarseAsItIsAskedToBe) {
  const Model model = test::modelOf(
      "square 100\nfold a valley 50,0 50,100 left\n"
      "fold b valley 90 m:50,30 m:100,50 @model left\nunfold all");
  GltfOptions coarse;
  coarse.motionError = 0.005;
  expectSameMotion(model, {}, coarse);
  const Result<Timeline> timeline = Timeline::of(model);
  ASSERT_TRUE(timeline.isOk());
  EXPECT_LT(writeAnimatedGlb(*timeline, coarse)->text.size(),
            writeAnimatedGlb(*timeline, {})->text.size() * 3 / 4);
}

TEST(Gltf, InMotionFollowsRandomModels) {
  int models = 0;
  for (std::uint64_t seed = 1; seed <= test::casesOf<std::uint64_t>(12, 3); ++seed) {
    test::Random random(seed);
    Model model = test::randomSheet(random);
    FoldedState state = test::startOf(model);
    for (int i = 1; i <= 8; ++i) {
      const Step step = test::randomStep(random, state, {});
      const Result<FoldedState> next = apply(state, step, i);
      if (!next.isOk()) continue;
      state = *next;
      model.steps.push_back(step);
    }
    if (model.steps.size() < 3) continue;
    TimelineOptions time;
    time.degreesPerSecond = 200;
    SCOPED_TRACE(seed);
    expectSameMotion(model, time);
    ++models;
  }
  EXPECT_GT(models, test::casesOf(8, 1));
}

TEST(Gltf, InMotionRestsWhereNothingMoves) {
  const Result<Timeline> timeline = Timeline::of(test::modelOf("square 100"));
  ASSERT_TRUE(timeline.isOk());
  const test::GlbFile file(writeAnimatedGlb(*timeline, {})->text);
  EXPECT_FALSE(file.document().contains("animations"));
  EXPECT_EQ(file.at().size(), 1u);
  const auto stop = [](double) { return false; };
  EXPECT_EQ(writeAnimatedGlb(*timeline, {}, stop).error().code, ErrorCode::Cancelled);
}

TEST(Gltf, IsTheSameEveryTime) {
  EXPECT_EQ(writeGlb(randomState(4), {}).text, writeGlb(randomState(4), {}).text);
}

}  // namespace
}  // namespace kiri
