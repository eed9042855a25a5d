// Where facets lie when everything is folded flat, and patterns that do not fold.
// SPDX-License-Identifier: MIT
#include "core/flatfold/flat_map.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

#include "core/creases/repair.h"
#include "core/flatfold/flat_folding.h"
#include "tests/core/flatfold/flat_patterns.h"

namespace kiri::test {
namespace {

AssignedPattern starPattern(const std::vector<double>& degrees) {
  std::vector<double> radians;
  for (const double d : degrees) radians.push_back(d * std::numbers::pi / 180);
  AssignedPattern creases(starOf(radians).pattern);
  for (Edge& edge : creases.pattern.edges) {
    const bool isHinge = edge.kind == EdgeKind::Hinge;
    if (isHinge) edge.angle = 180;
    creases.assignments.push_back(isHinge ? Assignment::Unassigned : Assignment::Border);
  }
  return creases;
}

void addLoop(CreaseDrawing& drawing, const std::vector<Vec2>& corners) {
  for (std::size_t i = 0; i < corners.size(); ++i)
    drawing.lines.push_back(
        {corners[i], corners[(i + 1) % corners.size()], Assignment::Border, std::nullopt});
}

/// A square of side 6 with a hole, and creases from the hole outward.
AssignedPattern ringPattern(const std::vector<DrawnCrease>& creases) {
  CreaseDrawing drawing;
  addLoop(drawing, {{0, 0}, {6, 0}, {6, 6}, {0, 6}});
  addLoop(drawing, {{2, 2}, {4, 2}, {4, 4}, {2, 4}});
  for (const DrawnCrease& crease : creases) drawing.lines.push_back(crease);
  return patternOf(drawing)->creases;
}

DrawnCrease valley(Vec2 from, Vec2 to) { return {from, to, Assignment::Valley, std::nullopt}; }

TEST(FlatMap, LaysAMapOnOneSquare) {
  const AssignedPattern creases = mapPattern(6, 5);
  const Result<FlatMap> map = flatMapOf(creases);
  ASSERT_TRUE(map.isOk());
  EXPECT_LT(map->error, 1e-12);
  Vec2 low = map->vertices.front();
  Vec2 high = low;
  for (const Vec2 v : map->vertices) {
    low = {std::min(low.x, v.x), std::min(low.y, v.y)};
    high = {std::max(high.x, v.x), std::max(high.y, v.y)};
  }
  EXPECT_NEAR(high.x - low.x, 1, 1e-12);
  EXPECT_NEAR(high.y - low.y, 1, 1e-12);
  std::size_t flipped = 0;
  for (const FlatPose& pose : map->poses) flipped += pose.isFlipped ? 1 : 0;
  EXPECT_EQ(flipped, 15U);
}

TEST(FlatMap, KeepsEveryFacetRigidAndTheLargestOfEachPieceAtRest) {
  const AssignedPattern creases = twistTessellation(3);
  const Result<FlatMap> map = flatMapOf(creases);
  ASSERT_TRUE(map.isOk());
  EXPECT_LT(map->error, 1e-12);
  std::size_t resting = 0;
  for (const FlatPose& pose : map->poses) {
    EXPECT_NEAR(dot(pose.x, pose.x), 1, 1e-12);
    EXPECT_NEAR(dot(pose.y, pose.y), 1, 1e-12);
    EXPECT_NEAR(cross(pose.x, pose.y), pose.isFlipped ? -1 : 1, 1e-12);
    resting += pose.x == Vec2{1, 0} && pose.y == Vec2{0, 1} && pose.origin == Vec2{} ? 1U : 0U;
  }
  EXPECT_GE(resting, 1U);

  CreaseDrawing twoSheets;
  addLoop(twoSheets, {{0, 0}, {4, 0}, {4, 2}, {0, 2}});
  addLoop(twoSheets, {{10, 0}, {12, 0}, {12, 2}, {10, 2}});
  twoSheets.lines.push_back(valley({3, 0}, {3, 2}));
  twoSheets.lines.push_back(valley({10.5, 0}, {10.5, 2}));
  const AssignedPattern pieces = patternOf(twoSheets)->creases;
  const Result<FlatMap> apart = flatMapOf(pieces);
  ASSERT_TRUE(apart.isOk());
  std::size_t faceUp = 0;
  for (const FlatPose& pose : apart->poses) faceUp += pose.isFlipped ? 0 : 1;
  EXPECT_EQ(faceUp, 2U);
}

/// Three creases at 120 degrees: every vertex could be where it is, but the third facet would have
/// to show both sides.
TEST(FlatMap, TellsAnOddVertexByItsPlace) {
  const Result<FlatMap> odd = flatMapOf(starPattern({120, 120, 120}));
  ASSERT_FALSE(odd.isOk());
  EXPECT_EQ(odd.error().code, ErrorCode::WouldStretch);
  EXPECT_NE(odd.error().message.find("an odd number of folded creases meet at (0, 0) mm"),
            std::string::npos);
  EXPECT_EQ(odd.error().witness.points.size(), 1U);
  EXPECT_FALSE(odd.error().witness.segments.empty());
}

TEST(FlatMap, TellsAVertexThatMissesKawasaki) {
  const Result<FlatMap> bent = flatMapOf(starPattern({90, 91, 90, 89}));
  ASSERT_TRUE(bent.isOk());
  const Result<FlatMap> worse = flatMapOf(starPattern({92, 91, 90, 87}));
  ASSERT_FALSE(worse.isOk());
  EXPECT_EQ(worse.error().code, ErrorCode::WouldStretch);
  EXPECT_NE(worse.error().message.find("but for 2;"), std::string::npos) << worse.error().message;
  EXPECT_EQ(worse.error().witness.segments.size(), 4U);
}

TEST(FlatMap, ClosesAroundHolesOrSaysThatItDoesNot) {
  // Two creases on one line fold the ring in half.
  EXPECT_TRUE(flatMapOf(ringPattern({valley({3, 0}, {3, 2}), valley({3, 4}, {3, 6})})).isOk());
  // A single crease through one side of the ring: the other side would have to turn over as well.
  const Result<FlatMap> single = flatMapOf(
      ringPattern({valley({3, 0}, {3, 2}), valley({0, 3}, {2, 3}), valley({4, 3}, {6, 3})}));
  ASSERT_FALSE(single.isOk());
  EXPECT_NE(single.error().message.find("around a hole"), std::string::npos);
  // Two creases that are not on one line: every facet shows one side, but the ring does not close.
  const Result<FlatMap> open =
      flatMapOf(ringPattern({valley({2.5, 0}, {2.5, 2}), valley({3.5, 4}, {3.5, 6})}));
  ASSERT_FALSE(open.isOk());
  EXPECT_NE(open.error().message.find("2 mm apart"), std::string::npos) << open.error().message;
  EXPECT_EQ(open.error().witness.segments.size(), 1U);
}

TEST(FlatFold, RefusesCreasesThatAreNotMeantToFoldFlat) {
  AssignedPattern creases = mapPattern(2, 1);
  for (std::size_t e = 0; e < creases.pattern.edges.size(); ++e) {
    if (creases.pattern.edges[e].kind == EdgeKind::Hinge) creases.pattern.edges[e].angle = 90;
  }
  const Result<FlatFolding> folding = flatFold(creases);
  ASSERT_FALSE(folding.isOk());
  EXPECT_EQ(folding.error().code, ErrorCode::BadValue);
  EXPECT_NE(folding.error().message.find("from (1, 0) to (1, 1) mm is meant to fold by 90 degrees"),
            std::string::npos);
}

TEST(FlatFold, ReportsProgressToTheEnd) {
  double last = -1;
  const Result<FlatFolding> folding = flatFold(twistTessellation(3), {}, [&](double part) {
    EXPECT_GE(part, last);
    EXPECT_LE(part, 1);
    last = part;
    return true;
  });
  ASSERT_TRUE(folding.isOk());
  EXPECT_GE(last, 0.4);
  const Result<FlatFolding> stopped =
      flatFold(twistTessellation(3), {}, [](double part) { return part < 0.1; });
  ASSERT_FALSE(stopped.isOk());
  EXPECT_EQ(stopped.error().code, ErrorCode::Cancelled);
}

}  // namespace
}  // namespace kiri::test
