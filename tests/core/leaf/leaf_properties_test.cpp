// Leaves of random recipes measure as these say; what is refused is refused with the rays.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "core/leaf/leaf_measures.h"
#include "core/leaf/leaf_model.h"
#include "core/leaf/margin.h"
#include "core/leaf/secondary_lobes.h"
#include "core/model/replay.h"
#include "tests/support/order_check.h"

namespace kiri {
namespace {

/// Numbers that are the same on every platform.
class RecipeDice {
 public:
  explicit RecipeDice(unsigned seed) : engine_(seed) {}
  double between(double low, double high) {
    return low + (high - low) * (static_cast<double>(engine_()) / 4294967296.0);
  }
  std::size_t below(std::size_t count) {
    return std::min(count - 1, static_cast<std::size_t>(between(0, static_cast<double>(count))));
  }

 private:
  std::mt19937 engine_;
};

/// Angles and lengths as real palmate leaves have them, most of which can be cut by one margin.
LeafRecipe randomRecipe(RecipeDice& dice) {
  LeafRecipe recipe;
  recipe.midVein = dice.between(20, 300);
  const std::size_t count = 1 + dice.below(4);
  const double reach = dice.between(85, 150);
  double angle = 0;
  double folded = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const double sector = reach / static_cast<double>(count);
    const double outward = sector * dice.between(0.5, 0.62);
    angle += outward;
    recipe.antiVeins.push_back({angle, 0});
    folded += outward;
    const double back = std::min(sector - outward, folded) * dice.between(0.8, 1);
    angle += back;
    folded -= back;
    recipe.veins.push_back({angle, 0});
  }
  recipe.base.angle = angle + dice.between(8, 25);
  if (dice.below(4) == 0) {
    recipe.petiole = Petiole::OnEdge;
    const double scale = 90 / recipe.base.angle;
    for (LeafRay& ray : recipe.veins) ray.angle *= scale;
    for (LeafRay& ray : recipe.antiVeins) ray.angle *= scale;
    recipe.base.angle = 90;
  }
  return recipe;
}

/// Lengths that fall as the folded directions rise.
void giveLengths(LeafRecipe& recipe, RecipeDice& dice) {
  struct Slot {
    double folded;
    double* length;
  };
  std::vector<Slot> slots;
  double last = 0;
  double folded = 0;
  double unused = 1;
  for (std::size_t i = 0; i < recipe.veins.size(); ++i) {
    folded += recipe.antiVeins[i].angle - last;
    slots.push_back({folded, &recipe.antiVeins[i].length});
    folded -= recipe.veins[i].angle - recipe.antiVeins[i].angle;
    slots.push_back({folded, &recipe.veins[i].length});
    last = recipe.veins[i].angle;
  }
  slots.push_back({folded + recipe.base.angle - last, &recipe.base.length});
  slots.push_back({0, &unused});
  std::sort(slots.begin(), slots.end(),
            [](const Slot& a, const Slot& b) { return a.folded < b.folded; });
  const double least = dice.between(0.15, 0.4);
  const double most = slots.back().folded;
  double length = 1;
  for (const Slot& slot : slots) {
    const double part = slot.folded / most;
    length = std::min(length - 0.01, 1 - (1 - least) * std::pow(part, 0.7));
    *slot.length = slot.folded == 0 ? 1 : length;
  }
}

SecondaryLobes randomPair(const LeafRecipe& recipe, std::size_t lobe, RecipeDice& dice) {
  const double vein = lobe == 0 ? 1 : recipe.veins[lobe - 1].length;
  SecondaryLobes pair;
  pair.lobe = lobe;
  pair.at = dice.between(0.45, 0.75);
  pair.antiVein.angle = dice.between(12, 26);
  pair.vein.angle = pair.antiVein.angle * dice.between(1.25, 1.7);
  pair.vein.length = (1 - pair.at) * vein * dice.between(0.55, 0.9);
  pair.antiVein.length = pair.vein.length * dice.between(0.65, 0.92);
  return pair;
}

/// Further places beside the margin that the recipe has without them.
void givePlaces(LeafRecipe& recipe, RecipeDice& dice) {
  const Result<std::vector<FanRay>> fan = fanOf(recipe);
  if (!fan || !checkSecondaryLobes(recipe, *fan)) return;
  const FoldedHalf half(recipe, *fan);
  const Result<std::vector<MarginKnot>> knots = marginKnots(recipe, half);
  if (!knots) return;
  const Result<MarginCurve> curve = marginCurve(half, *knots);
  if (!curve) return;
  for (std::size_t i = 1 + dice.below(3); i > 0; --i) {
    const std::size_t facet = dice.below(half.creases().size() - 1);
    const std::vector<Vec2> margin = marginOfFacet(half, *curve, facet, 4);
    const Vec2 place = margin[margin.size() / 4 + dice.below(margin.size() / 2 + 1)];
    const double angle = angleDegrees(place.y, place.x) + dice.between(-2, 2);
    recipe.margin.push_back({angle, length(place) * dice.between(0.98, 1.02)});
  }
}

/// What the unfolded margin must show: the ends of all creases of both halves but the basal edge.
std::vector<MarginPoint> wantedOf(const LeafModel& leaf, double midVein) {
  std::vector<MarginPoint> wanted;
  for (const LeafCrease& crease : leaf.half.creases()) {
    if (crease.kind == RayKind::BasalEdge) continue;
    const double angle = angleDegrees(crease.end.y, crease.end.x);
    for (const double side : {1.0, -1.0}) {
      if (side < 0 && crease.end.x == 0) continue;
      wanted.push_back(
          {crease.kind == RayKind::Vein, crease.end, side * angle, length(crease.end) * midVein});
    }
  }
  std::sort(wanted.begin(), wanted.end(),
            [](const MarginPoint& a, const MarginPoint& b) { return a.angle < b.angle; });
  return wanted;
}

/// Replays the model of a recipe and holds it to what the recipe says.
void expectAsTold(const LeafRecipe& recipe, const LeafModel& leaf) {
  const Result<Replay> replayed = replay(leaf.model);
  ASSERT_TRUE(replayed) << replayed.error().message;
  const std::size_t count = leaf.model.steps.size();
  const auto last = replayed->after(count);
  ASSERT_TRUE(last) << last.error().message;
  EXPECT_TRUE((*last)->collisions.empty()) << (*last)->collisions.front().message;
  EXPECT_TRUE(isFlat(**last));
  const auto isMargin = [](const Step& step) {
    return std::holds_alternative<CurveCutStep>(step.action);
  };
  const auto margin = std::find_if(leaf.model.steps.begin(), leaf.model.steps.end(), isMargin);
  const auto folded =
      replayed->after(static_cast<std::size_t>(margin - leaf.model.steps.begin()) + 1);
  ASSERT_TRUE(folded);
  for (const std::string& violation : test::orderViolations(**folded)) ADD_FAILURE() << violation;

  MeasureOptions options;
  options.petiole = leaf.petiole;
  options.axis = 0;
  options.prominence = 1e-5;
  const Result<LeafMeasures> measures = measuresOf((*last)->pattern, options);
  ASSERT_TRUE(measures) << measures.error().message;
  EXPECT_LT(measures->asymmetry, 1e-9 * recipe.midVein);
  const std::vector<MarginPoint> wanted = wantedOf(leaf, recipe.midVein);
  ASSERT_EQ(measures->margin.size(), wanted.size());
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    EXPECT_EQ(measures->margin[i].isLobe, wanted[i].isLobe) << wanted[i].angle;
    EXPECT_NEAR(measures->margin[i].angle, wanted[i].angle, 0.1);
    EXPECT_NEAR(measures->margin[i].length, wanted[i].length, 1e-6 * wanted[i].length);
  }
}

