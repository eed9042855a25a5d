// FOLD files of any program as drawings: frames, angles, folded forms, orders, damage.
// SPDX-License-Identifier: MIT
#include "io/patterns/fold_reader.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace kiri {
namespace {

PatternFile readFold(const std::string& text) {
  Result<PatternFile> file = readFoldPattern(text, "a.fold");
  EXPECT_TRUE(file.isOk()) << (file.isOk() ? "" : file.error().message);
  return file.isOk() ? std::move(file).value() : PatternFile{};
}

std::string errorOf(const std::string& text) {
  const Result<PatternFile> file = readFoldPattern(text, "a.fold");
  EXPECT_FALSE(file.isOk());
  return file.isOk() ? "" : file.error().message;
}

bool tells(const PatternFile& file, const std::string& words) {
  for (const std::string& note : file.notes) {
    if (note.find(words) != std::string::npos) return true;
  }
  return false;
}

/// Two halves of a square with a diagonal, in the words of the specification.
const std::string kSquare =
    R"("vertices_coords":[[0,0],[1,0],[1,1],[0,1]],
       "edges_vertices":[[0,1],[1,2],[2,3],[3,0],[0,2]])";
const std::string kHalves = R"("faces_vertices":[[0,1,2],[0,2,3]])";

TEST(FoldReader, ReadsGeometryAssignmentsAndAnglesUnderBothKeys) {
  for (const char* key : {"edges_foldAngle", "edges_foldAngles"}) {
    const PatternFile file =
        readFold("{" + kSquare + R"(,"edges_assignment":["B","B","C","J","V"],")" + key +
                 R"(":[0,0,null,0,90.5],"file_title":"t","file_author":"a",
                    "file_description":"d","frame_unit":"cm"})");
    ASSERT_EQ(file.drawing.lines.size(), 5u);
    EXPECT_EQ(file.drawing.lines[4], (DrawnCrease{{0, 0}, {1, 1}, Assignment::Valley, 90.5}));
    EXPECT_EQ(file.drawing.lines[2].assignment, Assignment::Cut);
    EXPECT_EQ(file.drawing.lines[3].assignment, Assignment::Join);
    EXPECT_EQ(file.title, "t");
    EXPECT_EQ(file.author, "a");
    EXPECT_EQ(file.description, "d");
    EXPECT_EQ(file.mmPerUnit, 10.0);
    EXPECT_TRUE(file.notes.empty());
  }
}

TEST(FoldReader, WithoutAssignmentsSidesOfOneFaceAreBorders) {
  const PatternFile file = readFold("{" + kSquare + "," + kHalves + "}");
  EXPECT_EQ(file.drawing.lines[0].assignment, Assignment::Border);
  EXPECT_EQ(file.drawing.lines[4].assignment, Assignment::Unassigned);
  EXPECT_EQ(file.drawing.faces.size(), 2u);
  const PatternFile byEdges =
      readFold("{" + kSquare + R"(,"edges_faces":[[0],[null,0],[1,null],[1],[0,1]]})");
  EXPECT_EQ(byEdges.drawing.lines[2].assignment, Assignment::Border);
  EXPECT_EQ(byEdges.drawing.lines[4].assignment, Assignment::Unassigned);
}

TEST(FoldReader, WithoutEdgesTheSidesOfFacesAreTaken) {
  const PatternFile file =
      readFold(R"({"vertices_coords":[[0,0],[1,0],[1,1],[0,1]],)" + kHalves + "}");
  EXPECT_EQ(file.drawing.lines.size(), 5u);
  EXPECT_TRUE(tells(file, "edges_vertices is missing"));
}

