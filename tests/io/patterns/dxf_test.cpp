// DXF: entities of every kind, layers and colours, blocks, damage.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "io/patterns/dxf_format.h"
#include "tests/io/patterns/pattern_texts.h"

namespace kiri {
namespace {

using test::patternTells;

/// Words in pairs, one a line, as DXF has them.
std::string pairs(const std::string& words) {
  std::string out = words;
  for (char& c : out) c = c == ' ' ? '\n' : c;
  return out + "\n";
}

std::string withEntities(const std::string& words) {
  return pairs("0 SECTION 2 ENTITIES " + words + " 0 ENDSEC 0 EOF");
}

PatternFile readDxf(const std::string& text) {
  Result<PatternFile> file = readDxfPattern(text, "a.dxf");
  EXPECT_TRUE(file.isOk()) << (file.isOk() ? "" : file.error().message);
  return file.isOk() ? std::move(file).value() : PatternFile{};
}

/// Every end of a line lies at that distance from the point, every middle no farther inside than
/// `within`.
void expectRound(const PatternFile& file, Vec2 centre, double radius, double within) {
  for (const DrawnCrease& line : file.drawing.lines) {
    EXPECT_NEAR(distance(line.from, centre), radius, radius * 1e-12);
    EXPECT_NEAR(distance(line.to, centre), radius, radius * 1e-12);
    EXPECT_GT(distance(lerp(line.from, line.to, 0.5), centre), radius - within);
  }
}

TEST(DxfReader, LayersOfOripaAndOrieditaSayWhatALineIs) {
  const PatternFile file = readDxf(withEntities(
      "0 LINE 8 CutLine 62 3 10 0 20 0 11 4 21 0 0 LINE 8 MountainLine 10 0 20 0 11 4 21 4 "
      "0 LINE 8 ValleyLine 10 0 20 4 11 4 21 0 0 LINE 8 AuxiliaryLine 62 4 10 0 20 1 11 4 21 1"));
  ASSERT_EQ(file.drawing.lines.size(), 4u);
  EXPECT_EQ(file.drawing.lines[0], (DrawnCrease{{0, 0}, {4, 0}, Assignment::Border, {}}));
  EXPECT_EQ(file.drawing.lines[1], (DrawnCrease{{0, 0}, {4, 4}, Assignment::Mountain, {}}));
  EXPECT_EQ(file.drawing.lines[2].assignment, Assignment::Valley);
  EXPECT_EQ(file.drawing.lines[3].assignment, Assignment::Flat);
  EXPECT_TRUE(file.notes.empty());
}

TEST(DxfReader, OtherLayersAreReadByColourOfTheEntityOrOfTheLayer) {
  const std::string layers = pairs(
      "0 SECTION 2 HEADER 9 $INSUNITS 70 5 0 ENDSEC "
      "0 SECTION 2 TABLES 0 TABLE 2 LAYER 0 LAYER 2 A 62 -5 0 ENDTAB 0 ENDSEC");
  const PatternFile file = readDxf(
      layers + withEntities("0 LINE 8 A 10 0 20 0 11 1 21 0 0 LINE 8 A 62 11 10 0 20 0 11 1 21 1 "
                            "0 LINE 8 B 10 0 20 0 11 2 21 1 0 LINE 8 B 420 16711680 10 0 20 0 11 3 "
                            "21 1 0 LINE 8 B 62 6 10 0 20 0 11 3 21 1"));
  ASSERT_EQ(file.drawing.lines.size(), 5u);
  EXPECT_EQ(file.drawing.lines[0].assignment, Assignment::Valley);
  EXPECT_EQ(file.drawing.lines[1].assignment, Assignment::Mountain);
  EXPECT_EQ(file.drawing.lines[2].assignment, Assignment::Border);
  EXPECT_EQ(file.drawing.lines[3].assignment, Assignment::Mountain);
  EXPECT_EQ(file.drawing.lines[4].assignment, Assignment::Unassigned);
  EXPECT_EQ(file.mmPerUnit, 10.0);
  EXPECT_TRUE(patternTells(file, "5 lines stand on layers"));
}

TEST(DxfReader, ADrawingOfOneColourHasNoBorders) {
  const PatternFile file = readDxf(withEntities("0 LINE 8 0 10 0 20 0 11 1 21 0"));
  EXPECT_EQ(file.drawing.lines[0].assignment, Assignment::Unassigned);
  EXPECT_TRUE(patternTells(file, "outline"));
}

TEST(DxfReader, PolylinesOldAndNewAreReadWithTheirBulges) {
  // Half a circle from (0, 0) to (2, 0) through (1, -1), then straight back.
  for (const char* words :
       {"0 LWPOLYLINE 8 CutLine 90 2 70 1 10 0 20 0 42 1 10 2 20 0",
        "0 POLYLINE 8 CutLine 66 1 70 1 0 VERTEX 10 0 20 0 42 1 0 VERTEX 10 2 20 0 0 SEQEND"}) {
    PatternFile file = readDxf(withEntities(words));
    ASSERT_GT(file.drawing.lines.size(), 10u);
    EXPECT_EQ(file.drawing.lines.back(), (DrawnCrease{{2, 0}, {0, 0}, Assignment::Border, {}}));
    EXPECT_TRUE(patternTells(file, "1 curve became a polyline"));
    file.drawing.lines.pop_back();
    EXPECT_EQ(file.drawing.lines.back().to, (Vec2{2, 0}));
    expectRound(file, {1, 0}, 1, 1e-4);
    EXPECT_LT(file.drawing.lines[1].to.y, 0);
  }
}

TEST(DxfReader, ArcsAndCirclesStayWithinTheTolerance) {
  const PatternFile arc = readDxf(withEntities("0 ARC 8 ValleyLine 10 3 20 4 40 5 50 350 51 80"));
  expectRound(arc, {3, 4}, 5, 5e-4);
  EXPECT_NEAR(distance(arc.drawing.lines.back().to, Vec2{3 + 5 * std::cos(1.3962634015954636),
                                                         4 + 5 * std::sin(1.3962634015954636)}),
              0, 1e-9);
  const PatternFile circle = readDxf(withEntities("0 CIRCLE 8 CutLine 10 3 20 4 40 5"));
  expectRound(circle, {3, 4}, 5, 5e-4);
  EXPECT_EQ(circle.drawing.lines.back().to, circle.drawing.lines.front().from);
}

TEST(DxfReader, ASplineOfDegreeThreeIsTheBezierCurveOfItsKnots) {
  const PatternFile file =
      readDxf(withEntities("0 SPLINE 8 CutLine 71 3 40 0 40 0 40 0 40 0 40 1 40 1 40 1 40 1 "
                           "10 0 20 0 10 0 20 4 10 4 20 4 10 4 20 0"));
  ASSERT_GT(file.drawing.lines.size(), 8u);
  EXPECT_EQ(file.drawing.lines.front().from, (Vec2{0, 0}));
  EXPECT_NEAR(distance(file.drawing.lines.back().to, {4, 0}), 0, 1e-12);
  double nearest = 9;
  for (const DrawnCrease& line : file.drawing.lines) {
    nearest = std::min(nearest, distance(line.from, {2, 3}));
  }
  EXPECT_NEAR(nearest, 0, 1e-12) << "the middle of this curve";
}

TEST(DxfReader, BlocksAreInsertedTurnedAndScaled) {
  const std::string blocks = pairs(
      "0 SECTION 2 BLOCKS 0 BLOCK 8 0 2 B 10 1 20 0 0 LINE 8 0 10 1 20 0 11 2 21 0 0 ENDBLK "
      "0 ENDSEC");
  const PatternFile file = readDxf(
      blocks + withEntities("0 INSERT 2 B 8 MountainLine 10 5 20 6 41 2 42 2 50 90 "
                            "0 INSERT 2 B 8 ValleyLine 10 0 20 0 70 3 44 10 0 INSERT 2 NONE"));
  ASSERT_EQ(file.drawing.lines.size(), 4u);
  EXPECT_EQ(file.drawing.lines[0].assignment, Assignment::Mountain);
  EXPECT_NEAR(distance(file.drawing.lines[0].from, {5, 6}), 0, 1e-12);
  EXPECT_NEAR(distance(file.drawing.lines[0].to, {5, 8}), 0, 1e-12);
  EXPECT_EQ(file.drawing.lines[3], (DrawnCrease{{20, 0}, {21, 0}, Assignment::Valley, {}}));
  EXPECT_TRUE(patternTells(file, "unknown block"));
}

TEST(DxfReader, BlocksThatInsertEachOtherEndInASentence) {
  std::string blocks = "0 SECTION 2 BLOCKS";
  for (int i = 0; i < 15; ++i) {
    const std::string inner = " 0 INSERT 2 B" + std::to_string(i + 1);
    blocks += " 0 BLOCK 2 B" + std::to_string(i);
    for (int k = 0; k < 9; ++k) blocks += inner;
    blocks += " 0 ENDBLK";
  }
  blocks += " 0 BLOCK 2 B15 0 LINE 11 1 0 ENDBLK 0 BLOCK 2 SELF 0 INSERT 2 SELF 0 ENDBLK 0 ENDSEC";
  const Result<PatternFile> bomb =
      readDxfPattern(pairs(blocks) + withEntities("0 INSERT 2 B0"), "a.dxf");
  ASSERT_FALSE(bomb.isOk());
  EXPECT_NE(bomb.error().message.find("inserted"), std::string::npos);
  const PatternFile self =
      readDxf(pairs(blocks) + withEntities("0 INSERT 2 SELF 0 LINE 8 CutLine 11 1"));
  EXPECT_EQ(self.drawing.lines.size(), 1u);
}

TEST(DxfReader, WhatCannotBeReadGetsASentence) {
  const auto errorOf = [](const std::string& text) {
    const Result<PatternFile> file = readDxfPattern(text, "a.dxf");
    EXPECT_FALSE(file.isOk());
    return file.isOk() ? "" : file.error().message;
  };
  EXPECT_NE(errorOf("AutoCAD Binary DXF\r\n\x1a").find("binary"), std::string::npos);
  EXPECT_NE(errorOf("hello\nworld\n").find("line 1 is no group code"), std::string::npos);
  EXPECT_NE(errorOf(withEntities("0 TEXT 1 a")).find("1 TEXT entity was left out"),
            std::string::npos);
  const PatternFile part = readDxf(pairs("0 SECTION 2 ENTITIES 0 LINE 8 CutLine 11 1 x y"));
  EXPECT_EQ(part.drawing.lines.size(), 1u);
  EXPECT_TRUE(patternTells(part, "is no group code; what comes before was read"));
}

TEST(DxfWriter, MillimetresAreSaid) {
  PatternFile file = test::fileWithEverythingDrawn();
  file.mmPerUnit = 1;
  EXPECT_NE(writeDxfPattern(file).text.find("$INSUNITS\n 70\n4\n"), std::string::npos);
}

}  // namespace
}  // namespace kiri
