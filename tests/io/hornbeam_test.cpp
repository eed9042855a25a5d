// The corrugated leaf of Figure 3.4 opens all at once, by the law of its creases.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

#include "core/model/apply.h"
#include "core/model/replay.h"
#include "core/model/timeline.h"
#include "tests/support/example_files.h"
#include "tests/support/expect.h"
#include "tests/support/model_text.h"
#include "tests/support/state_check.h"

namespace kiri {
namespace {

constexpr double kVeinAngle = 45;
constexpr double kVeinDistance = 9.5;  // mm along the mid-vein
constexpr int kVeins = 12;

Model hornbeam() { return test::modelOfExample("leaf_hornbeam"); }

FoldedState stateAfter(const Model& model, std::size_t steps) {
  const Result<Replay> replayed = replay(model);
  EXPECT_TRUE(replayed.isOk());
  return **replayed->after(steps);
}

double radians(double degrees) { return degrees * std::numbers::pi / 180; }

/// Mid-vein fold angle for lateral angle s: tan(m / 2) = cos(a) tan(s / 2).
double midVeinAngle(double s) {
  return 2 * std::atan(std::cos(radians(kVeinAngle)) * std::tan(radians(s) / 2)) * 180 /
         std::numbers::pi;
}

bool isMidVein(const FoldedState& state, const Edge& edge) {
  return std::abs(state.pattern[edge.from].x - state.pattern[edge.to].x) < 1e-6;
}

/// Holds when all laterals are folded by one angle, all of the mid-vein by the angle that belongs
/// to it, neighbours along the mid-vein and the veins by turns one way and the other.
void expectCorrugated(const FoldedState& state, double s) {
  int laterals = 0;
  int midVein = 0;
  double sum = 0;
  for (const Edge& edge : state.pattern.edges) {
    if (edge.kind != EdgeKind::Hinge) continue;
    const bool isMiddle = isMidVein(state, edge);
    EXPECT_NEAR(std::abs(edge.angle), isMiddle ? midVeinAngle(s) : s, 1e-7);
    ++(isMiddle ? midVein : laterals);
    sum += edge.angle;
  }
  EXPECT_EQ(laterals, 2 * kVeins);
  EXPECT_EQ(midVein, kVeins + 1);
  EXPECT_NEAR(std::abs(sum), midVeinAngle(s), 1e-6);  // one more of the mid-vein one way
  EXPECT_LE(test::hingeGap(state), 1e-9 * state.tolerance().sheetSize());
}

/// Length of the mid-vein from the first to the last vein as part of its length on the sheet.
double midVeinRatio(const FoldedState& state) {
  const auto place = [&](int vein) {
    const Vec2 paper{50, 17 + kVeinDistance * vein};
    return state.poseOf(*facetAt(state.pattern, paper)).apply(paper);
  };
  return distance(place(0), place(kVeins - 2)) / (kVeinDistance * (kVeins - 2));
}

TEST(Hornbeam, OpensAllAtOnceByItsLaw) {
  const Model model = hornbeam();
  const double last = static_cast<double>(model.steps.size());
  Movements movements;
  ASSERT_TRUE(apply(stateAfter(model, model.steps.size() - 1), model.steps.back(),
                    static_cast<int>(last), &movements)
                  .isOk());
  EXPECT_EQ(movements.size(), 1u);
  for (const double part : {0.05, 0.3, 0.5, 0.77, 0.95}) {
    const Result<FoldedState> state = stateBetween(model, last - 1 + part);
    ASSERT_TRUE(state.isOk());
    const double s = 180 * (1 - part);
    expectCorrugated(*state, s);
    const double sine = std::sin(radians(kVeinAngle)) * std::sin(radians(s) / 2);
    EXPECT_NEAR(midVeinRatio(*state), std::sqrt(1 - sine * sine), 1e-9);
    EXPECT_EQ(test::joined(test::violationsOf(*state)), "");
  }
}

TEST(Hornbeam, FoldsToWhatTheVeinAngleLeavesOfTheMidVein) {
  const Model model = hornbeam();
  const FoldedState folded = stateAfter(model, model.steps.size() - 1);
  EXPECT_TRUE(isFlat(folded));
  EXPECT_NEAR(midVeinRatio(folded), std::cos(radians(kVeinAngle)), 1e-12);
  expectCorrugated(folded, 180);
}

TEST(Hornbeam, OneSliderMovesAllCreases) {
  const Model model = hornbeam();
  const FoldedState open = stateAfter(model, model.steps.size());
  for (const char* vein : {"55,41", "45,88.5"}) {  // places on two lateral veins
    const FoldedState half = test::after(open, "angle " + std::string(vein) + " 70");
    expectCorrugated(half, 70);
    EXPECT_TRUE(test::isClean(half));
    expectCorrugated(test::after(half, "angle " + std::string(vein) + " 150"), 150);
    EXPECT_TRUE(isFlat(test::after(half, "angle " + std::string(vein) + " 180")));
    EXPECT_TRUE(isFlat(test::after(half, "angle " + std::string(vein) + " 0")));
  }
}

}  // namespace
}  // namespace kiri
