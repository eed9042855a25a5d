// The unfolded margin of a leaf: reflected curves, and the law that one straight cut obeys (guide:
// leaves 1.2). SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>

#include "tests/support/expect.h"
#include "tests/support/margin_reference.h"
#include "tests/support/model_text.h"
#include "tests/support/random_steps.h"

namespace kiri::test {
namespace {

constexpr double kDegree = std::numbers::pi / 180;
constexpr Vec2 kPetiole{100, 0};  // on the border of a sheet 200 x 120

Vec2 rayEnd(double degrees, double length) {
  return kPetiole + Vec2{std::cos(degrees * kDegree), std::sin(degrees * kDegree)} * length;
}

std::string text(Vec2 p) {
  char buffer[80];
  std::snprintf(buffer, sizeof buffer, "%.17g,%.17g", p.x, p.y);
  return buffer;
}

/// A fan of creases through the petiole, folded one after the other: the paper beyond each crease,
/// counted against the clock, is turned over on top of the rest.
struct Fan {
  std::vector<double> axes;  // degrees on the sheet, growing
  std::string model;         // text of the folded model
  std::vector<DrawnFold> folds;
  std::vector<double> folded;  // degrees of the axes as folded

  explicit Fan(const std::vector<double>& sheetAxes) : axes(sheetAxes), model("rectangle 200 120") {
    double turn = 1;
    double at = axes.front();
    for (std::size_t i = 0; i < axes.size(); ++i) {
      if (i > 0) at += turn * (axes[i] - axes[i - 1]);
      folded.push_back(at);
      folds.push_back({kPetiole, rayEnd(at, 400), std::make_pair(kPetiole, rayEnd(axes[i], 400))});
      const double beyond = i + 1 < axes.size() ? (axes[i] + axes[i + 1]) / 2 : (axes[i] + 180) / 2;
      const Vec2 inBeyond = rayEnd(beyond, 20);
      model += ";fold f" + std::to_string(i) + " valley " + text(kPetiole) + " " +
               text(rayEnd(axes[i], 400)) + " to p:" + text(inBeyond) +
               " facets p:" + text(inBeyond) + " in " + text(inBeyond);
      turn = -turn;
    }
  }
};

TEST(Margin, EqualsTheCurveReflectedThroughTheFolds) {
  const Fan fan({70, 100, 125});
  const std::string controls = " 20,20 70,60 100,75 130,60 160,40 180,-30";
  const FoldedState cut =
      run(fan.model + ";curve @model" + controls + " keep m:" + text(rayEnd(60, 20)));
  EXPECT_TRUE(isSound(cut));
  const FoldedState open = after(cut, "unfold all");
  EXPECT_TRUE(isSound(open));
  const std::vector<Vec2> points = {{20, 20},  {70, 60},  {100, 75},
                                    {130, 60}, {160, 40}, {180, -30}};
  const double size = open.tolerance().sheetSize();
  EXPECT_LT(worstMarginError(cut, splinePieces(points, true), fan.folds), 1e-9 * size);
  EXPECT_LT(worstMarginError(open, splinePieces(points, true), fan.folds), 1e-9 * size);
}

TEST(Margin, EqualsTheReflectedCurveOnRandomFans) {
  for (std::uint64_t seed = 1; seed <= 30; ++seed) {
    Random random(seed);
    std::vector<double> axes;
    double at = random.between(40, 70);
    for (int i = 0; i < 4; ++i) {
      axes.push_back(at);
      at += random.between(12, 28);
    }
    const Fan fan(axes);
    std::vector<Vec2> points;
    std::string controls;
    for (int i = 0; i <= 6; ++i) {
      const double angle = -15 + 210.0 * i / 6;
      points.push_back(rayEnd(angle, random.between(45, 80)));
      controls += " " + text(points.back());
    }
    const Result<FoldedState> cut =
        tryRun(fan.model + ";curve @model" + controls + " keep m:" + text(rayEnd(30, 10)));
    ASSERT_TRUE(cut.isOk()) << "seed " << seed << ": " << cut.error().message;
    EXPECT_TRUE(isSound(*cut)) << "seed " << seed;
    const FoldedState open = after(*cut, "unfold all");
    EXPECT_TRUE(isSound(open)) << "seed " << seed;
    EXPECT_LT(worstMarginError(open, splinePieces(points, true), fan.folds),
              1e-9 * open.tolerance().sheetSize())
        << "seed " << seed;
  }
}

/// Distance from the petiole to the margin along a crease of the unfolded, cut sheet.
double reach(const FoldedState& state, double degrees) {
  double farthest = 0;
  for (const Vec2 v : state.pattern.vertices) {
    const Vec2 r = v - kPetiole;
    if (length(r) < 1) continue;
    if (std::abs(cross(normalized(r), rayEnd(degrees, 1) - kPetiole)) < 1e-9 &&
        dot(r, rayEnd(degrees, 1) - kPetiole) > 0) {
      farthest = std::max(farthest, length(r));
    }
  }
  return farthest;
}

TEST(KirigamiLaw, HoldsOnRandomFansCutByAStraightLine) {
  int fans = 0;
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    Random random(seed);
    const double alpha = random.between(10, 40);
    const double beta = random.between(8, 35);
    const double gamma = random.between(8, 35);
    const double first = random.between(30, 60);
    const Fan fan({first, first + alpha, first + alpha + beta, first + alpha + beta + gamma});
    const double p = random.between(25, 100);
    const double ra = random.between(30, 45);
    // Through the tip of axis a, making the angle p with the way back to the petiole. The sector
    // beyond a was turned over, so that it lies at smaller angles there: angles from a are counted
    // with the clock.
    const Vec2 tip = rayEnd(first, ra);
    const Vec2 along = rayEnd(first + 180 + p, 1) - kPetiole;
    const double h = ra * std::sin(p * kDegree);
    double least = 180;
    double most = 0;
    for (const double f : fan.folded) {
      least = std::min(least, p + first - f);
      most = std::max(most, p + first - f);
    }
    if (least < 20 || most > 160 || h / std::sin(std::min(least, 180 - most) * kDegree) > 95)
      continue;
    ++fans;
    const Result<FoldedState> cut =
        tryRun(fan.model + ";cut @model " + text(tip - along * 900) + " " +
               text(tip + along * 900) + " keep m:" + text(rayEnd(first, 1)));
    ASSERT_TRUE(cut.isOk()) << "seed " << seed << ": " << cut.error().message;
    const FoldedState open = after(*cut, "unfold all");
    double r[4];
    for (std::size_t i = 0; i < 4; ++i) r[i] = reach(open, fan.axes[i]);
    const double tolerance = 1e-9 * open.tolerance().sheetSize();
    const auto sine = [](double degrees) { return std::sin(degrees * kDegree); };
    EXPECT_NEAR(r[0], ra, tolerance) << "seed " << seed;
    EXPECT_NEAR(r[0] / r[1], sine(p + alpha) / sine(p), 1e-9) << "seed " << seed;
    EXPECT_NEAR(r[0] / r[2], sine(p + alpha - beta) / sine(p), 1e-9) << "seed " << seed;
    EXPECT_NEAR(r[1] / r[3], sine(p + alpha + gamma - beta) / sine(p + alpha), 1e-9)
        << "seed " << seed;
    EXPECT_NEAR(sine(beta) / r[0] + sine(alpha - beta) / r[1], sine(alpha) / r[2], 1e-9)
        << "seed " << seed;
    for (std::size_t i = 0; i < 4; ++i) {  // 1/R is a sinusoid of the folded angle
      const double angle = first - fan.folded[i];
      const double fitted = std::cos(angle * kDegree) / ra + std::sin(angle * kDegree) *
                                                                 std::cos(p * kDegree) /
                                                                 (ra * std::sin(p * kDegree));
      EXPECT_NEAR(1 / r[i], fitted, 1e-9) << "seed " << seed << " axis " << i;
    }
  }
  EXPECT_GE(fans, 60);
}

}  // namespace
}  // namespace kiri::test