TEST(FoldReader, TheFrameOfClassCreasePatternIsThePattern) {
  const std::string folded = R"({"frame_classes":["foldedForm"],
      "vertices_coords":[[0,0],[1,0],[1,1],[1,0]],
      "edges_vertices":[[0,1],[1,2],[2,3],[3,0],[0,2]],
      "edges_assignment":["B","B","B","B","V"],)" +
                             kHalves + R"(,"file_frames":[)";
  const PatternFile file =
      readFold(folded + R"({"frame_classes":["creasePattern"],"frame_parent":0,"frame_inherit":true,
                   "vertices_coords":[[0,0],[1,0],[1,1],[0,1]]}]})");
  ASSERT_EQ(file.drawing.lines.size(), 5u);
  EXPECT_EQ(file.drawing.lines[3].from, (Vec2{0, 1}));
  EXPECT_TRUE(tells(file, "frame 1 of 2"));
}

TEST(FoldReader, InheritanceGoesThroughSeveralFramesAndLoopsAreCut) {
  const std::string frames =
      R"({"file_frames":[
        {"frame_inherit":true,"frame_parent":2,"frame_classes":["creasePattern"]},
        {"frame_inherit":true,"frame_parent":1,)" +
      kSquare + "}]}";
  const PatternFile file = readFold(frames);
  EXPECT_EQ(file.drawing.lines.size(), 5u);
  EXPECT_TRUE(tells(file, "loop"));
}

TEST(FoldReader, AFoldedFormIsRolledOut) {
  const PatternFile file = readFold(
      R"({"frame_classes":["foldedForm"],
          "vertices_coords":[[0,0],[1,0],[1,1],[1,0]],
          "edges_vertices":[[0,1],[1,2],[2,3],[3,0],[0,2]],
          "edges_assignment":["B","B","B","B","V"],)" +
      kHalves + "}");
  ASSERT_EQ(file.drawing.lines.size(), 5u);
  EXPECT_NEAR(file.drawing.lines[3].from.x, 0, 1e-12);
  EXPECT_NEAR(file.drawing.lines[3].from.y, 1, 1e-12);
  EXPECT_EQ(file.drawing.lines[4].from, (Vec2{0, 0}));
  EXPECT_TRUE(tells(file, "rolled out"));
}

TEST(FoldReader, AFormInSpaceIsRolledOutAndItsAnglesAreMeasured) {
  // The half with vertex 3 stands upright above the middle: a valley of 90 degrees.
  const PatternFile file = readFold(
      R"({"vertices_coords":[[0,0,0],[1,0,0],[1,1,0],[0.5,0.5,0.70710678118654757]],
          "edges_vertices":[[0,1],[1,2],[2,3],[3,0],[0,2]],)" +
      kHalves + "}");
  ASSERT_EQ(file.drawing.lines.size(), 5u);
  EXPECT_NEAR(distance(file.drawing.lines[3].from, {0, 1}), 0, 1e-12);
  EXPECT_EQ(file.drawing.lines[4].assignment, Assignment::Valley);
  EXPECT_NEAR(file.drawing.lines[4].angle.value_or(0), 90, 1e-12);
}

TEST(FoldReader, OrdersAreNamedByPointsInsideAndFollowTheNormal) {
  const std::string start = "{" + kSquare + R"(,"faceOrders":[[1,0,1]],"faces_vertices":)";
  const PatternFile front = readFold(start + "[[0,1,2],[0,2,3]]}");
  ASSERT_EQ(front.drawing.orders.size(), 1u);
  EXPECT_TRUE(front.drawing.orders[0].isFront);
  EXPECT_GT(front.drawing.orders[0].upper.y, front.drawing.orders[0].upper.x);
  EXPECT_LT(front.drawing.orders[0].lower.y, front.drawing.orders[0].lower.x);
  const PatternFile back = readFold(start + "[[2,1,0],[0,2,3]]}");
  ASSERT_EQ(back.drawing.orders.size(), 1u);
  EXPECT_FALSE(back.drawing.orders[0].isFront);
}

