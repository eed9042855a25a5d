// The leaves of the thesis: recipes and models in examples/ agree, and measure as they say.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>

#include "core/geometry/rigid.h"
#include "core/leaf/leaf_measures.h"
#include "core/leaf/leaf_model.h"
#include "core/model/replay.h"
#include "core/paper/contours.h"
#include "io/file.h"
#include "io/kiri_reader.h"
#include "io/kiri_writer.h"
#include "io/leaf_recipe_reader.h"

namespace kiri {
namespace {

const std::string kLeafFolder = KIRI_SOURCE_DIR "/examples/";

/// Recipes by name, each as examples/leaves/NAME.json has it.
std::map<std::string, LeafRecipe> leafRecipes() {
  std::map<std::string, LeafRecipe> recipes;
  for (const auto& entry : std::filesystem::directory_iterator(kLeafFolder + "leaves")) {
    const Result<std::string> text = readFile(entry.path().string());
    EXPECT_TRUE(text) << entry.path();
    const Result<LoadedRecipe> loaded = readLeafRecipe(*text, entry.path().string());
    EXPECT_TRUE(loaded) << loaded.error().message;
    recipes.emplace(entry.path().stem().string(), loaded->recipe);
  }
  return recipes;
}

std::string leafFileOf(const std::string& name) { return kLeafFolder + "leaf_" + name + ".kiri"; }

FoldedState unfoldedLeaf(const std::string& name) {
  const Result<std::string> text = readFile(leafFileOf(name));
  EXPECT_TRUE(text) << leafFileOf(name);
  const Result<LoadedModel> loaded = readKiri(*text, name);
  EXPECT_TRUE(loaded) << loaded.error().message;
  const Result<Replay> replayed = replay(loaded->model);
  EXPECT_TRUE(replayed);
  const auto last = replayed->after(loaded->model.steps.size());
  EXPECT_TRUE(last) << last.error().message;
  return **last;
}

/// Tips and sinuses that a recipe asks for, from its words alone; the petiole is the origin, the
/// mid-vein points along +y.
class WantedMargin {
 public:
  explicit WantedMargin(const LeafRecipe& recipe) : midVein_(recipe.midVein) {
    const auto both = [&](const LeafRay& ray, bool isLobe) {
      for (const double side : {1.0, -1.0}) add(isLobe, rayEnd({0, 0}, ray.angle * side, ray));
    };
    add(true, rayEnd({0, 0}, 0, {0, 1}));
    for (const LeafRay& ray : recipe.veins) both(ray, true);
    for (const LeafRay& ray : recipe.antiVeins) both(ray, false);
    for (const SecondaryLobes& pair : recipe.secondary) addPair(recipe, pair);
    std::sort(points_.begin(), points_.end(),
              [](const MarginPoint& a, const MarginPoint& b) { return a.angle < b.angle; });
  }

  const std::vector<MarginPoint>& points() const { return points_; }

 private:
  Vec2 rayEnd(Vec2 from, double angle, const LeafRay& ray) const {
    const CosSin w = cosSinDegrees(angle);
    return from + Vec2{w.sin, w.cos} * (ray.length * midVein_);
  }

  void add(bool isLobe, Vec2 place) {
    points_.push_back({isLobe, place, angleDegrees(place.y, place.x), length(place)});
  }

  /// On both sides of the pair's vein, and for a side lobe in both halves.
  void addPair(const LeafRecipe& recipe, const SecondaryLobes& pair) {
    const LeafRay main = pair.lobe == 0 ? LeafRay{0, 1} : recipe.veins[pair.lobe - 1];
    for (const double half : {1.0, -1.0}) {
      if (pair.lobe == 0 && half < 0) continue;
      const double axis = half * main.angle;
      const Vec2 junction = rayEnd({0, 0}, axis, {0, pair.at * main.length});
      for (const double side : {1.0, -1.0}) {
        add(true, rayEnd(junction, axis + side * pair.vein.angle, pair.vein));
        add(false, rayEnd(junction, axis + side * pair.antiVein.angle, pair.antiVein));
      }
    }
  }

