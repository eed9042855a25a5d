// Leaves made from recipes have the lobes and sinuses that the recipes ask for.
// SPDX-License-Identifier: MIT
#include "core/leaf/leaf_model.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/model/replay.h"
#include "core/model/timeline.h"
#include "core/paper/contours.h"

namespace kiri {
namespace {

/// Recipes from leaves.md section 2.
LeafRecipe sycamore() {
  LeafRecipe recipe;
  recipe.title = "Acer pseudoplatanus";
  recipe.veins = {{42, .88}, {88, .58}};
  recipe.antiVeins = {{24, .62}, {75, .45}};
  recipe.base = {118, .30};
  return recipe;
}

LeafRecipe fatsia() {
  LeafRecipe recipe;
  recipe.veins = {{33, .98}, {66, .93}, {100, .84}, {138, .68}};
  recipe.antiVeins = {{17, .45}, {50.5, .42}, {84.5, .38}, {121, .33}};
  recipe.base = {165, .25};
  return recipe;
}

LeafRecipe vineMaple() {
  LeafRecipe recipe;
  recipe.petiole = Petiole::OnEdge;
  recipe.veins = {{25.8, .95}, {56.3, .76}};
  recipe.antiVeins = {{15.1, .62}, {44.5, .51}};
  recipe.base = {90, .34};
  return recipe;
}

/// Local extremes of the radius along the margin, as rays: degrees from the mid-vein, clockwise.
std::vector<LeafRay> extremesOf(const CreasePattern& pattern, Vec2 petiole, double midVein) {
  std::vector<Vec2> points;
  const auto contours = contoursOf(pattern);
  EXPECT_EQ(contours.size(), 1u);
  for (const EdgeUse use : contours.front()) {
    const Arc arc = arcOf(pattern, use);
    for (int k = 0; k < 200; ++k) points.push_back(pointAt(arc, k / 200.0));
  }
  std::vector<LeafRay> rays;
  const std::size_t n = points.size();
  for (std::size_t i = 0; i < n; ++i) {
    const double before = distance(points[(i + n - 1) % n], petiole);
    const double here = distance(points[i], petiole);
    const double after = distance(points[(i + 1) % n], petiole);
    if (here < midVein * 0.01 || (here - before) * (after - here) > 0) continue;
    const Vec2 d = points[i] - petiole;
    rays.push_back({std::atan2(d.x, d.y) * 180 / std::numbers::pi, here / midVein});
  }
  return rays;
}

void expectRays(const LeafRecipe& recipe) {
  const Result<LeafModel> leaf = leafModelOf(recipe);
  ASSERT_TRUE(leaf) << leaf.error().message;
  const Result<Replay> replayed = replay(leaf->model);
  ASSERT_TRUE(replayed);
  const auto last = replayed->after(leaf->model.steps.size());
  ASSERT_TRUE(last) << last.error().message;
  const FoldedState& state = **last;
  EXPECT_TRUE(state.collisions.empty()) << state.collisions.front().message;
  EXPECT_TRUE(isFlat(state));
  const Vec2 petiole = leaf->petiole;
  const auto found = extremesOf(state.pattern, petiole, recipe.midVein);
  for (const LeafCrease& crease : leaf->half.creases()) {
    if (crease.kind == RayKind::BasalEdge) continue;
    const double end = angleDegrees(crease.end.y, crease.end.x);
    for (const double angle : {end, -end}) {
      const auto near = std::find_if(found.begin(), found.end(), [&](const LeafRay& r) {
        return std::abs(r.angle - angle) < 0.1 && std::abs(r.length - length(crease.end)) < 0.002;
      });
      EXPECT_NE(near, found.end()) << crease.name << " at " << angle;
    }
  }
}

TEST(LeafModel, HasItsLobesAndSinusesWhereTheRecipePutsThem) {
  for (const LeafRecipe& recipe : {sycamore(), fatsia(), vineMaple()}) expectRays(recipe);
}

LeafRecipe mapleWithSecondaryLobes(bool isTorn) {
  LeafRecipe recipe;
  recipe.veins = {{46, .85}, {96, .44}};
  recipe.antiVeins = {{30, .55}, {82, .36}};
  recipe.base = {121, .28};
  recipe.secondary = {{0, 0.5, {22, .30}, {34, .36}, isTorn}};
  return recipe;
}

TEST(LeafModel, SecondaryLobesAreWhereTheRecipePutsThemWithATearOrWithout) {
  for (const bool isTorn : {false, true}) {
    SCOPED_TRACE(isTorn ? "torn" : "at once");
    const LeafRecipe recipe = mapleWithSecondaryLobes(isTorn);
    const Result<LeafModel> leaf = leafModelOf(recipe);
    ASSERT_TRUE(leaf) << leaf.error().message;
    const Result<Replay> replayed = replay(leaf->model);
    ASSERT_TRUE(replayed);
    const auto last = replayed->after(leaf->model.steps.size());
    ASSERT_TRUE(last) << last.error().message;
    EXPECT_TRUE((*last)->collisions.empty());
    EXPECT_TRUE(isFlat(**last));
    const auto found = extremesOf((*last)->pattern, leaf->petiole, recipe.midVein);
    for (const LeafRay& ray : {recipe.secondary[0].antiVein, recipe.secondary[0].vein}) {
      const double radians = ray.angle * std::numbers::pi / 180;
      const double x = ray.length * std::sin(radians);
      const double y = 0.5 + ray.length * std::cos(radians);
      const double angle = std::atan2(x, y) * 180 / std::numbers::pi;
      for (const double side : {1.0, -1.0}) {
        const auto near = std::find_if(found.begin(), found.end(), [&](const LeafRay& r) {
          return std::abs(r.angle - side * angle) < 0.1 &&
                 std::abs(r.length - std::hypot(x, y)) < 0.002;
        });
        EXPECT_NE(near, found.end()) << ray.angle << " on side " << side;
      }
    }
  }
}

TEST(LeafModel, OpensAllItsFoldsAtOnceWithATearOrWithout) {
  for (const LeafRecipe& recipe :
       {sycamore(), mapleWithSecondaryLobes(false), mapleWithSecondaryLobes(true)}) {
    const Result<LeafModel> leaf = leafModelOf(recipe);
    ASSERT_TRUE(leaf) << leaf.error().message;
    const Result<Timeline> timeline = Timeline::of(leaf->model);
    ASSERT_TRUE(timeline) << timeline.error().message;
    const bool isTorn = !recipe.secondary.empty() && recipe.secondary[0].isTorn;
    const std::size_t opening = leaf->model.steps.size() - (isTorn ? 2 : 1);
    ASSERT_EQ(timeline->movementsOf(opening).size(), 1u);
    const FoldedState half = stateAlong(timeline->movementsOf(opening), 0.5);
    for (const Edge& edge : half.pattern.edges) {
      if (edge.kind == EdgeKind::Hinge) EXPECT_GT(std::abs(edge.angle), 10);
    }
  }
}

TEST(LeafModel, ASecondaryVeinFoldedPastTheMidVeinIsRefused) {
  LeafRecipe recipe = mapleWithSecondaryLobes(false);
  recipe.secondary[0].antiVein.angle = 15;
  const Result<LeafModel> leaf = leafModelOf(recipe);
  ASSERT_FALSE(leaf);
  EXPECT_NE(leaf.error().message.find("to 17 degrees or more"), std::string::npos)
      << leaf.error().message;
}

/// Near the means of eight sugar maples, with pairs on the mid-lobe and the lobes beside it.
LeafRecipe sugarMaple() {
  LeafRecipe recipe;
  recipe.midVein = 120;
  recipe.veins = {{41.7, .785}, {96, .477}};
  recipe.antiVeins = {{26.4, .531}, {84, .362}};
  recipe.base = {112.8, .274};
  recipe.secondary = {{0, .4155, {12.4, .408}, {19, .431}}, {1, .637, {21.3, .184}, {32.2, .229}}};
  return recipe;
}

void expectRefused(const LeafRecipe& recipe, const std::string& sentence) {
  const Result<LeafModel> leaf = leafModelOf(recipe);
  ASSERT_FALSE(leaf) << "not refused: " << sentence;
  EXPECT_EQ(leaf.error().message, sentence);
}

TEST(LeafModel, ASecondaryPairThatCannotBeFoldedIsRefusedWithTheRemedy) {
  LeafRecipe recipe = sugarMaple();
  recipe.secondary[1].lobe = 3;
  expectRefused(
      recipe,
      "there is no lobe 3 for secondary lobes: 0 is the mid-lobe, and the veins beside it "
      "give 1 to 2");
  recipe = sugarMaple();
  recipe.secondary[1].isTorn = true;
  expectRefused(
      recipe,
      "secondary lobes of lobe 1 cannot be folded with a tear: it runs along the mid-vein "
      "and frees the mid-lobe only; leave out \"torn\", for all creases can be folded at "
      "once");
  recipe = sugarMaple();
  recipe.secondary[1].lobe = 0;
  recipe.secondary[1].at = recipe.secondary[0].at;
  expectRefused(recipe,
                "two pairs of secondary lobes leave one vein at the same place, 0.4155 of its "
                "length; move one of them");
  recipe = sugarMaple();
  recipe.secondary[1] = {1, .3, {30, .35}, {50, .5}};
  expectRefused(
      recipe,
      "the secondary vein of lobe 1 reaches 34.5195 degrees beside its vein, beyond the "
      "first anti-vein, which is 15.3 beside it; make it shorter or steeper, or let it leave the "
      "vein farther out");
  recipe = sugarMaple();
  recipe.secondary[1].at = 0.999;
  expectRefused(
      recipe,
      "secondary lobes leave a vein between petiole (0) and tip (1), not nearer to either "
      "than 0.01; those of lobe 1 not at 0.999");
  recipe = sugarMaple();
  recipe.secondary[1].antiVein.angle = 40;
  expectRefused(recipe,
                "the secondary anti-vein of lobe 1 (40 degrees) stands behind its vein (32.2): no "
                "crease would end in the sinus between the two tips; give it a smaller angle than "
                "the vein");
  recipe = sugarMaple();
  recipe.secondary[0].vein.length = .4;
  expectRefused(recipe,
                "from the junction on the mid-lobe, the outer part of its vein (0.5845), the "
                "secondary vein (0.4) and its anti-vein (0.408) must be shorter from one to the "
                "next");
}

TEST(LeafModel, AnglesThatOverlapAreRefusedWithTheRays) {
  LeafRecipe recipe = sycamore();
  recipe.antiVeins[1].angle = 41;
  expectRefused(recipe,
                "the angles overlap: the second anti-vein (41 degrees) must lie farther from the "
                "mid-vein than the second vein (42 degrees)");
  recipe = sycamore();
  recipe.antiVeins.pop_back();
  expectRefused(recipe,
                "there must be one anti-vein before each vein beside the mid-vein: 2 veins, but 1 "
                "anti-veins");
}

TEST(LeafModel, AMarginThatMissesALayerIsRefusedWithTheRays) {
  LeafRecipe recipe = sugarMaple();
  recipe.secondary.pop_back();  // the mid-lobe alone is turned onto the lobe beside it
  recipe.secondary[0] = {0, .5, {22, .3}, {34, .36}};
  expectRefused(recipe,
                "no single margin cuts the secondary vein of the mid-lobe and the secondary "
                "anti-vein of the mid-lobe so that they end in a tip and a sinus: between them it "
                "would leave the paper between their creases at the second vein (folded it lies at "
                "11.1 degrees, 0.785 from the petiole); secondary lobes turn the end of the "
                "mid-vein to 12 degrees: fold the second vein to about as much, or give its lobe "
                "a pair that turns it alike");
}

TEST(LeafModel, RaysThatNoSingleMarginCutsAreRefusedWithARemedyThatWorks) {
  LeafRecipe recipe;  // a grape leaf as measured
  recipe.veins = {{51, .86}, {106, .63}};
  recipe.antiVeins = {{36, .47}, {96, .45}};
  recipe.base = {165, .3};
  expectRefused(recipe,
                "no single margin cuts both the first anti-vein (folded it lies at 36 degrees, "
                "0.47 from the petiole) and the third vein (folded it lies at 56 degrees, 0.63 "
                "from the petiole): it must come nearer to the petiole from one to the next; give "
                "the third vein a length below 0.47, or the first anti-vein one above 0.63, or "
                "move the second anti-vein inward, to less than 86 degrees");
  recipe.antiVeins[1].angle = 85.5;
  EXPECT_TRUE(leafModelOf(recipe));
  recipe.antiVeins[1].angle = 96;
  recipe.veins[1].length = .46;
  EXPECT_TRUE(leafModelOf(recipe)) << leafModelOf(recipe).error().message;
}

TEST(LeafModel, APairThatTurnsItsLobeAloneIsRefusedWithARemedyThatWorks) {
  LeafRecipe recipe = sycamore();
  recipe.secondary = {{0, .5, {22, .3}, {32, .36}}};
  const Result<LeafModel> leaf = leafModelOf(recipe);
  ASSERT_FALSE(leaf);
  EXPECT_NE(leaf.error().message.find("turn the end of the mid-vein to 10 degrees"),
            std::string::npos)
      << leaf.error().message;
  recipe.antiVeins = {{26, .58}, {74, .43}};  // folds the second vein to 10 degrees
  recipe.veins[1].length = .5;
  EXPECT_TRUE(leafModelOf(recipe)) << leafModelOf(recipe).error().message;
}

TEST(LeafModel, ATornPairWhoseCreasesMeetOthersOnTheSheetIsRefused) {
  LeafRecipe recipe;
  recipe.veins = {{23, .782}, {47, .756}};
  recipe.antiVeins = {{15, .629}, {35.6, .546}};
  recipe.base = {65, .5};
  recipe.secondary = {{0, .748, {24, .13}, {38.2, .182}, false}};
  EXPECT_TRUE(leafModelOf(recipe));
  recipe.secondary[0].isTorn = true;
  expectRefused(
      recipe,
      "the secondary vein of the mid-lobe (38.2 degrees) meets the first anti-vein (15 "
      "degrees) inside the sheet, so neither can be folded; make it steeper, or leave out "
      "\"torn\": on a sheet cut around the blade they stay apart");
}

TEST(LeafModel, AFlapFoldedPastTheMidVeinIsRefusedWithTheRemedy) {
  LeafRecipe recipe = sycamore();
  recipe.veins[0].angle = 60;
  const Result<LeafModel> leaf = leafModelOf(recipe);
  ASSERT_FALSE(leaf);
  EXPECT_NE(leaf.error().message.find("second vein (60 degrees) would be folded 12 degrees past"),
            std::string::npos)
      << leaf.error().message;
}

/// The unfolded margin of a recipe's model, about its petiole.
std::vector<LeafRay> marginOf(const LeafRecipe& recipe) {
  const Result<LeafModel> leaf = leafModelOf(recipe);
  EXPECT_TRUE(leaf) << leaf.error().message;
  if (!leaf) return {};
  const Result<Replay> replayed = replay(leaf->model);
  const auto last = replayed->after(leaf->model.steps.size());
  EXPECT_TRUE(last) << last.error().message;
  if (!last) return {};
  const Vec2 petiole = leaf->petiole;
  std::vector<LeafRay> margin;
  const auto contours = contoursOf((*last)->pattern);
  for (const EdgeUse use : contours.front()) {
    const Arc arc = arcOf((*last)->pattern, use);
    for (int k = 0; k < 400; ++k) {
      const Vec2 d = pointAt(arc, k / 400.0) - petiole;
      margin.push_back({std::atan2(d.x, d.y) * 180 / std::numbers::pi, length(d) / recipe.midVein});
    }
  }
  return margin;
}

/// How far a place of the recipe is from the margin on one side, in lengths of the mid-vein.
double missOf(const std::vector<LeafRay>& margin, const LeafRay& place, int side) {
  double nearest = 1;
  for (const LeafRay& p : margin) {
    const double across = (p.angle - side * place.angle) * std::numbers::pi / 180 * p.length;
    nearest = std::min(nearest, std::hypot(across, p.length - place.length));
  }
  return nearest;
}

void expectPlaces(const LeafRecipe& recipe) {
  const std::vector<LeafRay> margin = marginOf(recipe);
  for (const LeafRay& place : recipe.margin) {
    for (const int side : {1, -1}) {
      EXPECT_LT(missOf(margin, place, side), 2e-4) << place.angle << " on side " << side;
    }
  }
}

TEST(LeafModel, ItsMarginPassesTheFurtherPlacesOnBothHalves) {
  LeafRecipe recipe = sycamore();
  // On the mid-lobe, which becomes narrower below than above, and beyond the last vein.
  recipe.margin = {{12, .8}, {9, .7}, {96, .5}};
  expectPlaces(recipe);
  expectRays(recipe);
}

TEST(LeafModel, ItsSheetHoldsABladeThatIsWiderThanItsVeinsReach) {
  LeafRecipe fan;
  fan.base = {66, .2};
  fan.margin = {{20, .97}, {40, .94}, {55, .9}, {63, .8}};
  expectPlaces(fan);
  fan.base = {150, .2};
  fan.margin = {{90, .95}, {120, .9}, {140, .85}};
  expectPlaces(fan);
}

TEST(LeafModel, APlaceThatNoSingleMarginPassesIsRefusedWithTheRaysAndTheLengthsBetween) {
  LeafRecipe recipe = sycamore();
  recipe.margin = {{12, .95}};
  const Result<LeafModel> tooFar = leafModelOf(recipe);
  ASSERT_FALSE(tooFar);
  EXPECT_EQ(
      tooFar.error().message,
      "no single margin passes the place of the margin at 12 degrees, 0.95: folded it lies at "
      "12 degrees, between the second vein and the first anti-vein, and the margin falls from "
      "0.88 to 0.62 there; give it a length in between");
  recipe.margin = {{24, .7}};
  const Result<LeafModel> onSinus = leafModelOf(recipe);
  ASSERT_FALSE(onSinus);
  EXPECT_EQ(onSinus.error().message,
            "no single margin passes the place of the margin at 24 degrees, 0.7: folded it lies on "
            "the first anti-vein, which the margin meets at 0.62; leave it out");
  recipe.margin = {{12, .8}, {9, .8}};
  const Result<LeafModel> twice = leafModelOf(recipe);
  ASSERT_FALSE(twice);
  EXPECT_NE(twice.error().message.find("equally far"), std::string::npos) << twice.error().message;
  recipe.margin = {{119, .2}};
  const Result<LeafModel> beyond = leafModelOf(recipe);
  ASSERT_FALSE(beyond);
  EXPECT_NE(beyond.error().message.find("beyond the basal edge (118 degrees)"), std::string::npos);
}

TEST(LeafModel, EveryStepHasATitleAndNotes) {
  for (const LeafRecipe& recipe :
       {sycamore(), vineMaple(), mapleWithSecondaryLobes(false), mapleWithSecondaryLobes(true)}) {
    const Result<LeafModel> leaf = leafModelOf(recipe);
    ASSERT_TRUE(leaf);
    for (const Step& step : leaf->model.steps) {
      EXPECT_FALSE(step.title.empty());
      EXPECT_EQ(step.notes.empty() ? ' ' : step.notes.back(), '.') << step.title;
    }
  }
}

}  // namespace
}  // namespace kiri
