// Traditional models have the creases, outlines, layers and colours that folders know.
// SPDX-License-Identifier: MIT
#include <cmath>
#include <numbers>

#include "core/flatfold/flat_folding.h"
#include "core/model/pattern_model.h"
#include "core/paper/boxes.h"
#include "tests/examples/example_models.h"
#include "tests/examples/folded_shape.h"
#include "tests/support/expect.h"

namespace kiri::test {
namespace {

const double kRoot2 = std::sqrt(2.0);
constexpr double kHalfDiagonal = 100;  // of the square sheets that lie on a corner

double tanDegrees(double degrees) { return std::tan(degrees * std::numbers::pi / 180); }

const FoldedState& stateOf(const std::string& name, std::size_t steps) {
  return *exampleModel(name).states.at(steps);
}

/// After the fold of this name.
const FoldedState& stateAfter(const std::string& name, const std::string& fold) {
  const ExampleModel& example = exampleModel(name);
  for (std::size_t i = 0; i < example.model.steps.size(); ++i) {
    const auto* step = std::get_if<FoldStep>(&example.model.steps[i].action);
    if (step != nullptr && step->name == fold) return *example.states.at(i + 1);
  }
  ADD_FAILURE() << name << " has no fold \"" << fold << '"';
  return example.last();
}

double near(const FoldedState& state) { return 1e-9 * state.tolerance().sheetSize(); }

/// The drinking cup. The bisector of the angle at one corner of the folded triangle meets the far
/// edge where the other corner comes to lie, and the upper edge of the flap is then parallel to the
/// base ("Cup", perfectnow.net/origami; "Origami Cup", instructables.com, step 2).
TEST(Cup, ItsCornersLieWhereTheBisectorMeetsTheFarEdge) {
  const FoldedState& state = stateAfter("origami_cup", "left corner");
  const double x = (1 - tanDegrees(22.5)) / (1 + tanDegrees(22.5)) * kHalfDiagonal;
  const double y = kHalfDiagonal - x;  // on the far edge
  EXPECT_NEAR(y, (2 - kRoot2) * kHalfDiagonal, near(state));
  EXPECT_TRUE(liesAt(state, {-kHalfDiagonal, 0}, {x, y, 0}));
  // The crease ends on the near edge as high as that: what is folded ends in a line like the base.
  EXPECT_TRUE(hasVertex(state.pattern, {-x, y}) || hasVertex(state.pattern, {-x, -y}));
}

TEST(Cup, IsATrapezoidOfKnownProportions) {
  const FoldedState& cup = exampleModel("origami_cup").last();
  const double r = kHalfDiagonal;
  const double base = (3 - 2 * kRoot2) * r;
  const double rim = (kRoot2 - 1) * r;
  const double height = (2 - kRoot2) * r;
  EXPECT_TRUE(hasHull(cup, {{-base, 0}, {base, 0}, {rim, height}, {-rim, height}}));
  const SeenAreas front = seenFromFront(cup);
  EXPECT_NEAR(front.front + front.back, (base + rim) * height, 1e-6);
}

/// One flap is folded behind; the other is slid into the pocket of a corner ("Origami Cup",
/// maniaclychallenged.com), so that the outside of the paper is all that is seen in front.
TEST(Cup, ShowsTheInsideOfThePaperOnTheFlapBehindOnly) {
  const FoldedState& cup = exampleModel("origami_cup").last();
  const double flap = (kRoot2 - 1) * (kRoot2 - 1) * kHalfDiagonal * kHalfDiagonal;
  EXPECT_NEAR(seenFromFront(cup).front, 0, 1e-6);
  EXPECT_NEAR(seenFromBack(cup).front, flap, 1e-6);
}

TEST(Cup, HasAPocketBetweenItsSides) {
  const FoldedState& cup = exampleModel("origami_cup").last();
  EXPECT_EQ(layersAt(cup, {0, 5}), 2);   // below both corners: the two sides
  EXPECT_EQ(layersAt(cup, {1, 50}), 8);  // sides, two corners of two layers, two flaps
  // Liquid goes between the sides: all that is folded lies in front of both or behind both.
  EXPECT_TRUE(isAbove(cup, {0, -10}, {0, 10}) != isAbove(cup, {0, 10}, {0, -10}));
}

/// The samurai's helmet, kabuto.
TEST(Kabuto, GoesThroughASquareOfHalfTheDiagonal) {
  const double r = kHalfDiagonal;
  EXPECT_TRUE(hasHull(stateAfter("origami_samurai_hat", "right corner"),
                      {{0, -r}, {r / 2, -r / 2}, {0, 0}, {-r / 2, -r / 2}}));
}

TEST(Kabuto, HasHornsAt45DegreesAndABrimAsWideAsHalfTheDiagonal) {
  const FoldedState& hat = exampleModel("origami_samurai_hat").last();
  const double r = kHalfDiagonal / 2;
  const double horn = r / kRoot2;
  EXPECT_TRUE(hasHull(hat, {{-r, -r}, {r, -r}, {horn, horn - r}, {0, 0}, {-horn, horn - r}}));
}

/// 18 facets and 9 ways to lie: the count of Flat-Folder for its file kabuto.fold, in which the
/// back layer goes behind. Folders as often tuck it in, as the model does.
TEST(Kabuto, HasEighteenFacetsAndNineFoldedStates) {
  const FoldedState& hat = exampleModel("origami_samurai_hat").last();
  EXPECT_EQ(hat.pattern.facets.size(), 18u);
  AssignedPattern creases = assignedPatternOf(hat);
  int turned = 0;
  for (std::size_t e = 0; e < creases.pattern.edges.size(); ++e) {
    Edge& edge = creases.pattern.edges[e];
    const double low = -kHalfDiagonal / 2;
    const bool isBack = std::abs(creases.pattern[edge.from].y - low) < near(hat) &&
                        std::abs(creases.pattern[edge.to].y - low) < near(hat);
    if (!isBack || edge.kind != EdgeKind::Hinge) continue;
    edge.angle = -edge.angle;
    creases.assignments[e] = edge.angle > 0 ? Assignment::Valley : Assignment::Mountain;
    ++turned;
  }
  EXPECT_EQ(turned, 1);
  Result<FlatFolding> folding = flatFold(creases);
  ASSERT_TRUE(folding) << folding.error().message;
  ASSERT_TRUE(folding->states.count());
  EXPECT_EQ(folding->states.total(), 9);
}

/// The waterbomb base: a right-angled triangle whose long side is a side of the square, of four
/// layers everywhere, the middle of the sheet at the right angle ("Waterbomb Base",
/// itsjustabitofpaper.co.uk).
bool isWaterbombBase(const FoldedState& state) {
  if (!isFlat(state)) return false;
  const Vec3 tip = modelOf(state, {0, 0});
  const double down = modelOf(state, {100, 100}).y < tip.y ? -100 : 100;
  std::vector<Vec2> corners = {
      {tip.x, tip.y}, {tip.x - 100, tip.y + down}, {tip.x + 100, tip.y + down}};
  if (down > 0) std::swap(corners[1], corners[2]);
  if (!hasHull(state, corners)) return false;
  for (const Vec2 aside : {Vec2{3, 20}, Vec2{-40, 60}, Vec2{60, 70}, Vec2{1, 95}}) {
    if (layersAt(state, {tip.x + aside.x, tip.y + aside.y * down / 100}) != 4) return false;
  }
  return true;
}

TEST(WaterbombBase, IsARightAngledTriangleOfFourLayers) {
  const ExampleModel& butterfly = exampleModel("origami_butterfly");
  int bases = 0;
  for (const auto& state : butterfly.states) bases += isWaterbombBase(*state) ? 1 : 0;
  EXPECT_GE(bases, 1);
}

/// The jumping frog of a card w wide and 2 w long ("Origami Jumping Frogs", msnovak.blogspot.com,
/// steps 3 to 16; "Origami frog", everything2.com): its head is a waterbomb base of the upper half,
/// whose two flaps go up to the tip and make a square on its corner.
TEST(Frog, ItsHeadIsAWaterbombBaseWithBothFlapsUp) {
  const FoldedState& base = stateAfter("origami_frog", "right front flap");
  EXPECT_TRUE(liesAt(base, {-50, 100}, {-50, 0, 0}));  // the left flap still lies down
  const FoldedState& head = stateAfter("origami_frog", "left front flap");
  EXPECT_TRUE(hasHull(head, {{-50, -100}, {50, -100}, {50, 0}, {0, 50}, {-50, 0}}));
  EXPECT_TRUE(liesAt(head, {50, 100}, {0, 50, 0}));
  EXPECT_TRUE(liesAt(head, {-50, 100}, {0, 50, 0}));
  EXPECT_TRUE(liesAt(head, {0, 100}, {0, 0, 0}));
  EXPECT_EQ(layersAt(head, {10, 30}), 6);  // the base, and the flap folded on it
  EXPECT_EQ(layersAt(head, {40, 5}), 2);   // what lay below the flap
}

/// Then the sides go to the middle, and the lower edge goes up while its corners are pulled out:
/// a body half as wide as the card on a boat as wide as the card; its points turned down, a
/// hexagon.
TEST(Frog, ItsBodyIsHalfAsWideAsTheCardAndItsTailABoat) {
  const FoldedState& boat = stateAfter("origami_frog", "lower edge");
  EXPECT_TRUE(
      hasHull(boat, {{-25, -75}, {25, -75}, {50, -50}, {25, 25}, {0, 50}, {-25, 25}, {-50, -50}}));
  const FoldedState& legs = stateAfter("origami_frog", "left hind leg");
  EXPECT_TRUE(hasHull(legs, {{0, -100}, {25, -75}, {25, 25}, {0, 50}, {-25, 25}, {-25, -75}}));
  EXPECT_TRUE(liesAt(legs, {50, -100}, {0, -100, 0}));
  EXPECT_TRUE(liesAt(legs, {-50, -100}, {0, -100, 0}));
}

/// The bird base of a square of side 2: its creases meet tan 22.5 degrees from the sides
/// (oriedita's bird_base.fold; Lang, Origami Design Secrets). With all creases of its eight corner
/// triangles folded and no petal fold, its four flaps lie on each other.
TEST(BirdBase, HasFourFlapsAsLongAsHalfTheDiagonal) {
  const FoldedState& base = stateOf("pattern_bird_base", 1);
  const double half = 100;
  for (const Vec2 way : {Vec2{1, 0}, Vec2{0, 1}, Vec2{-1, 0}, Vec2{0, -1}}) {
    EXPECT_TRUE(hasVertex(base.pattern, Vec2{half, half} + way * (half * (2 - kRoot2))));
  }
  const SeenAreas seen = seenFromFront(base);
  EXPECT_NEAR(seen.front + seen.back, half * half * (1 - 1 / kRoot2), 1e-6);
  const Vec3 tip = modelOf(base, {0, 0});
  EXPECT_NEAR(distance(tip, modelOf(base, {half, half})), kRoot2 * half, near(base));
  for (const Vec2 corner : {Vec2{2 * half, 0}, Vec2{2 * half, 2 * half}, Vec2{0, 2 * half}}) {
    EXPECT_TRUE(liesAt(base, corner, tip));
  }
}

/// The paper hat, the first half of the boat: a triangle half as high as it is wide, whatever the
/// length of the sheet.
TEST(Boat, ItsHatIsATriangleHalfAsHighAsWide) {
  const double w = 210;
  const double brim = 297.0 / 2 - w / 2;
  EXPECT_TRUE(hasHull(stateOf("origami_boat", 11), {{0, brim}, {w, brim}, {w / 2, brim + w / 2}}));
}

/// Pressed flat it is w long, w / 2 at the keel and w / 4 high; opened by 60 degrees on each side,
/// these follow from paper that does not stretch.
TEST(Boat, IsAsLongAndWideAsThePaperLetsIt) {
  const FoldedState& boat = exampleModel("origami_boat").last();
  const double w = 210;
  const ModelBox box = modelBoxOf(boat);
  const Vec3 size = box.high - box.low;
  EXPECT_NEAR(size.x, w / 2 * (1 + std::sqrt(0.4)), 10 * near(boat));
  EXPECT_NEAR(size.y, w / 2 * std::sqrt(0.4), 10 * near(boat));  // of its points
  EXPECT_NEAR(size.z, w * std::sqrt(3.0) / 4, 10 * near(boat));
}

/// The crane: a bird base narrowed once more, so that all creases of its middle leave the corners
/// in steps of 11.25 degrees.
TEST(Crane, IsANarrowedBirdBase) {
  const FoldedState& base = exampleModel("origami_crane").last();
  const double r = kHalfDiagonal;
  const double t = tanDegrees(11.25);
  const double s = tanDegrees(22.5);
  const double u = tanDegrees(33.75);
  const Vec2 narrow{r * t / (1 + t), r * t / (1 + t)};
  const Vec2 wide{r * s / (1 + s), r * s / (1 + s)};
  EXPECT_NEAR(wide.x, r * (1 - 1 / kRoot2), 1e-12 * r);
  // x = (1 - y) tan 22.5 from the wing's corner, y = (1 - x) tan 33.75 from that of neck or tail.
  const double y = u * (1 - s) / (1 - s * u);
  const Vec2 edge{r * s * (1 - y), r * y};
  EXPECT_TRUE(hasVertex(base.pattern, {0, 0}));
  for (const Vec2 side : {Vec2{1, 1}, Vec2{-1, 1}, Vec2{-1, -1}, Vec2{1, -1}}) {
    for (const Vec2 place : {narrow, wide, edge}) {
      EXPECT_TRUE(hasVertex(base.pattern, {side.x * place.x, side.y * place.y}));
    }
  }
}

}  // namespace
}  // namespace kiri::test
