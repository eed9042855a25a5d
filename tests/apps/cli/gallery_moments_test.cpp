// The moments that a gallery shows, and which models are leaves.
// SPDX-License-Identifier: MIT
#include "apps/cli/gallery_moments.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <set>
#include <string>

#include "apps/cli/gallery_leaf.h"
#include "io/file.h"
#include "io/kiri_reader.h"

namespace kiri::cli {
namespace {

Model modelFromSteps(const std::string& steps) {
  const Result<LoadedModel> loaded = readKiri(
      R"({"format": "kiri", "version": 1, "sheet": {"shape": "square", "side": 40}, "steps": [)" +
          steps + "]}",
      "model");
  EXPECT_TRUE(loaded) << loaded.error().message;
  return loaded->model;
}

constexpr const char* kAcross =
    R"({"do": "fold", "line": {"paper": [[20, 0], [20, 40]]}, "type": "valley", "move": "left"})";
constexpr const char* kAlong =
    R"({"do": "fold", "line": {"model": [[20, 20], [40, 20]]}, "type": "valley", "move": "left"})";
constexpr const char* kUnfold = R"({"do": "unfold"})";

GalleryMoments momentsOf(const Model& model) {
  const Result<Timeline> timeline = Timeline::of(model);
  EXPECT_TRUE(timeline);
  return galleryMomentsOf(model, *timeline);
}

/// Degrees of the hinge that is folded most.
double mostFolded(const FoldedState& state) {
  double most = 0;
  for (const Edge& edge : state.pattern.edges) most = std::max(most, std::abs(edge.angle));
  return most;
}

TEST(GalleryMoments, AModelThatEndsFoldedIsFoldedAtItsEnd) {
  const GalleryMoments moments = momentsOf(modelFromSteps(kAcross));
  EXPECT_EQ(moments.folded, 1U);
  EXPECT_FALSE(moments.isOpenAtTheEnd);
  ASSERT_EQ(moments.halfWay, HalfWay::Unfolding);
  EXPECT_NEAR(mostFolded(*moments.half), 90, 1e-9);
  EXPECT_EQ(mostFolded(moments.unfolded), 0);
}

TEST(GalleryMoments, AModelThatIsUnfoldedIsFoldedBefore) {
  const std::string twice = std::string(kAcross) + "," + kAlong + ",";
  const GalleryMoments moments = momentsOf(modelFromSteps(twice + kUnfold));
  EXPECT_EQ(moments.folded, 2U);
  EXPECT_TRUE(moments.isOpenAtTheEnd);
  EXPECT_EQ(moments.halfWay, HalfWay::Unfolding);
}

TEST(GalleryMoments, OfSeveralFoldedMomentsThatOfMostFoldsCounts) {
  const std::string steps = std::string(kAcross) + "," + kAlong + "," + kUnfold;
  const std::string once =
      R"({"do": "fold", "line": {"paper": [[0, 10], [40, 10]]}, "type": "valley", "move": "left"})";
  EXPECT_EQ(momentsOf(modelFromSteps(steps + "," + once)).folded, 2U);
  EXPECT_FALSE(momentsOf(modelFromSteps(steps + "," + once)).isOpenAtTheEnd);
}

TEST(GalleryMoments, ASheetWithoutAFoldHasNothingToOpen) {
  const GalleryMoments moments = momentsOf(modelFromSteps(""));
  EXPECT_EQ(moments.folded, 0U);
  EXPECT_EQ(moments.halfWay, HalfWay::None);
  EXPECT_FALSE(moments.half);
}

TEST(GalleryLeaf, OfTheExamplesThePalmateLeavesAreMeasured) {
  std::set<std::string> measured;
  std::set<std::string> palmate;
  for (const auto& file : std::filesystem::directory_iterator(KIRI_SOURCE_DIR "/examples")) {
    if (file.path().extension() != ".kiri") continue;
    const std::string name = file.path().stem().string();
    // The hornbeam's leaf is pleated: its creases do not meet in the petiole.
    if (name.rfind("leaf_", 0) == 0 && name != "leaf_hornbeam") palmate.insert(name);
    const Result<std::string> text = readFile(file.path().string());
    ASSERT_TRUE(text);
    const Result<LoadedModel> loaded = readKiri(*text, name);
    ASSERT_TRUE(loaded) << loaded.error().message;
    const Result<Replay> replayed = replay(loaded->model);
    ASSERT_TRUE(replayed);
    const auto last = replayed->after(loaded->model.steps.size());
    ASSERT_TRUE(last) << name << ": " << last.error().message;
    // Whether it lies open does not decide here: the rest of the rule is enough.
    if (galleryLeafOf(loaded->model, **last, true)) measured.insert(name);
    EXPECT_FALSE(galleryLeafOf(loaded->model, **last, false)) << name;
  }
  EXPECT_EQ(measured, palmate);
}

}  // namespace
}  // namespace kiri::cli