TEST(FoldReader, OrdersOfAFoldedFormWithTheSameFacesAreTaken) {
  const PatternFile file = readFold(
      R"({"frame_classes":["creasePattern"],)" + kSquare + "," + kHalves +
      R"(,"file_frames":[{"frame_classes":["foldedForm"],"frame_inherit":true,"frame_parent":0,
         "vertices_coords":[[0,0],[1,0],[1,1],[1,0]],"faceOrders":[[0,1,-1],[0,7,1]]}]})");
  ASSERT_EQ(file.drawing.orders.size(), 1u);
  EXPECT_FALSE(file.drawing.orders[0].isFront);
  EXPECT_TRUE(tells(file, "name no two faces"));
}

TEST(FoldReader, DamagedPartsAreLeftOutAndCounted) {
  const PatternFile file = readFold(
      R"({"vertices_coords":[[0,0],[1,0],[1,1],["x",1],[1e300,1],[0,1]],
          "edges_vertices":[[0,1],[1,2],[2,5],[5,0],[0,9],[0],"e",[3,0],[4,0],[0,1.5],[0,2]],
          "edges_assignment":["B","b","B","B","M","M","M","M","M","M","Q"],
          "edges_foldAngle":[0,0,0,0,-180,0,0,0,0,0,999],
          "faces_vertices":[[0,1,77]]})");
  EXPECT_EQ(file.drawing.lines.size(), 5u);
  EXPECT_EQ(file.drawing.lines[1].assignment, Assignment::Border);
  EXPECT_EQ(file.drawing.lines[4].assignment, Assignment::Unassigned);
  EXPECT_TRUE(file.drawing.faces.empty());
  EXPECT_TRUE(tells(file, "2 vertices"));
  EXPECT_TRUE(tells(file, "6 edges (the first: 4) without two good vertices"));
  EXPECT_TRUE(tells(file, "an assignment that FOLD does not know"));
  EXPECT_TRUE(tells(file, "no number from -180 to 180"));
  EXPECT_TRUE(tells(file, "1 face (0)"));
}

TEST(FoldReader, AnglesThatSayTheOppositeOfTheLetterFollowTheLetter) {
  const PatternFile file = readFold("{" + kSquare + R"(,"edges_assignment":["B","B","B","M","V"],
                                  "edges_foldAngle":[0,0,0,90,180]})");
  EXPECT_EQ(file.drawing.lines[3].angle, -90.0);
  EXPECT_TRUE(tells(file, "disagree"));
}

TEST(FoldReader, AnglesThatAreAllZeroSayHowThePaperLiesNow) {
  const PatternFile file = readFold("{" + kSquare + R"(,"edges_assignment":["B","B","B","M","V"],
                                  "edges_foldAngle":[0,0,0,0,0]})");
  EXPECT_EQ(file.drawing.lines[4].angle, std::nullopt);
  EXPECT_TRUE(tells(file, "angle 0"));
}

TEST(FoldReader, KeysOfOthersAreKeptAndArraysOfOthersAreListed) {
  const PatternFile file =
      readFold("{" + kSquare + R"(,"cpedit:page":{"xMin":0},"edges_my:colour":[1,2,3,4,5],
                                  "kiri:losses":["x"],"edges_length":[1,1,1,1,1]})");
  EXPECT_EQ(file.unknown, R"({"cpedit:page": {"xMin": 0}})");
  EXPECT_TRUE(tells(file, "edges_my:colour"));
  EXPECT_FALSE(tells(file, "edges_length"));
}

TEST(FoldReader, WhatCannotBeReadGetsASentenceWithTheFile) {
  for (const char* text :
       {"[]", "{}", R"({"vertices_coords":[]})", R"({"vertices_coords":7})",
        R"({"vertices_coords":[[0,0]]})", R"({"vertices_coords":[[0,0]],"edges_vertices":[[0,1]]})",
        R"({"file_frames":[{"frame_inherit":true}]})",
        R"({"vertices_coords":[[0,0,0],[1,0,1]],"edges_vertices":[[0,1]]})"}) {
    EXPECT_EQ(errorOf(text).rfind("a.fold: ", 0), 0u) << errorOf(text);
  }
}

}  // namespace
}  // namespace kiri