  double midVein_;
  std::vector<MarginPoint> points_;
};

TEST(LeavesOfTheThesis, AreTheModelsThatTheirRecipesMake) {
  const auto recipes = leafRecipes();
  EXPECT_EQ(recipes.size(), 10u);
  for (const auto& [name, recipe] : recipes) {
    SCOPED_TRACE(name);
    const Result<LeafModel> leaf = leafModelOf(recipe);
    ASSERT_TRUE(leaf) << leaf.error().message;
    const Result<std::string> text = readFile(leafFileOf(name));
    ASSERT_TRUE(text) << "tools/make_leaves.sh makes it";
    EXPECT_TRUE(writeKiri(leaf->model) == *text) << "tools/make_leaves.sh makes it again";
  }
}

TEST(LeavesOfTheThesis, HaveTheLobesAndSinusesOfTheirRecipesAtTheirAngles) {
  std::size_t secondaryCount = 0;
  for (const auto& [name, recipe] : leafRecipes()) {
    SCOPED_TRACE(name);
    const Result<LeafMeasures> measures = measuresOf(unfoldedLeaf(name).pattern);
    ASSERT_TRUE(measures) << measures.error().message;
    const WantedMargin wanted(recipe);
    std::vector<MarginPoint> found = measures->margin;
    std::sort(found.begin(), found.end(),
              [](const MarginPoint& a, const MarginPoint& b) { return a.angle < b.angle; });
    ASSERT_EQ(found.size(), wanted.points().size());
    EXPECT_EQ(measures->sinusCount, measures->lobeCount - 1);
    for (std::size_t i = 0; i < found.size(); ++i) {
      const MarginPoint& point = wanted.points()[i];
      EXPECT_EQ(found[i].isLobe, point.isLobe) << point.angle;
      EXPECT_NEAR(found[i].angle, point.angle, 0.1);
      EXPECT_NEAR(found[i].length, point.length, 0.002 * recipe.midVein) << point.angle;
    }
    secondaryCount += recipe.secondary.size();
  }
  EXPECT_GE(secondaryCount, 3u) << "on mid-lobes and on side lobes";
}

/// How far the mirror image of an arc is from the nearest of the others, end by end.
double mirrorGap(const Arc& arc, const std::vector<Arc>& others, double axis) {
  const auto mirrored = [&](Vec2 p) { return Vec2{2 * axis - p.x, p.y}; };
  double best = HUGE_VAL;
  for (const Arc& other : others) {
    if (other.isCurved != arc.isCurved) continue;
    double gap = std::max(distance(mirrored(arc.start), other.end),
                          distance(mirrored(arc.end), other.start));
    if (arc.isCurved) {
      gap = std::max({gap, distance(mirrored(arc.control1), other.control2),
                      distance(mirrored(arc.control2), other.control1)});
    }
    best = std::min(best, gap);
  }
  return best;
}

TEST(LeavesOfTheThesis, AreTheirOwnMirrorImages) {
  for (const auto& [name, recipe] : leafRecipes()) {
    SCOPED_TRACE(name);
    const FoldedState leaf = unfoldedLeaf(name);
    const auto contours = contoursOf(leaf.pattern);
    ASSERT_EQ(contours.size(), 1u);
    std::vector<Arc> arcs;
    for (const EdgeUse use : contours.front()) arcs.push_back(arcOf(leaf.pattern, use));
    EXPECT_GT(arcs.size(), 20u);
    const double axis = measuresOf(leaf.pattern)->petiole.x;
    for (const Arc& arc : arcs) {
      EXPECT_LE(mirrorGap(arc, arcs, axis), 1e-9 * leaf.tolerance().sheetSize())
          << "at " << arc.start.x << ", " << arc.start.y;
    }
  }
}

}  // namespace
}  // namespace kiri
