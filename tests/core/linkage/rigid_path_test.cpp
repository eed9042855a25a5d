// Rigid motions of known mechanisms against their closed forms.
// SPDX-License-Identifier: MIT
#include "core/linkage/rigid_path.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "tests/support/pattern_text.h"
#include "tests/support/state_check.h"

namespace kiri::test {
namespace {

constexpr double kPi = std::numbers::pi;

double radians(double degrees) { return degrees * kPi / 180; }
double degrees(double radians) { return radians * 180 / kPi; }
double tanHalf(double angle) { return std::tan(radians(angle) / 2); }

/// All hinges head for `wanted`, of which the one at `driven` is driven.
PathRequest requestOf(const FoldedState& state, FoldAngles wanted, std::size_t driven) {
  PathRequest request;
  request.wanted = std::move(wanted);
  for (std::size_t e = 0; e < state.pattern.edges.size(); ++e) {
    if (state.pattern.edges[e].kind != EdgeKind::Hinge) continue;
    (e == driven ? request.driven : request.free).push_back(EdgeId(e));
  }
  return request;
}

FoldedState withAngles(FoldedState state, const FoldAngles& angles) {
  for (std::size_t e = 0; e < angles.size(); ++e) {
    if (state.pattern.edges[e].kind == EdgeKind::Hinge) state.pattern.edges[e].angle = angles[e];
  }
  state.poses = derivePoses(state.pattern, state.rests);
  return state;
}

/// The largest gap at a hinge, as part of the sheet, found by the poses' own checker.
double gapOf(const FoldedState& state, const FoldAngles& angles) {
  return hingeGap(withAngles(state, angles)) / state.tolerance().sheetSize();
}

/// Holds the paper together at many moments, and turns no hinge by a jump.
void expectSound(const FoldedState& state, const RigidPath& path, int moments = 50) {
  FoldAngles last = path.at(0);
  EXPECT_EQ(last, anglesOf(state.pattern));
  double fastest = 0;
  for (int i = 1; i <= moments; ++i) {
    const FoldAngles now = path.at(path.reach() * i / moments);
    EXPECT_LT(gapOf(state, now), 1e-9) << "at moment " << i;
    for (std::size_t e = 0; e < now.size(); ++e) {
      EXPECT_LE(std::abs(now[e]), 180);
      fastest = std::max(fastest, std::abs(now[e] - last[e]));
    }
    last = now;
  }
  // No jump: a thousandth of the way on, everything has moved a little.
  for (int i = 0; i < moments; ++i) {
    const FoldAngles a = path.at(path.reach() * (i + 0.499) / moments);
    const FoldAngles b = path.at(path.reach() * (i + 0.501) / moments);
    for (std::size_t e = 0; e < a.size(); ++e)
      EXPECT_LE(std::abs(a[e] - b[e]), fastest / 20 + 1e-9) << "at moment " << i;
  }
}

/// Factors of guide to algorithms 7.1, for a flat-foldable vertex with sectors a1, a2 after creases
/// 1, 2: tan(rho2 / 2) = factor * tan(rho1 / 2).
double factorOf(double a1, double a2, bool isModeB) {
  return isModeB ? std::sin((a1 + a2) / 2) / std::sin((a1 - a2) / 2)
                 : -std::cos((a1 + a2) / 2) / std::cos((a1 - a2) / 2);
}

FoldedState flatFoldable(double a1, double a2) { return starOf({a1, a2, kPi - a1, kPi - a2}); }

/// Fully folded angles of the mode in which crease 1 (position 0) is at `first`.
FoldAngles foldedVertex(double a1, double a2, bool isModeB, double first) {
  const double second = factorOf(a1, a2, isModeB) > 0 ? first : -first;
  FoldAngles angles(8, 0);
  angles[0] = first;
  angles[1] = second;
  angles[2] = isModeB ? -first : first;
  angles[3] = isModeB ? second : -second;
  return angles;
}

TEST(RigidPath, AFlatFoldableVertexHasTheFactorsOfTheGuide) {
  struct Golden {
    double a1;
    double a2;
    bool isModeB;
    double factor;
  };
  for (const Golden& g : {Golden{1.0, 1.3, false, -0.41313}, Golden{1.0, 1.3, true, -6.10797},
                          Golden{0.9, 0.9, false, -0.62161}, Golden{1.2, 2.0, false, 0.03170},
                          Golden{1.2, 2.0, true, -2.56684}}) {
    ASSERT_NEAR(factorOf(g.a1, g.a2, g.isModeB), g.factor, 5e-6);
    const FoldedState state = flatFoldable(g.a1, g.a2);
    const FoldAngles folded = foldedVertex(g.a1, g.a2, g.isModeB, 180);
    const RigidPath path = rigidPath(state, requestOf(state, folded, 0));
    ASSERT_TRUE(path.isComplete());
    EXPECT_EQ(path.at(1), folded);
    for (const double rho : {0.5, 1.5, 2.5}) {
      const FoldAngles angles = path.at(degrees(rho) / 180);
      EXPECT_NEAR(radians(angles[0]), rho, 1e-15);
      EXPECT_NEAR(tanHalf(angles[1]) / tanHalf(angles[0]), factorOf(g.a1, g.a2, g.isModeB), 1e-9);
      EXPECT_NEAR(angles[2], g.isModeB ? -angles[0] : angles[0], 1e-9);
      EXPECT_NEAR(angles[3], g.isModeB ? angles[1] : -angles[1], 1e-9);
    }
  }
}

TEST(RigidPath, RandomFlatFoldableVerticesFoldInBothModesWhicheverHingeIsDriven) {
  const unsigned seed = 20261122;
  SCOPED_TRACE(seed);
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> sector(0.3, kPi - 0.3);
  int paths = 0;
  for (int i = 0; i < 25; ++i) {
    const double a1 = sector(random);
    const double a2 = sector(random);
    for (const bool isModeB : {false, true}) {
      const double factor = factorOf(a1, a2, isModeB);
      if (std::abs(factor) < 0.02 || std::abs(factor) > 50) continue;
      for (std::size_t driven = 0; driven < 4; ++driven) {
        SCOPED_TRACE(testing::Message() << a1 << " " << a2 << " " << isModeB << " " << driven);
        const FoldedState state = flatFoldable(a1, a2);
        const FoldAngles folded = foldedVertex(a1, a2, isModeB, i % 2 == 0 ? 180 : -180);
        const RigidPath path = rigidPath(state, requestOf(state, folded, driven));
        ASSERT_TRUE(path.isComplete());
        EXPECT_EQ(path.at(1), folded);
        expectSound(state, path);
        for (const double part : {0.1, 0.5, 0.9}) {
          const FoldAngles angles = path.at(part);
          EXPECT_NEAR(tanHalf(angles[1]) / (factor * tanHalf(angles[0])), 1, 1e-8);
        }
        ++paths;
      }
    }
  }
  EXPECT_GT(paths, 150);
}

TEST(RigidPath, ACorrugatedSheetKeepsTheLawOfTheHornbeam) {
  for (const double a : {30., 40., 50., 75.}) {
    const Corrugation sheet = corrugationOf(5, 4, a);
    const RigidPath path =
        rigidPath(sheet.state, requestOf(sheet.state, sheet.folded, sheet.zigzag[1]));
    ASSERT_TRUE(path.isComplete());
    EXPECT_EQ(path.at(1), sheet.folded);
    for (int s = 1; s < 180; ++s) {
      const FoldAngles angles = path.at(s / 180.0);
      const double m = degrees(2 * std::atan(std::cos(radians(a)) * tanHalf(s)));
      for (const std::size_t e : sheet.zigzag) EXPECT_NEAR(std::abs(angles[e]), s, 1e-9);
      for (const std::size_t e : sheet.straight) EXPECT_NEAR(std::abs(angles[e]), m, 1e-9);
      EXPECT_LT(gapOf(sheet.state, angles), 1e-12);
    }
  }
}

TEST(RigidPath, TheMidVeinOfACorrugatedSheetShortensByItsLaw) {
  const double a = 50;
  const Corrugation sheet = corrugationOf(6, 2, a);
  FoldAngles flat(sheet.folded.size(), 0);
  const FoldedState folded = withAngles(sheet.state, sheet.folded);
  const RigidPath path = rigidPath(folded, requestOf(folded, flat, sheet.straight[2]));
  ASSERT_TRUE(path.isComplete());
  EXPECT_EQ(path.at(1), flat);
  for (int i = 0; i <= 40; ++i) {
    const FoldedState state = withAngles(sheet.state, path.at(i / 40.0));
    const double s = std::abs(state.pattern.edges[sheet.zigzag[0]].angle);
    // Ends of the crease between the two rows, two facets apart.
    const Edge& first = state.pattern.edges[sheet.straight[0]];
    const Edge& third = state.pattern.edges[sheet.straight[2]];
    const double length = distance(state.poseOf(first.left).apply(state.pattern[first.from]),
                                   state.poseOf(third.left).apply(state.pattern[third.from]));
    const double sine = std::sin(radians(a)) * std::sin(radians(s) / 2);
    EXPECT_NEAR(length / 20, std::sqrt(1 - sine * sine), 1e-9);
  }
}

TEST(RigidPath, AnOpenFanUnfoldsStraight) {
  const FoldedState fan = starOf({0.7, 0.6, 0.8, 0.5, 0.9});
  FoldAngles folded(fan.pattern.edges.size(), 0);
  for (std::size_t e = 1; e < 5; ++e) folded[e] = e % 2 == 0 ? 180 : -180;
  PathRequest request = requestOf(fan, folded, 1);
  request.driven.insert(request.driven.end(), request.free.begin(), request.free.end());
  request.free.clear();
  const RigidPath path = rigidPath(fan, request);
  EXPECT_TRUE(path.isComplete());
  EXPECT_TRUE(path.isStraight());
  for (const double part : {0.25, 0.5, 1.0}) {
    for (std::size_t e = 0; e < folded.size(); ++e) EXPECT_EQ(path.at(part)[e], part * folded[e]);
  }
}

TEST(RigidPath, ACrossGoesStraightAlongOneLineAndNotAlongBoth) {
  const FoldedState cross = starOf({kPi / 2, kPi / 2, kPi / 2, kPi / 2});
  PathRequest request;
  request.wanted = {180, 0, 180, 0, 0, 0, 0, 0};
  request.driven = {EdgeId(std::size_t{0}), EdgeId(std::size_t{2})};
  EXPECT_TRUE(rigidPath(cross, request).isStraight());
  const FoldedState half = withAngles(cross, request.wanted);
  request.wanted = {180, 120, 180, -120, 0, 0, 0, 0};
  request.driven = {EdgeId(std::size_t{1}), EdgeId(std::size_t{3})};
  EXPECT_TRUE(rigidPath(half, request).isStraight());
  // Both lines at once: no way at all.
  request.driven = {EdgeId(std::size_t{0}), EdgeId(std::size_t{1}), EdgeId(std::size_t{2}),
                    EdgeId(std::size_t{3})};
  const RigidPath both = rigidPath(cross, request);
  EXPECT_EQ(both.reach(), 0);
  EXPECT_EQ(both.stop().end, PathEnd::Locked);
  EXPECT_EQ(both.stop().hinges, request.driven);
  EXPECT_EQ(both.at(0), anglesOf(cross.pattern));
  // Line 2 half way, line 1 is held fast.
  const FoldedState held = withAngles(cross, {180, 60, 180, -60, 0, 0, 0, 0});
  request.wanted = {0, 60, 0, -60, 0, 0, 0, 0};
  request.driven = {EdgeId(std::size_t{0}), EdgeId(std::size_t{2})};
  EXPECT_EQ(rigidPath(held, request).reach(), 0);
}

TEST(RigidPath, ThreeCreasesAtAVertexAreHeldFast) {
  const FoldedState state = starOf({2, 2, 2 * kPi - 4});
  const RigidPath path = rigidPath(state, requestOf(state, {90, 90, 90, 0, 0, 0}, 0));
  EXPECT_EQ(path.reach(), 0);
  EXPECT_EQ(path.stop().end, PathEnd::Locked);
  EXPECT_EQ(path.stop().hinges.size(), 3u);
}

/// Angle opposite to side `a` in the spherical triangle with sides a, b, c, degrees.
double spherical(double a, double b, double c) {
  return degrees(
      std::acos((std::cos(a) - std::cos(b) * std::cos(c)) / (std::sin(b) * std::sin(c))));
}

/// The angle of crease 0 of a vertex with four creases at which crease `full` is at 180 degrees.
/// The sectors are arcs on the sphere; two of them lie on each other then, and the rest is a
/// triangle.
double stopOfCreaseZero(const std::vector<double>& sectors, std::size_t full) {
  const double d = std::abs(sectors[full - 1] - sectors[full]);
  if (full == 2) return 180 - spherical(d, sectors[0], sectors[3]);
  const double near = sectors[full == 1 ? 0 : 3];
  const double beyond = sectors[full == 1 ? 1 : 2];
  const double other = sectors[full == 1 ? 3 : 0];
  const double opposite = sectors[full == 1 ? 2 : 1];
  const double angle = spherical(opposite, d, other);
  return near > beyond ? 180 - angle : angle;
}

TEST(RigidPath, AVertexThatDoesNotFoldFlatStopsWhereAHingeIsFull) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> sector(0.6, 2.2);
  int stopped[4] = {};
  int assignments = 0;
  int vertices = 0;
  for (int i = 0; i < 40; ++i) {
    std::vector<double> sectors{sector(random), sector(random), sector(random)};
    sectors.push_back(2 * kPi - sectors[0] - sectors[1] - sectors[2]);
    if (sectors[3] < 0.6 || sectors[3] > 2.2) continue;
    ++vertices;
    const FoldedState state = starOf(sectors);
    for (int signs = 0; signs < 8; ++signs) {
      FoldAngles wanted(8, 0);
      wanted[0] = 180;
      for (unsigned e = 1; e < 4; ++e) wanted[e] = (signs >> (e - 1) & 1) == 1 ? 180 : -180;
      const RigidPath path = rigidPath(state, requestOf(state, wanted, 0));
      if (path.reach() == 0) continue;  // not one of the vertex's own assignments
      SCOPED_TRACE(testing::Message() << "vertex " << i << " signs " << signs);
      ++assignments;
      expectSound(state, path, 20);
      if (path.isComplete()) continue;
      EXPECT_EQ(path.stop().end, PathEnd::HingeFull);
      ASSERT_EQ(path.stop().hinges.size(), 1u);
      const std::size_t full = path.stop().hinges[0].index;
      EXPECT_NEAR(path.reach() * 180, stopOfCreaseZero(sectors, full), 1e-5);
      ++stopped[full];
    }
  }
  EXPECT_EQ(assignments, 2 * vertices);
  for (const std::size_t full : {1U, 2U, 3U}) EXPECT_GT(stopped[full], 2);
}

TEST(RigidPath, AWaterbombVertexStaysSymmetricAndFoldsFlat) {
  const FoldedState state = starOf(std::vector<double>(6, kPi / 3));
  FoldAngles folded(12, 0);
  const double signs[] = {-1, 1, 1, -1, 1, 1};
  for (std::size_t e = 0; e < 6; ++e) folded[e] = 180 * signs[e];
  const RigidPath path = rigidPath(state, requestOf(state, folded, 0));
  ASSERT_TRUE(path.isComplete());
  EXPECT_EQ(path.at(1), folded);
  expectSound(state, path);
  for (int i = 1; i < 50; ++i) {
    const FoldAngles angles = path.at(i / 50.0);
    EXPECT_NEAR(angles[1], angles[5], 1e-6);
    EXPECT_NEAR(angles[2], angles[4], 1e-6);
  }
}

TEST(RigidPath, HingesThatAreNotNamedKeepTheirAngles) {
  // A fan with a folded crease that nothing asks for.
  FoldedState fan = starOf({0.7, 0.6, 0.8});
  fan.pattern.edges[1].angle = 35;
  PathRequest request;
  request.wanted.assign(fan.pattern.edges.size(), 90);
  request.driven = {EdgeId(std::size_t{2})};
  const RigidPath path = rigidPath(fan, request);
  EXPECT_EQ(path.at(1)[1], 35);
  EXPECT_EQ(path.at(1)[2], 90);
}

TEST(RigidPath, APartlyFoldedSheetGoesOnThroughTheFlatStateToItsOtherSide) {
  const Corrugation sheet = corrugationOf(4, 3, 60);
  const PathRequest out = requestOf(sheet.state, sheet.folded, sheet.zigzag[0]);
  const FoldAngles half = rigidPath(sheet.state, out).at(0.5);
  const FoldedState start = withAngles(sheet.state, half);
  FoldAngles other = half;
  for (double& a : other) a = -a;
  const RigidPath path = rigidPath(start, requestOf(start, other, sheet.zigzag[0]));
  ASSERT_TRUE(path.isComplete());
  expectSound(start, path);
  EXPECT_EQ(path.at(1), other);
}

TEST(RigidPath, EndsFlatExactlyWhateverTheFreeHingesWereMeantToDo) {
  const Corrugation sheet = corrugationOf(4, 3, 60);
  const PathRequest out = requestOf(sheet.state, sheet.folded, sheet.zigzag[0]);
  const FoldedState half = withAngles(sheet.state, rigidPath(sheet.state, out).at(0.4));
  PathRequest request = out;
  for (double& a : request.wanted) a *= 0.7;  // free hinges head for what they cannot have
  request.wanted[sheet.zigzag[0]] = sheet.folded[sheet.zigzag[0]];
  const RigidPath path = rigidPath(half, request);
  EXPECT_TRUE(path.isComplete());
  EXPECT_FALSE(path.arrives());
  EXPECT_EQ(path.at(1), sheet.folded);
}

TEST(RigidPath, EndsWhereItIsCancelled) {
  const Corrugation sheet = corrugationOf(4, 3, 60);
  int calls = 0;
  double last = 0;
  const RigidPath path = rigidPath(
      sheet.state, requestOf(sheet.state, sheet.folded, sheet.zigzag[0]), [&](double done) {
        EXPECT_GE(done, last);
        last = done;
        return ++calls < 10;
      });
  EXPECT_EQ(path.stop().end, PathEnd::Cancelled);
  EXPECT_GT(path.reach(), 0.01);
  EXPECT_LT(path.reach(), 1);
  expectSound(sheet.state, path);
}

TEST(RigidPath, IsTheSameEveryTime) {
  const Corrugation sheet = corrugationOf(6, 5, 70);
  const PathRequest request = requestOf(sheet.state, sheet.folded, sheet.zigzag[2]);
  const RigidPath a = rigidPath(sheet.state, request);
  const RigidPath b = rigidPath(sheet.state, request);
  for (const double part : {0.1, 0.333, 0.77}) EXPECT_EQ(a.at(part), b.at(part));
}

}  // namespace
}  // namespace kiri::test
