// Drawings that fold flat but for noise come back exact; those that do not are refused.
// SPDX-License-Identifier: MIT
#include "core/flatfold/polish.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <sstream>

#include "core/creases/repair.h"
#include "core/paper/folded_state.h"
#include "io/patterns/pattern_file.h"
#include "tests/core/flatfold/flat_patterns.h"
#include "tests/support/model_text.h"
#include "tests/support/random_steps.h"
#include "tests/support/state_check.h"

namespace kiri::test {
namespace {

/// How far the facets of a pattern disagree about their hinges when it is folded flat.
double foldedGap(const CreasePattern& pattern) {
  FoldedState state(pattern);
  const std::vector<std::uint32_t> piece = piecesOf(pattern);
  for (std::size_t f = 0; f < piece.size(); ++f) {
    if (piece[f] == state.rests.size()) state.rests.push_back({FacetId(f), Rigid{}});
  }
  state.poses = derivePoses(state.pattern, state.rests);
  return hingeGap(state);
}

AssignedPattern creasesOf(const FoldedState& state) {
  AssignedPattern creases(state.pattern);
  for (const Edge& edge : state.pattern.edges) {
    creases.assignments.push_back(edge.kind == EdgeKind::Border ? Assignment::Border
                                  : edge.kind == EdgeKind::Cut  ? Assignment::Cut
                                  : edge.angle > 0              ? Assignment::Valley
                                  : edge.angle < 0              ? Assignment::Mountain
                                                                : Assignment::Flat);
  }
  return creases;
}

/// A square of side 100 folded a few times along lines at random, and unfolded again.
AssignedPattern randomFolds(std::uint64_t seed, int folds, const std::string& sheet) {
  Random random(seed);
  FoldedState state = run(sheet);
  int made = 0;
  for (int tries = 0; tries < 40 && made < folds; ++tries) {
    std::ostringstream step;
    step.precision(17);
    const auto place = [&] {
      step << " m:" << random.between(5, 95) << ',' << random.between(5, 95);
    };
    step << "fold " << (random.chance(0.5) ? "valley" : "mountain");
    place();
    place();
    step << (random.chance(0.5) ? " left" : " right");
    Result<FoldedState> next = tryAfter(state, step.str());
    if (!next) continue;
    state = std::move(*next);
    ++made;
  }
  return creasesOf(state);
}

double shortestEdge(const CreasePattern& pattern) {
  double shortest = 1e9;
  for (const Edge& edge : pattern.edges)
    shortest = std::min(shortest, distance(pattern[edge.from], pattern[edge.to]));
  return shortest;
}

/// Moves vertices inside at random, those on the rim along their side; corners stay.
void shake(AssignedPattern& creases, double noise, std::uint64_t seed) {
  Random random(seed);
  CreasePattern& pattern = creases.pattern;
  std::vector<std::vector<Vec2>> sides(pattern.vertices.size());
  for (const Edge& edge : pattern.edges) {
    if (edge.kind == EdgeKind::Hinge) continue;
    const Vec2 way = normalized(pattern[edge.to] - pattern[edge.from]);
    sides[edge.from.index].push_back(way);
    sides[edge.to.index].push_back(way);
  }
  for (std::size_t v = 0; v < sides.size(); ++v) {
    const Vec2 move{random.between(-noise, noise), random.between(-noise, noise)};
    if (sides[v].empty()) pattern.vertices[v] = pattern.vertices[v] + move;
    if (sides[v].size() == 2 && std::abs(cross(sides[v][0], sides[v][1])) < 1e-9)
      pattern.vertices[v] = pattern.vertices[v] + sides[v][0] * move.x;
  }
}

TEST(Polished, ExactPatternsComeBackBitByBit) {
  std::vector<AssignedPattern> patterns{squareTwist(), mapPattern(5, 4)};
  for (std::uint64_t seed = 1; seed <= 10; ++seed)
    patterns.push_back(randomFolds(seed, 4, "square 100"));
  for (const AssignedPattern& exact : patterns) {
    const Result<Polished> polish = polished(exact);
    ASSERT_TRUE(polish.isOk()) << polish.error().message;
    EXPECT_EQ(polish->farthest, 0);
    EXPECT_EQ(polish->creases.pattern.vertices, exact.pattern.vertices);
  }
}

TEST(Polished, RandomFoldsWithNoiseFoldExactlyAgainAfterMovesOfTheSizeOfTheNoise) {
  int tried = 0;
  for (const std::string sheet :
       {"square 100", "polygon 0,0 100,0 100,100 0,100 hole 40,35 62,40 47,58"}) {
    for (std::uint64_t seed = 1; seed <= 60; ++seed) {
      AssignedPattern creases = randomFolds(seed, 4, sheet);
      const double noise = 1e-4 * creases.pattern.tolerance.sheetSize();
      if (creases.pattern.facets.size() < 6 || shortestEdge(creases.pattern) < 20 * noise) continue;
      shake(creases, noise, seed);
      if (foldedGap(creases.pattern) <= creases.pattern.tolerance.length()) continue;
      const Result<Polished> polish = polished(creases);
      ASSERT_TRUE(polish.isOk()) << sheet << " seed " << seed << ": " << polish.error().message;
      EXPECT_LE(foldedGap(polish->creases.pattern), creases.pattern.tolerance.length());
      EXPECT_LE(polish->farthest, 10 * noise) << sheet << " seed " << seed;
      EXPECT_GT(polish->farthest, 0);
      EXPECT_EQ(joined(patternViolations(polish->creases.pattern)), "") << sheet << " " << seed;
      ++tried;
    }
  }
  EXPECT_GT(tried, 40);
}

TEST(Polished, VerticesOfTheRimStayOnTheirSidesAndCornersStay) {
  AssignedPattern creases = randomFolds(3, 3, "square 100");
  shake(creases, 0.01, 3);
  const Result<Polished> polish = polished(creases);
  ASSERT_TRUE(polish.isOk()) << polish.error().message;
  int corners = 0;
  for (std::size_t v = 0; v < creases.pattern.vertices.size(); ++v) {
    const Vec2 before = creases.pattern.vertices[v];
    const Vec2 after = polish->creases.pattern.vertices[v];
    const bool isOnX = std::abs(before.x) < 1e-9 || std::abs(before.x - 100) < 1e-9;
    const bool isOnY = std::abs(before.y) < 1e-9 || std::abs(before.y - 100) < 1e-9;
    EXPECT_TRUE(!isOnX || std::abs(before.x - after.x) < 1e-9);
    EXPECT_TRUE(!isOnY || std::abs(before.y - after.y) < 1e-9);
    corners += isOnX && isOnY && before == after ? 1 : 0;
  }
  EXPECT_EQ(corners, 4);
}

TEST(Polished, CreasesThatRanStraightThroughAVertexGoOnDoingSo) {
  // A pleat across a map, and one star whose centre was drawn wrongly: the map stays straight.
  AssignedPattern creases = mapPattern(4, 4);
  creases.pattern.vertices[12] = creases.pattern.vertices[12] + Vec2{0.003, 0.001};
  const Result<Polished> polish = polished(creases);
  ASSERT_TRUE(polish.isOk()) << polish.error().message;
  const CreasePattern& after = polish->creases.pattern;
  for (const int column : {1, 3}) {
    for (int row = 1; row < 4; ++row) {
      const Vec2 low = after.vertices[static_cast<std::size_t>((row - 1) * 5 + column)];
      const Vec2 middle = after.vertices[static_cast<std::size_t>(row * 5 + column)];
      const Vec2 high = after.vertices[static_cast<std::size_t>((row + 1) * 5 + column)];
      EXPECT_NEAR(cross(high - low, middle - low), 0, 1e-9) << column << " " << row;
    }
  }
}

TEST(Polished, WhatDoesNotFoldFlatIsRefusedWithThePlaceThatMissesMost) {
  AssignedPattern creases = squareTwist();
  creases.pattern.vertices[0] = creases.pattern.vertices[0] + Vec2{0.3, 0.2};
  const Result<Polished> polish = polished(creases);
  ASSERT_FALSE(polish.isOk());
  EXPECT_EQ(polish.error().code, ErrorCode::WouldStretch);
  EXPECT_NE(polish.error().message.find("degrees"), std::string::npos) << polish.error().message;
  ASSERT_EQ(polish.error().witness.points.size(), 1U);
}

TEST(Polished, AnOddNumberOfFoldedCreasesIsRefused) {
  AssignedPattern creases = mapPattern(2, 2);
  for (std::size_t e = 0; e < creases.pattern.edges.size(); ++e) {
    if (creases.pattern.edges[e].kind != EdgeKind::Hinge) continue;
    creases.pattern.edges[e].angle = 0;
    break;
  }
  const Result<Polished> polish = polished(creases);
  ASSERT_FALSE(polish.isOk());
  EXPECT_EQ(polish.error().code, ErrorCode::WouldStretch);
  EXPECT_NE(polish.error().message.find("(1, 1)"), std::string::npos) << polish.error().message;
}

TEST(Polished, CanBeStopped) {
  AssignedPattern creases = squareTwist();
  creases.pattern.vertices[0] = creases.pattern.vertices[0] + Vec2{1e-4, 2e-4};
  const Result<Polished> polish = polished(creases, [](double) { return false; });
  ASSERT_FALSE(polish.isOk());
  EXPECT_EQ(polish.error().code, ErrorCode::Cancelled);
}

TEST(KnownFlatPatterns, AllThatAreUsableCanBePolished) {
  const std::string folder = std::string(KIRI_SOURCE_DIR) + "/../shared/data/patterns/";
  std::ifstream list(folder + "conformance.csv");
  if (!list) GTEST_SKIP() << "the shared patterns are not here";
  int flat = 0;
  for (std::string line; std::getline(list, line);) {
    if (line.find(",yes") == std::string::npos) continue;
    const std::string file = line.substr(0, line.find(','));
    std::ifstream in(folder + file);
    std::stringstream text;
    text << in.rdbuf();
    const Result<PatternFile> read = readPattern(text.str(), file);
    if (!read) continue;  // the readers' own tests say which
    const Result<RepairedPattern> repaired = patternOf(read->drawing);
    ASSERT_TRUE(repaired.isOk()) << file << ": " << repaired.error().message;
    if (!isMeantFlat(repaired->creases)) continue;
    const Result<Polished> polish = polished(repaired->creases);
    ASSERT_TRUE(polish.isOk()) << file << ": " << polish.error().message;
    const Tolerance tolerance = repaired->creases.pattern.tolerance;
    EXPECT_LE(foldedGap(polish->creases.pattern), tolerance.length()) << file;
    EXPECT_LE(polish->farthest, 4e-4 * tolerance.sheetSize()) << file;
    ++flat;
  }
  EXPECT_GT(flat, 370);
}

}  // namespace
}  // namespace kiri::test
