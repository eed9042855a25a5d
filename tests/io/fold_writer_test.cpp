// FOLD files: what they say must fold to the same model in other hands.
// SPDX-License-Identifier: MIT
#include "io/fold_writer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <set>
#include <string>

#include "core/model/apply.h"
#include "core/model/replay.h"
#include "tests/io/fold_reader.h"
#include "tests/support/example_files.h"
#include "tests/support/model_text.h"
#include "tests/support/random_steps.h"
#include "tests/support/sanitized.h"

namespace kiri {
namespace {

using nlohmann::json;
using test::frameOf;
using test::Point;

constexpr double kNear = 1e-6;

struct Written {
  json file;
  test::Frame pattern;
  test::Frame form;  ///< of the only history frame
  std::vector<std::string> losses;
};

Written written(const FoldedState& state, const FoldOptions& options = {}) {
  const Exported fold =
      writeFold(state, {{std::make_shared<const FoldedState>(state), "last", ""}}, options);
  Written out;
  out.file = json::parse(fold.text);
  out.pattern = frameOf(out.file);
  out.form = frameOf(out.file.at("file_frames").at(0));
  out.losses = fold.losses;
  return out;
}

std::vector<Point> formCorners(const test::Frame& form, std::size_t face) {
  std::vector<Point> out;
  for (const int v : form.faces[face]) out.push_back(form.vertices[static_cast<std::size_t>(v)]);
  return out;
}

/// The largest distance between the corners that the angles of the key frame give and those of the
/// folded form.
double worstCorner(const Written& fold, double sign = 1) {
  double worst = 0;
  const auto faces = test::folded(fold.pattern, formCorners(fold.form, 0), sign);
  for (std::size_t f = 0; f < faces.size(); ++f) {
    const std::vector<Point> corners = formCorners(fold.form, f);
    for (std::size_t i = 0; i < faces[f].size(); ++i) {
      worst = std::max(worst, test::apart(faces[f][i], corners[i]));
    }
  }
  return worst;
}

/// A strip with two slanting folds, one valley, one mountain: no rigid motion takes it to its
/// mirror image.
FoldedState chiral(const std::string& angle) {
  return test::run(
      "rectangle 100 20\n"
      "fold one valley " +
      angle +
      " 30,0 36,20 left\n"
      "fold two mountain " +
      angle + " 70,0 62,20 right");
}

TEST(FoldWriter, GivesAnglesThatFoldAChiralModelToTheSamePlaces) {
  for (const std::string angle : {"90", "37.5", "180"}) {
    const Written fold = written(chiral(angle));
    EXPECT_LT(worstCorner(fold), kNear) << angle;
  }
}

TEST(FoldWriter, WouldBeCaughtByThisTestIfItMirroredTheModel) {
  EXPECT_GT(worstCorner(written(chiral("90")), -1), 1.0);
}

TEST(FoldWriter, SaysWhichFaceIsOverWhichAsTheNearlyFoldedPaperShows) {
  const Written fold = written(chiral("180"));
  ASSERT_EQ(fold.pattern.faces.size(), 3u);
  EXPECT_GE(fold.pattern.orders.size(), 2u);
  const auto nearly = test::folded(fold.pattern, formCorners(fold.form, 0), 0.999);
  for (const auto& [f, g, side] : fold.pattern.orders) {
    const std::vector<Point>& upper = nearly[static_cast<std::size_t>(f)];
    const std::vector<Point>& lower = nearly[static_cast<std::size_t>(g)];
    double height = 0;
    for (const Point& p : upper)
      height += test::dotted(test::minus(p, lower[0]), test::normalOf(lower));
    EXPECT_GT(height * side, 0) << f << " over " << g << " side " << side;
  }
}

TEST(FoldWriter, LaysAValleyFrontToFrontAndAMountainBackToBack) {
  const Written valley = written(test::run("square 100\nfold v valley 50,0 50,100 left"));
  ASSERT_EQ(valley.pattern.orders.size(), 1u);
  EXPECT_EQ(valley.pattern.orders[0][2], 1);
  EXPECT_EQ(std::count(valley.pattern.angles.begin(), valley.pattern.angles.end(), 180.0), 1);
  const Written mountain = written(test::run("square 100\nfold m mountain 50,0 50,100 left"));
  ASSERT_EQ(mountain.pattern.orders.size(), 1u);
  EXPECT_EQ(mountain.pattern.orders[0][2], -1);
  EXPECT_EQ(std::count(mountain.pattern.angles.begin(), mountain.pattern.angles.end(), -180.0), 1);
  EXPECT_EQ(
      std::count(mountain.pattern.assignments.begin(), mountain.pattern.assignments.end(), "M"), 1);
}

TEST(FoldWriter, MeansTheSideByTheFoldedNormalOfTheSecondFace) {
  // The model turned over: the order is about the paper's own normals, so nothing changes.
  const Written before = written(test::run("square 100\nfold v valley 50,0 50,100 left"));
  const Written after = written(test::run("square 100\nfold v valley 50,0 50,100 left\nturn"));
  EXPECT_EQ(before.pattern.orders, after.pattern.orders);
  EXPECT_EQ(before.pattern.angles, after.pattern.angles);
}

TEST(FoldWriter, SaysWhatKindOfFileItIs) {
  const Written fold = written(chiral("90"));
  EXPECT_EQ(fold.file["file_spec"], 1.2);
  EXPECT_EQ(fold.file["file_classes"], json({"singleModel", "diagrams"}));
  EXPECT_EQ(fold.file["frame_classes"], json({"creasePattern"}));
  EXPECT_EQ(fold.file["frame_unit"], "mm");
  EXPECT_EQ(fold.file["file_frames"][0]["frame_classes"], json({"foldedForm"}));
  EXPECT_EQ(fold.file["file_frames"][0]["frame_title"], "last");
  EXPECT_EQ(fold.file["file_frames"][0]["frame_inherit"], false);
  EXPECT_TRUE(fold.losses.empty());
}

TEST(FoldWriter, WritesOneFoldedFormForEachStep) {
  const Model model = test::modelOf("square 100\nfold a valley 50,0 50,100 left\nturn\nunfold all");
  std::vector<FoldFrame> history;
  FoldedState state = test::startOf(model);
  for (std::size_t i = 0; i < model.steps.size(); ++i) {
    state = *apply(state, model.steps[i], static_cast<int>(i + 1));
    history.push_back(
        {std::make_shared<const FoldedState>(state), "step " + std::to_string(i + 1), ""});
  }
  const json file = json::parse(writeFold(state, history, {}).text);
  ASSERT_EQ(file["file_frames"].size(), 3u);
  EXPECT_EQ(file["file_frames"][1]["frame_title"], "step 2");
  EXPECT_EQ(std::count(file["edges_assignment"].begin(), file["edges_assignment"].end(), "F"), 1);
  EXPECT_FALSE(json::parse(writeFold(state, {}, {}).text).contains("file_frames"));
}

TEST(FoldWriter, SplitsTheVerticesOfTornPaperWhereItOpens) {
  const FoldedState state = test::run(
      "square 100\nfold a valley 50,0 50,100 left\nunfold all\ntear 50,0 50,40\n"
      "fold b valley 90 0,40 50,40 left in 20,20");
  const Written fold = written(state);
  EXPECT_GE(std::count(fold.pattern.assignments.begin(), fold.pattern.assignments.end(), "C"), 1);
  EXPECT_EQ(std::count(fold.form.assignments.begin(), fold.form.assignments.end(), "C"), 0);
  EXPECT_GT(fold.form.vertices.size(), fold.pattern.vertices.size());
  const json attributes = fold.file["frame_attributes"];
  EXPECT_EQ(std::count(attributes.begin(), attributes.end(), "cuts"), 1);
  EXPECT_LT(worstCorner(fold), kNear);
}

TEST(FoldWriter, DividesCurvedFacetsIntoConvexFacesWithJoins) {
  const FoldedState state = test::run(
      "square 100\nfold a valley 50,0 50,100 left\n"
      "curve m:50,80 m:60,20 m:90,30 m:90,90 m:50,80 @model keep m:97,97");
  const Written fold = written(state);
  EXPECT_FALSE(fold.losses.empty());
  EXPECT_GE(std::count(fold.pattern.assignments.begin(), fold.pattern.assignments.end(), "J"), 1);
  EXPECT_LT(worstCorner(fold), kNear);
}

TEST(FoldWriter, IsAsCoarseAsItIsAskedToBe) {
  const FoldedState state = test::run(
      "square 100\nfold a valley 50,0 50,100 left\n"
      "curve m:50,80 m:60,20 m:90,30 m:90,90 m:50,80 @model keep m:97,97");
  FoldOptions coarse;
  coarse.chordError = 0.1;
  coarse.decimals = 3;
  const Written fine = written(state);
  const Written fold = written(state, coarse);
  EXPECT_LT(3 * fold.pattern.vertices.size(), 2 * fine.pattern.vertices.size());
  for (const test::Frame& frame : {fold.pattern, fold.form}) {
    for (const Point& p : frame.vertices) {
      for (const double c : p) EXPECT_NEAR(1000 * c, std::round(1000 * c), kNear);
    }
  }
  // Each vertex is rounded by half a thousandth, and there are some between the first and the last.
  EXPECT_LT(worstCorner(fold), 0.01);
}

/// The area of a flat face.
double areaOfFace(const test::Frame& frame, const std::vector<int>& face) {
  double sum = 0;
  for (std::size_t i = 0; i < face.size(); ++i) {
    const Point& a = frame.vertices[static_cast<std::size_t>(face[i])];
    const Point& b = frame.vertices[static_cast<std::size_t>(face[(i + 1) % face.size()])];
    sum += (a[0] * b[1] - a[1] * b[0]) / 2;
  }
  return sum;
}

/// Every side of every face is an edge, every edge names the faces that run along it.
void expectWholeMesh(const test::Frame& frame, const std::string& about) {
  std::map<std::pair<int, int>, int> sides;
  for (std::size_t f = 0; f < frame.faces.size(); ++f) {
    const std::vector<int>& face = frame.faces[f];
    for (std::size_t i = 0; i < face.size(); ++i) {
      EXPECT_TRUE(
          sides.emplace(std::pair(face[i], face[(i + 1) % face.size()]), static_cast<int>(f))
              .second)
          << "two faces on one side\n"
          << about;
    }
  }
  std::size_t named = 0;
  for (std::size_t e = 0; e < frame.edges.size(); ++e) {
    const auto [a, b] = frame.edges[e];
    const auto [left, right] = frame.edgeFaces[e];
    if (left >= 0) {
      ++named;
      EXPECT_EQ(sides.at({a, b}), left) << about;
    }
    if (right >= 0) {
      ++named;
      EXPECT_EQ(sides.at({b, a}), right) << about;
    }
  }
  EXPECT_EQ(named, sides.size()) << about;
}

TEST(FoldWriter, DescribesRandomModelsWholly) {
  constexpr std::uint64_t kSeeds = 40;
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    test::Random random(seed);
    const Model model = test::randomSheet(random);
    FoldedState state = test::startOf(model);
    for (int i = 1; i <= 12; ++i) {
      const Result<FoldedState> next = apply(state, test::randomStep(random, state, {}), i);
      if (next.isOk()) state = *next;
    }
    const std::string about = "seed " + std::to_string(seed);
    const Written fold = written(state);
    expectWholeMesh(fold.pattern, about);
    double area = 0;
    for (const std::vector<int>& face : fold.pattern.faces) {
      EXPECT_GT(areaOfFace(fold.pattern, face), 0) << about;
      area += areaOfFace(fold.pattern, face);
    }
    EXPECT_NEAR(area, areaOf(state.pattern), areaOf(state.pattern) * 1e-4) << about;
    EXPECT_LT(worstCorner(fold), kNear * 100) << about;
  }
}

TEST(FoldWriter, DescribesEveryStepOfEveryExampleWholly) {
  std::size_t count = 0;
  for (const std::filesystem::path& file : test::exampleFilesThatTakeLong()) {
    const std::string name = file.filename().string();
    const Result<Replay> steps = replay(test::modelInFile(file));
    ASSERT_TRUE(steps.isOk()) << name;
    for (const StepOutcome& outcome : steps->outcomes) {
      ASSERT_TRUE(outcome.state) << name << ": " << outcome.error->message;
      const Written fold = written(*outcome.state);
      expectWholeMesh(fold.pattern, name);
      EXPECT_LT(worstCorner(fold), kNear) << name;
      ++count;
    }
    FoldOptions coarse;
    coarse.chordError = 0.02;
    coarse.decimals = 6;
    const Written last = written(*steps->outcomes.back().state, coarse);
    expectWholeMesh(last.pattern, name + ", coarse");
    expectWholeMesh(last.form, name + ", coarse and folded");
  }
  EXPECT_GT(count, test::casesOf(250u, 50u));
}

TEST(FoldWriter, LeavesOutOrdersThatFollowFromOthersInLargeStacks) {
  FoldedState state = test::startOf(test::modelOf("square 128"));
  double low = 0;
  double high = 128;
  for (int i = 1; i <= 9; ++i) {
    const double middle = (low + high) / 2;
    const std::string at = std::to_string(middle);
    state = test::after(state, "fold f" + std::to_string(i) + " valley m:" + at + ",-1 m:" + at +
                                   ",129 @model left");
    low = middle;
  }
  const json file = json::parse(writeFold(state, {}, {}).text);
  EXPECT_EQ(file["faces_vertices"].size(), 512u);
  EXPECT_EQ(file["faceOrders"].size(), 511u);
  EXPECT_TRUE(file.contains("kiri:faceOrders"));
}

}  // namespace
}  // namespace kiri
