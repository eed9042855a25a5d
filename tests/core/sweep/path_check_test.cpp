// Motions that turn many hinges at once, against brute force and known answers.
// SPDX-License-Identifier: MIT
#include "core/sweep/path_check.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "core/linkage/rigid_path.h"
#include "tests/support/model_text.h"
#include "tests/support/pattern_text.h"
#include "tests/support/space_piece.h"

namespace kiri::test {
namespace {

constexpr double kPi = std::numbers::pi;

std::vector<double> evenMoments(int count) {
  std::vector<double> moments;
  for (int i = 0; i <= count; ++i) moments.push_back(i / static_cast<double>(count));
  return moments;
}

/// All hinges go straight to `wanted` from where they are.
PosesAt straightTo(const FoldedState& start, const FoldAngles& wanted) {
  return [&start, wanted](double part) {
    CreasePattern pattern = start.pattern;
    for (std::size_t e = 0; e < pattern.edges.size(); ++e)
      pattern.edges[e].angle += part * (wanted[e] - start.pattern.edges[e].angle);
    return derivePoses(pattern, start.rests);
  };
}

FoldAngles fanAngles(const FoldedState& fan, const std::vector<double>& degrees) {
  FoldAngles angles(fan.pattern.edges.size(), 0);
  std::copy(degrees.begin(), degrees.end(), angles.begin() + 1);
  return angles;
}

/// The deepest crossing of facets without a common hinge at so many moments, as part of the sheet,
/// and the first moment with one.
struct Brute {
  double deepest = 0;
  double first = 2;
};
Brute bruteForce(FoldedState state, const PosesAt& posesAt, int moments) {
  Brute brute;
  const CreasePattern pattern = state.pattern;
  for (int i = 1; i < moments; ++i) {
    state.poses = posesAt(i / static_cast<double>(moments));
    std::vector<SpacePiece> pieces;
    for (std::size_t f = 0; f < state.poses.size(); ++f)
      pieces.push_back(spacePieceOf(state, FacetId(f), {}));
    for (std::size_t a = 0; a < pieces.size(); ++a) {
      for (std::size_t b = a + 1; b < pieces.size(); ++b) {
        const bool areJoined =
            std::any_of(pattern.edges.begin(), pattern.edges.end(), [&](const Edge& edge) {
              return edge.kind == EdgeKind::Hinge &&
                     std::minmax(edge.left, edge.right) == std::minmax(FacetId(a), FacetId(b));
            });
        if (areJoined) continue;
        const double depth = depthOf(pieces[a], pieces[b]) / state.tolerance().sheetSize();
        brute.deepest = std::max(brute.deepest, depth);
        if (depth > 1e-6 && brute.first > 1) brute.first = i / static_cast<double>(moments);
      }
    }
  }
  return brute;
}

// Guide to algorithms 1.8.
TEST(CheckPath, TwoValleysCrossWhereTheMiddleSectorIsNotWide) {
  const FoldedState wide = starOf({0.3, 1, 0.3});
  const FoldedState even = starOf({1, 1, 1});
  const double end = 0.62 * 180;
  EXPECT_EQ(checkPath(wide, straightTo(wide, fanAngles(wide, {end, end})), evenMoments(30)).verdict,
            SweepVerdict::Free);
  const PosesAt motion = straightTo(even, fanAngles(even, {end, end}));
  const PathReport report = checkPath(even, motion, evenMoments(30));
  ASSERT_EQ(report.verdict, SweepVerdict::Collides);
  EXPECT_EQ(report.first, FacetId(std::size_t{0}));
  EXPECT_EQ(report.second, FacetId(std::size_t{2}));
  // The outer sides meet when both hinges stand at h, the outer sectors folded over the middle:
  // found here by brute force.
  EXPECT_NEAR(report.part, bruteForce(even, motion, 2000).first, 1.0 / 1000);
  EXPECT_GT(length(report.place), 1);
}

TEST(CheckPath, AnAlternatingFanNeverMeetsItself) {
  const unsigned seed = 31;
  SCOPED_TRACE(seed);
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> sector(0.1, 1.2);
  for (int i = 0; i < 60; ++i) {
    std::vector<double> sectors;
    double sum = 0;
    for (int n = 3 + i % 7; n > 0; --n) sectors.push_back(sector(random));
    for (const double s : sectors) sum += s;
    if (sum > 2 * kPi - 0.1) continue;
    std::vector<double> folded;
    for (std::size_t k = 1; k < sectors.size(); ++k) folded.push_back(k % 2 == 0 ? 180 : -180);
    const FoldedState fan = starOf(sectors);
    const PathReport report =
        checkPath(fan, straightTo(fan, fanAngles(fan, folded)), evenMoments(60));
    EXPECT_EQ(report.verdict, SweepVerdict::Free)
        << "fan " << i << " at " << report.part << " facets " << report.first.index << " "
        << report.second.index;
  }
}

TEST(CheckPath, AgreesWithBruteForceOnFansOfRandomFolds) {
  const unsigned seed = 77;
  SCOPED_TRACE(seed);
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> sector(0.2, 1.1);
  std::uniform_real_distribution<double> angle(-179, 179);
  int collisions = 0;
  int free = 0;
  int undecided = 0;
  for (int i = 0; i < 120; ++i) {
    std::vector<double> sectors;
    double sum = 0;
    for (int n = 3 + i % 4; n > 0; --n) sectors.push_back(sector(random));
    for (const double s : sectors) sum += s;
    if (sum > 2 * kPi - 0.1) continue;
    std::vector<double> folded;
    for (std::size_t k = 1; k < sectors.size(); ++k) folded.push_back(angle(random));
    const FoldedState fan = starOf(sectors);
    const PosesAt motion = straightTo(fan, fanAngles(fan, folded));
    const PathReport report = checkPath(fan, motion, evenMoments(50));
    const Brute brute = bruteForce(fan, motion, 400);
    SCOPED_TRACE(testing::Message() << "fan " << i << " brute depth " << brute.deepest << " at "
                                    << brute.first << ", reported at " << report.part);
    switch (report.verdict) {
      case SweepVerdict::Free:
        EXPECT_LT(brute.deepest, 1e-6);
        ++free;
        break;
      case SweepVerdict::Collides:
        EXPECT_LE(report.part, brute.first + 1e-9);
        EXPECT_GE(report.part, std::min(brute.first, 1.0) - 1.0 / 400);
        ++collisions;
        break;
      case SweepVerdict::Undecided:
        ++undecided;
        break;
    }
  }
  EXPECT_GT(free, 15);
  EXPECT_GT(collisions, 15);
  EXPECT_LE(undecided, 1);
}

/// A strip of three thirds, the right one folded onto the middle, the left one onto both.
FoldedState letter() {
  return run("rectangle 90 30; fold R valley 60,0 60,30 right; fold L valley 30,0 30,30 left");
}

FoldAngles anglesWith(const FoldedState& state, const std::string& line, double amount) {
  FoldAngles angles = kiri::anglesOf(state.pattern);
  for (std::size_t e = 0; e < angles.size(); ++e) {
    const Edge& edge = state.pattern.edges[e];
    if (edge.kind == EdgeKind::Hinge && state.lines[edge.line.index].name == line)
      angles[e] = edge.sign * amount;
  }
  return angles;
}

TEST(CheckPath, LayersLeaveOnlyToTheSideOnWhichTheyLie) {
  const FoldedState start = letter();
  const PosesAt upperFirst = straightTo(start, anglesWith(start, "L", 0));
  EXPECT_EQ(checkPath(start, upperFirst, evenMoments(45)).verdict, SweepVerdict::Free);
  const PosesAt lowerFirst = straightTo(start, anglesWith(start, "R", 0));
  const PathReport report = checkPath(start, lowerFirst, evenMoments(45));
  EXPECT_EQ(report.verdict, SweepVerdict::Collides);
  EXPECT_LT(report.part, 1e-3);
  FoldAngles both = anglesWith(start, "R", 0);
  const FoldAngles left = anglesWith(start, "L", 0);
  for (std::size_t e = 0; e < both.size(); ++e) both[e] = std::min(both[e], left[e]);
  EXPECT_EQ(checkPath(start, straightTo(start, both), evenMoments(45)).verdict,
            SweepVerdict::Collides)
      << "the lower third turns as fast as the upper one and is wider than nothing";
}

TEST(CheckPath, ALayerThatSlipsThroughAnotherInTheFlatStateIsNotFree) {
  // Both outer thirds turn through the middle one's plane, one after the other side has passed.
  const FoldedState start =
      run("rectangle 90 30; fold R valley 90 60,0 60,30 right;"
          "fold L valley 60 30,0 30,30 left");
  FoldAngles through = kiri::anglesOf(start.pattern);
  for (double& a : through) a = a > 0 ? a + 110 : a;  // 90 to 200, 60 to 170
  const PathReport report = checkPath(start, straightTo(start, through), evenMoments(60));
  EXPECT_NE(report.verdict, SweepVerdict::Free);
}

TEST(CheckPath, AStripPassesThroughANotchOfWhatStandsInItsWay) {
  // The strip's hull meets the post's; the paper does not.
  const std::string folds =
      "; fold Post valley 90 80,0 80,20 right; fold Flap valley 1 50,0 50,20 left";
  const auto verdictOf = [&](const std::string& notch) {
    const FoldedState start =
        run("polygon 0,9 25,9 25,0 130,0 " + notch + "130,20 25,20 25,11 0,11" + folds);
    const PosesAt motion = straightTo(start, anglesWith(start, "Flap", 140));
    return checkPath(start, motion, evenMoments(45)).verdict;
  };
  EXPECT_EQ(verdictOf("130,8 95,8 95,12 130,12 "), SweepVerdict::Free);
  EXPECT_EQ(verdictOf("130,8 110,8 110,12 130,12 "), SweepVerdict::Collides) << "not so deep";
  EXPECT_EQ(verdictOf(""), SweepVerdict::Collides);
}

TEST(CheckPath, StopsWhenItIsTold) {
  const FoldedState start = letter();
  int calls = 0;
  const PathReport report = checkPath(start, straightTo(start, anglesWith(start, "L", 0)),
                                      evenMoments(45), [&](double) { return ++calls < 5; });
  EXPECT_EQ(report.verdict, SweepVerdict::Undecided);
  EXPECT_EQ(calls, 5);
}

TEST(CheckPath, ACorrugatedSheetFoldsFree) {
  const Corrugation sheet = corrugationOf(6, 4, 55);
  PathRequest request;
  request.wanted = sheet.folded;
  request.driven = {EdgeId(sheet.zigzag[0])};
  for (const std::size_t e : sheet.straight) request.free.push_back(EdgeId(e));
  for (std::size_t i = 1; i < sheet.zigzag.size(); ++i)
    request.free.push_back(EdgeId(sheet.zigzag[i]));
  const RigidPath path = rigidPath(sheet.state, request);
  ASSERT_TRUE(path.arrives());
  std::vector<double> moments;
  for (const RigidPath::Sample& sample : path.samples()) moments.push_back(sample.part);
  const PosesAt posesAt = [&](double part) {
    CreasePattern pattern = sheet.state.pattern;
    const FoldAngles angles = path.at(part);
    for (std::size_t e = 0; e < angles.size(); ++e) pattern.edges[e].angle = angles[e];
    return derivePoses(pattern, sheet.state.rests);
  };
  const PathReport report = checkPath(sheet.state, posesAt, moments);
  EXPECT_EQ(report.verdict, SweepVerdict::Free)
      << report.part << " facets " << report.first.index << " " << report.second.index;
}

}  // namespace
}  // namespace kiri::test