/// The sentence names what the recipe's author wrote.
void expectNamed(const Error& error) {
  const std::string& sentence = error.message;
  const bool isNamed = sentence.find("vein") != std::string::npos ||
                       sentence.find("basal edge") != std::string::npos;
  EXPECT_TRUE(isNamed) << sentence;
  EXPECT_EQ(sentence.find("nan"), std::string::npos) << sentence;
}

struct Tally {
  int made = 0;
  int refused = 0;
};

void tally(const LeafRecipe& recipe, Tally& tally) {
  const Result<LeafModel> leaf = leafModelOf(recipe);
  if (!leaf) {
    ++tally.refused;
    expectNamed(leaf.error());
    return;
  }
  ++tally.made;
  expectAsTold(recipe, *leaf);
}

TEST(LeafProperties, ACreaseThatWouldRunIntoACornerOfTheSheetGetsAHigherSheet) {
  // A ray at atan(1/2) from the middle of the lower side runs into the upper corner of any square;
  // a little beside it, the fold would be drawn to the corner, and all that lies on it be askew.
  LeafRecipe recipe;
  recipe.petiole = Petiole::OnEdge;
  recipe.midVein = 43.750;
  recipe.antiVeins = {{13.5389, .4917}, {40.7494, .4616}, {68.3657, .3904}};
  recipe.veins = {{26.565, .9485}, {53.1320, .8522}, {77.8646, .6467}};
  recipe.base = {90, .3277};
  const Result<LeafModel> leaf = leafModelOf(recipe);
  ASSERT_TRUE(leaf) << leaf.error().message;
  expectAsTold(recipe, *leaf);
}

TEST(LeafProperties, RandomLeavesMeasureAsTheirRecipesSay) {
  Tally plain;
  Tally shaped;
  for (unsigned seed = 1; seed <= 60; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    RecipeDice dice(seed);
    LeafRecipe recipe = randomRecipe(dice);
    giveLengths(recipe, dice);
    tally(recipe, plain);
    givePlaces(recipe, dice);
    tally(recipe, shaped);
  }
  EXPECT_GT(plain.made, 50);
  EXPECT_GT(shaped.made, 30);
}

TEST(LeafProperties, RandomLeavesWithSecondaryLobesMeasureAsTheirRecipesSay) {
  Tally pairs;
  int onLateral = 0;
  int several = 0;
  int torn = 0;
  for (unsigned seed = 1; pairs.made < 10 && seed <= 4000; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    RecipeDice dice(seed);
    LeafRecipe recipe = randomRecipe(dice);
    giveLengths(recipe, dice);
    for (std::size_t lobe = 0; lobe <= std::min<std::size_t>(1, recipe.veins.size()); ++lobe) {
      if (dice.below(3) > 0) recipe.secondary.push_back(randomPair(recipe, lobe, dice));
    }
    if (recipe.secondary.empty()) continue;
    recipe.secondary[0].isTorn = recipe.secondary.size() == 1 && recipe.secondary[0].lobe == 0;
    if (dice.below(2) == 0) givePlaces(recipe, dice);
    const int before = pairs.made;
    tally(recipe, pairs);
    if (pairs.made == before) continue;
    onLateral += recipe.secondary.back().lobe > 0 ? 1 : 0;
    several += recipe.secondary.size() > 1 ? 1 : 0;
    torn += isTorn(recipe) ? 1 : 0;
  }
  EXPECT_EQ(pairs.made, 10);
  EXPECT_GT(pairs.refused, 0);
  EXPECT_GT(onLateral, 2);
  EXPECT_GT(several, 0);
  EXPECT_GT(torn, 0);
}

}  // namespace
}  // namespace kiri
