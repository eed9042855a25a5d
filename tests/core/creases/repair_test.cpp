// What patternOf makes of drawings, one kind of mistake at a time.
// SPDX-License-Identifier: MIT
#include "core/creases/repair.h"

#include <gtest/gtest.h>

#include <limits>

#include "tests/core/creases/drawings.h"
#include "tests/support/state_check.h"

namespace kiri::test {
namespace {

const std::string kSquare = "B 0,0 100,0 100,100 0,100 0,0;";

RepairedPattern repaired(const std::string& text, const RepairOptions& options = {}) {
  Result<RepairedPattern> result = patternOf(drawn(text), options);
  if (!result) throw std::runtime_error(result.error().message);
  EXPECT_EQ(joined(patternViolations(result->creases.pattern)), "") << text;
  EXPECT_EQ(joined(mapViolations(result->creases)), "") << text;
  return std::move(*result);
}

const Repair* repairOf(const RepairedPattern& pattern, RepairKind kind) {
  for (const Repair& repair : pattern.repairs) {
    if (repair.kind == kind) return &repair;
  }
  return nullptr;
}

std::size_t countOf(const RepairedPattern& pattern, RepairKind kind) {
  const Repair* repair = repairOf(pattern, kind);
  return repair == nullptr ? 0 : repair->count;
}

/// Vertices, edges, facets.
std::string sizes(const RepairedPattern& pattern) {
  const CreasePattern& p = pattern.creases.pattern;
  return std::to_string(p.vertices.size()) + " " + std::to_string(p.edges.size()) + " " +
         std::to_string(p.facets.size());
}

std::size_t edgesAs(const RepairedPattern& pattern, Assignment assignment) {
  std::size_t count = 0;
  for (const Assignment a : pattern.creases.assignments) count += a == assignment ? 1 : 0;
  return count;
}

TEST(PatternOf, ACleanDrawingComesOutAsItIs) {
  const RepairedPattern p = repaired(kSquare + "V 0,0 50,50 100,100; M 0,100 50,50 100,0");
  EXPECT_TRUE(p.repairs.empty());
  EXPECT_EQ(sizes(p), "5 8 4");
  EXPECT_EQ(p.creases.pattern.vertices[4], (Vec2{50, 50}));
  EXPECT_EQ(p.creases.of(EdgeId(4)), Assignment::Valley);
  EXPECT_EQ(p.creases.pattern.edges[4].angle, 180);
  EXPECT_EQ(p.creases.pattern.edges[6].angle, -180);
}

TEST(PatternOf, AnglesAreThoseOfTheDrawingInTheDirectionOfTheAssignment) {
  const RepairedPattern p = repaired(
      kSquare +
      "M 90 10,0 10,100; V -45 20,0 20,100; U 30 30,0 30,100; U 40,0 40,100; F 60 50,0 50,100;"
      "J 60,0 60,100; M 0 70,0 70,100");
  std::vector<double> angles;
  for (std::size_t e = 0; e < p.creases.assignments.size(); ++e) {
    if (p.creases.assignments[e] != Assignment::Border)
      angles.push_back(p.creases.pattern.edges[e].angle);
  }
  EXPECT_EQ(angles, (std::vector<double>{-90, 45, 30, 180, 0, 0, 0}));
  EXPECT_FALSE(isMeantFlat(p.creases));
  EXPECT_TRUE(isMeantFlat(repaired(kSquare + "M 50,0 50,100").creases));
}

TEST(PatternOf, LinesThatCrossGetAVertexThere) {
  const RepairedPattern p = repaired(kSquare + "V 0,0 100,100; M 0,100 100,0");
  EXPECT_EQ(sizes(p), "5 8 4");
  EXPECT_EQ(countOf(p, RepairKind::SplitCrossings), 1U);
}

TEST(PatternOf, ManyLinesThroughOnePointGetOneVertex) {
  const RepairedPattern p = repaired(kSquare +
                                     "V 0,33 100,67; M 0,67 100,33; M 33,0 67,100;"
                                     "V 67,0 33,100; U 0,0 100,100; U 0,100 100,0");
  EXPECT_EQ(sizes(p), "13 24 12");
}

TEST(PatternOf, EndsNearEachOtherBecomeOneVertexAndTheMoveIsTold) {
  const RepairedPattern p = repaired(
      "B 0,0 100,0.004; B 100,0 100,100; B 100,100 0,100; B 0,100 0,0.003; V 0.002,0 100,100");
  EXPECT_EQ(sizes(p), "4 5 2");
  const Repair* merged = repairOf(p, RepairKind::MergedVertices);
  ASSERT_NE(merged, nullptr);
  EXPECT_GT(merged->farthest, 1e-4);
  EXPECT_LT(merged->farthest, 0.004);
  EXPECT_FALSE(merged->places.empty());
  EXPECT_NE(merged->message.find("merged"), std::string::npos);
  EXPECT_GT(p.mergedWithin, 0.004);
}

TEST(PatternOf, EndsBesideALineAreDrawnToIt) {
  const RepairedPattern p = repaired(kSquare + "V 50,0.01 50,99.99; M 50.01,50 100,50");
  EXPECT_EQ(sizes(p), "8 10 3");
  EXPECT_EQ(countOf(p, RepairKind::MovedToEdge), 3U);
  for (const Vec2 v : p.creases.pattern.vertices)
    EXPECT_TRUE(v.y == 0 || v.y == 50 || v.y == 100) << v.x << ' ' << v.y;
}

TEST(PatternOf, ShortTrueLinesAreNotSwallowed) {
  // Loose ends miss by 0.001; the pleat is 0.05 wide.
  const RepairedPattern p =
      repaired(kSquare + "V 40,0.001 40,99.999; M 40.05,0.001 40.05,99.999; V 70,0.001 70,99.999");
  EXPECT_EQ(sizes(p), "10 13 4");
  EXPECT_LT(p.mergedWithin, 0.05);
}

TEST(PatternOf, AGivenMergeDistanceIsUsed) {
  RepairOptions options;
  options.merge = 2;
  const RepairedPattern p =
      repaired("B 0,0 99,1; B 100,0 100,100; B 100,100 0,100; B 0,100 0,1; V 1,0 100,100", options);
  EXPECT_EQ(sizes(p), "4 5 2");
  EXPECT_EQ(p.mergedWithin, 2);
}

TEST(PatternOf, LinesOnLinesAreLeftOutAndConflictsTold) {
  const RepairedPattern p = repaired(kSquare +
                                     "V 50,0 50,100; V 50,100 50,0; F 50,0 50,60;"
                                     "M 20,0 80,0");
  EXPECT_EQ(sizes(p), "9 10 2");
  EXPECT_EQ(edgesAs(p, Assignment::Valley), 2U);
  EXPECT_EQ(edgesAs(p, Assignment::Mountain), 0U);
  EXPECT_EQ(countOf(p, RepairKind::Conflicts), 3U);
  EXPECT_GE(countOf(p, RepairKind::DroppedDuplicates), 1U);
}

TEST(PatternOf, OfLinesOnEachOtherTheStrongerAssignmentIsKept) {
  const std::string order = "BCMUFJ";
  for (std::size_t i = 0; i < order.size(); ++i) {
    for (std::size_t j = i + 1; j < order.size(); ++j) {
      const auto line = [&](std::size_t k) { return std::string(1, order[k]) + " 50,0 50,100;"; };
      const RepairedPattern a = repaired(kSquare + line(i) + line(j));
      const RepairedPattern b = repaired(kSquare + line(j) + line(i));
      EXPECT_EQ(linesOf(a.creases, 1), linesOf(b.creases, 1)) << order[i] << order[j];
      EXPECT_EQ(linesOf(a.creases, 1), linesOf(repaired(kSquare + line(i)).creases, 1));
    }
  }
}

TEST(PatternOf, PointsAndCoordinatesThatAreNoNumbersAreLeftOut) {
  CreaseDrawing drawing = drawn(kSquare + "M 50,50 50,50");
  const double none = std::numeric_limits<double>::quiet_NaN();
  const double endless = std::numeric_limits<double>::infinity();
  drawing.lines.push_back({{none, 0}, {1, 1}, Assignment::Mountain, {}});
  drawing.lines.push_back({{0, 0}, {endless, 1}, Assignment::Mountain, {}});
  drawing.lines.push_back({{0, 0}, {1e300, 1}, Assignment::Mountain, {}});
  const Result<RepairedPattern> p = patternOf(drawing);
  ASSERT_TRUE(p.isOk()) << p.error().message;
  EXPECT_EQ(sizes(*p), "4 4 1");
  EXPECT_EQ(countOf(*p, RepairKind::DroppedPoints), 4U);
}

TEST(PatternOf, CreasesThatEndInsideAFacetAreLeftOutAndTheLinesTheyPartedJoined) {
  const RepairedPattern p = repaired(kSquare + "V 50,0 50,100; M 50,30 80,30 80,60; M 50,30 20,30");
  EXPECT_EQ(sizes(p), "6 7 2");
  EXPECT_EQ(countOf(p, RepairKind::DroppedDangling), 3U);
  EXPECT_EQ(countOf(p, RepairKind::JoinedPieces), 1U);
}

TEST(PatternOf, VerticesThatWereDrawnOnStraightCreasesStay) {
  const RepairedPattern p = repaired(kSquare + "V 50,0 50,30 50,100");
  EXPECT_EQ(sizes(p), "7 8 2");
  EXPECT_EQ(countOf(p, RepairKind::JoinedPieces), 0U);
}

TEST(PatternOf, LinesOutsideThePaperAreLeftOut) {
  const RepairedPattern p = repaired(kSquare + "V -20,50 120,50; M 110,0 110,100");
  EXPECT_EQ(sizes(p), "6 7 2");
  EXPECT_EQ(countOf(p, RepairKind::DroppedOutside), 5U);
}

TEST(PatternOf, WithoutABorderTheOutlineBecomesOne) {
  const RepairedPattern p = repaired("M 0,0 100,0 100,100 0,100 0,0; V 0,0 100,100");
  EXPECT_EQ(sizes(p), "4 5 2");
  EXPECT_EQ(edgesAs(p, Assignment::Border), 4U);
  EXPECT_EQ(countOf(p, RepairKind::AddedBorder), 4U);
}

TEST(PatternOf, WhatEnclosesNothingGetsItsHullAsBorder) {
  const RepairedPattern p = repaired("V 0,50 100,50; M 50,0 50,100");
  EXPECT_EQ(sizes(p), "5 8 4");
  EXPECT_EQ(edgesAs(p, Assignment::Border), 4U);
  EXPECT_EQ(countOf(p, RepairKind::AddedBorder), 4U);
  // A side of the border is missing.
  const RepairedPattern q = repaired("B 0,100 0,0 100,0 100,100; V 50,0 50,100");
  EXPECT_EQ(sizes(q), "6 7 2");
}

TEST(PatternOf, LinesOnOneStraightLineEncloseNothing) {
  const Result<RepairedPattern> p = patternOf(drawn("B 0,0 50,50 100,100; M 20,20 70,70"));
  ASSERT_FALSE(p.isOk());
  EXPECT_EQ(p.error().code, ErrorCode::BadFile);
  EXPECT_NE(p.error().message.find("enclose no paper"), std::string::npos) << p.error().message;
  EXPECT_FALSE(patternOf(CreaseDrawing{}).isOk());
}

TEST(PatternOf, ABorderWithPaperOnBothSidesIsACut) {
  const RepairedPattern p = repaired(kSquare + "B 50,0 50,60; C 20,20 20,80; M 20,20 50,60");
  EXPECT_EQ(countOf(p, RepairKind::SlitBorders), 1U);
  EXPECT_EQ(edgesAs(p, Assignment::Cut), 2U);
  EXPECT_EQ(p.creases.pattern.facets.size(), 1U);  // the crease between two slits divides nothing
  EXPECT_EQ(countOf(p, RepairKind::DroppedDangling), 1U);
  for (const Edge& edge : p.creases.pattern.edges) {
    if (edge.kind == EdgeKind::Cut) EXPECT_EQ(edge.left, edge.right);
  }
}

TEST(PatternOf, BordersInsideBordersAreHolesAndPaperInHolesIsPaper) {
  const RepairedPattern p = repaired(kSquare +
                                     "B 20,20 80,20 80,80 20,80 20,20;"
                                     "B 40,40 60,40 60,60 40,60 40,40; V 0,50 20,50");
  EXPECT_EQ(p.creases.pattern.facets.size(), 2U);
  EXPECT_DOUBLE_EQ(areaOf(p.creases.pattern), 100 * 100 - 60 * 60 + 20 * 20);
}

TEST(PatternOf, SheetsSideBySideAreSeveralPieces) {
  const RepairedPattern p = repaired(
      "B 0,0 10,0 10,10 0,10 0,0; M 0,0 10,10; B 20,0 30,0 30,10 20,10 20,0; V 20,0 30,10;"
      "B 10,0 20,0; B 10,10 20,10");
  EXPECT_EQ(p.creases.pattern.facets.size(), 5U);
  EXPECT_EQ(edgesAs(p, Assignment::Cut), 2U);
  EXPECT_EQ(repaired("B 0,0 10,0 10,10 0,10 0,0; B 20,0 30,0 30,10 20,10 20,0")
                .creases.pattern.facets.size(),
            2U);
}

TEST(PatternOf, AClosedCreaseInsideAFacetMakesAHoleInIt) {
  const RepairedPattern p = repaired(kSquare + "M 30,30 70,30 70,70 30,70 30,30");
  ASSERT_EQ(p.creases.pattern.facets.size(), 2U);
  std::size_t holes = 0;
  for (const Facet& facet : p.creases.pattern.facets) holes += facet.holeStarts.size();
  EXPECT_EQ(holes, 1U);
}

TEST(PatternOf, FacesSayWhereThePaperIs) {
  const std::string lines = kSquare + "B 20,20 80,20 80,80 20,80 20,20";
  EXPECT_EQ(repaired(lines).creases.pattern.facets.size(), 1U);
  // Both regions are paper: the border between them is a cut.
  const RepairedPattern both =
      repaired(lines + "; face 0,0 100,0 100,100 0,100; face 20,20 20,80 80,80 80,20");
  EXPECT_EQ(both.creases.pattern.facets.size(), 2U);
  EXPECT_EQ(edgesAs(both, Assignment::Cut), 4U);
  EXPECT_EQ(countOf(both, RepairKind::IgnoredFaces), 0U);
}

TEST(PatternOf, FacesThatContradictTheLinesAreNotFollowed) {
  // A crease cannot end the paper; a face of no lines is none.
  const RepairedPattern p = repaired(kSquare + "M 50,0 50,100; face 0,0 50,0 50,100 0,100");
  EXPECT_EQ(sizes(p), "6 7 2");
  EXPECT_EQ(countOf(p, RepairKind::IgnoredFaces), 1U);
  const RepairedPattern q = repaired(kSquare + "M 50,0 50,100; face 300,0 350,0 350,100");
  EXPECT_EQ(sizes(q), "6 7 2");
  EXPECT_EQ(countOf(q, RepairKind::IgnoredFaces), 1U);
}

TEST(PatternOf, WithCutsOnlyTheCutsAreTheBorder) {
  const RepairedPattern p = repaired("C 0,0 100,0 100,100 0,100 0,0; M 0,0 100,100");
  EXPECT_EQ(sizes(p), "4 5 2");
  EXPECT_EQ(edgesAs(p, Assignment::Border), 4U);
}

TEST(PatternOf, JoinsAreFlatHinges) {
  const RepairedPattern p = repaired(kSquare + "J 0,0 100,100");
  EXPECT_EQ(p.creases.pattern.edges[4].kind, EdgeKind::Hinge);
  EXPECT_EQ(p.creases.pattern.edges[4].angle, 0);
  EXPECT_FALSE(p.creases.isFolded(EdgeId(4)));
}

TEST(PatternOf, UnitsBecomeMillimetres) {
  RepairOptions options;
  options.scale = 25.4;
  const RepairedPattern p = repaired("B 0,0 2,0 2,1 0,1 0,0", options);
  EXPECT_EQ(p.creases.pattern.vertices[2], (Vec2{50.8, 25.4}));
  options.scale = 0;
  EXPECT_FALSE(patternOf(drawn(kSquare), options).isOk());
}

TEST(PatternOf, CanBeStopped) {
  const Result<RepairedPattern> p =
      patternOf(drawn(kSquare + "M 0,0 100,100"), {}, [](double) { return false; });
  ASSERT_FALSE(p.isOk());
  EXPECT_EQ(p.error().code, ErrorCode::Cancelled);
}

TEST(DrawingOf, ComesBackAsTheSamePattern) {
  const RepairedPattern p =
      repaired(kSquare +
               "B 20,20 40,20 40,40 20,40 20,20; M 90 20,40 0,100; V 40,40 100,100; U 40,20 100,0;"
               "C 60,60 70,80; J 0,0 20,20");
  const CreaseDrawing again = drawingOf(p.creases);
  const Result<RepairedPattern> q = patternOf(again);
  ASSERT_TRUE(q.isOk());
  EXPECT_TRUE(q->repairs.empty());
  EXPECT_EQ(q->creases.pattern.vertices, p.creases.pattern.vertices);
  EXPECT_EQ(q->creases.assignments, p.creases.assignments);
  EXPECT_EQ(linesOf(q->creases, 1e-9), linesOf(p.creases, 1e-9));
}

}  // namespace
}  // namespace kiri::test
