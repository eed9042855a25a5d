// .cp and .opx: what each line means, which way up, and damage.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <string>

#include "io/patterns/cp_format.h"
#include "io/patterns/opx_format.h"
#include "tests/io/patterns/pattern_texts.h"

namespace kiri {
namespace {

using test::patternTells;

PatternFile readCp(const std::string& text) {
  Result<PatternFile> file = readCpPattern(text, "a.cp");
  EXPECT_TRUE(file.isOk()) << (file.isOk() ? "" : file.error().message);
  return file.isOk() ? std::move(file).value() : PatternFile{};
}

PatternFile readOpx(const std::string& text) {
  Result<PatternFile> file = readOpxPattern(text, "a.opx");
  EXPECT_TRUE(file.isOk()) << (file.isOk() ? "" : file.error().message);
  return file.isOk() ? std::move(file).value() : PatternFile{};
}

TEST(CpReader, EachTypeHasItsMeaningAndYTurnsUp) {
  const PatternFile file =
      readCp("1 -200 -200 200 -200\n2\t0 0 1.5e1 -0.25\r\n3 0,0,1,2\r4 0 0 1 3\n0 0 0 1 4\n\n");
  ASSERT_EQ(file.drawing.lines.size(), 5u);
  EXPECT_EQ(file.drawing.lines[0], (DrawnCrease{{-200, 200}, {200, 200}, Assignment::Border, {}}));
  EXPECT_EQ(file.drawing.lines[1], (DrawnCrease{{0, 0}, {15, 0.25}, Assignment::Mountain, {}}));
  EXPECT_EQ(file.drawing.lines[2].assignment, Assignment::Valley);
  EXPECT_EQ(file.drawing.lines[3].assignment, Assignment::Flat);
  EXPECT_EQ(file.drawing.lines[4].assignment, Assignment::Unassigned);
  EXPECT_TRUE(file.notes.empty());
}

TEST(CpReader, LinesThatMakeNoSenseAreCountedWithTheFirstOfThem) {
  const PatternFile file =
      readCp("# mine\n1 0 0 1 1\n2 0 0 1\n2 0 0 1 1 7\n2 0 0 1e99 1\n9 0 0 2 2\n2 0 0 nan 1\n");
  EXPECT_EQ(file.drawing.lines.size(), 2u);
  EXPECT_EQ(file.drawing.lines[1].assignment, Assignment::Flat);
  EXPECT_TRUE(patternTells(file, "5 lines of the file (the first: 1)"));
  EXPECT_TRUE(patternTells(file, "1 line of the file (6) of a type"));
  EXPECT_FALSE(readCpPattern("hello\nworld", "a.cp").isOk());
}

/// A chiral mark as a person sees it in Oriedita or ORIPA, where y points down on the screen: the
/// pinwheel's arm at the upper left corner runs along the upper side. Seen here, it must too.
TEST(CpReader, APatternLooksAsItDoesInTheProgramThatWroteIt) {
  const PatternFile file = readCp("2 -200 -100 -50 -100\n");
  const DrawnCrease& arm = file.drawing.lines[0];
  EXPECT_GT(arm.from.y, 0) << "above the middle on their screen, above it in the paper frame";
  EXPECT_EQ(arm.from.x, -200) << "left stays left";
  EXPECT_EQ(arm.assignment, Assignment::Mountain) << "what they draw as mountain is a mountain";
}

const std::string kBeanStart =
    R"(<?xml version="1.0" encoding="UTF-8"?><java version="1.5.0" class="java.beans.XMLDecoder">
       <object class="oripa.DataSet">)";

std::string opxLine(const std::string& properties) {
  return R"(<void index="0"><object class="oripa.OriLineProxy">)" + properties + "</object></void>";
}

TEST(OpxReader, DefaultsThatJavaLeavesOutAreZero) {
  const PatternFile file =
      readOpx(kBeanStart +
              R"(<void property="lines"><array class="oripa.OriLineProxy" length="999999999">)" +
              opxLine(R"(<void property="type"><int>2</int></void>
                 <void property="y1"><double>-1.5</double></void>)") +
              opxLine(R"(<void property="x0"><double>3</double></void>)") + R"(</array></void>
      <void property="title"><string>a &lt; b</string></void>
      <void property="memo"><string>m</string></void>
      <void property="reference"><string>a book</string></void></object></java>)");
  ASSERT_EQ(file.drawing.lines.size(), 2u);
  EXPECT_EQ(file.drawing.lines[0], (DrawnCrease{{0, 0}, {0, 1.5}, Assignment::Mountain, {}}));
  EXPECT_EQ(file.drawing.lines[1], (DrawnCrease{{3, 0}, {0, 0}, Assignment::Flat, {}}));
  EXPECT_EQ(file.title, "a < b");
  EXPECT_EQ(file.description, "m");
  EXPECT_TRUE(patternTells(file, "a book"));
}

TEST(OpxReader, TheDialectWithGetFieldIsReadToo) {
  const PatternFile file = readOpx(
      R"(<java><object class="oripa.DataSet" id="DataSet0">
      <void class="oripa.DataSet" method="getField"><string>lines</string><void method="set">
      <object idref="DataSet0"/><array class="oripa.OriLineProxy" length="1">)" +
      opxLine(R"(<void property="type"><int>4</int></void>
                 <void property="x1"><double>1</double></void>)") +
      R"(</array></void></void>
      <void class="oripa.DataSet" method="getField"><string>originalAuthorName</string>
      <void method="set"><object idref="DataSet0"/><string>Mitani</string></void></void>
      </object></java>)");
  ASSERT_EQ(file.drawing.lines.size(), 1u);
  EXPECT_EQ(file.drawing.lines[0].assignment, Assignment::Unassigned);
  EXPECT_EQ(file.author, "Mitani");
}

TEST(OpxReader, WhatIsBrokenIsReadAsFarAsItGoes) {
  const std::string start = kBeanStart + "\n" + opxLine(R"(<void property="type"><int>1</int></void>
      <void property="x0"><double>5</double></void>)");
  const PatternFile file =
      readOpx(start + opxLine(R"(<void property="x0"><double>oops</double></void>)"));
  EXPECT_EQ(file.drawing.lines.size(), 1u);
  EXPECT_TRUE(patternTells(file, "1 line (1) with numbers that make no sense"));
  EXPECT_TRUE(patternTells(file, "the XML is broken at line"));
  for (const char* text : {"<java>", "<svg/>", "no xml", "<a><b></a>"}) {
    EXPECT_FALSE(readOpxPattern(text, "a.opx").isOk()) << text;
  }
}

TEST(CpWriter, SaysWhatItCannotHold) {
  const WrittenPattern written = writeCpPattern(test::fileWithEverythingDrawn());
  std::string all;
  for (const std::string& loss : written.losses) all += loss + "\n";
  for (const char* word : {"fold angle", "cut", "join", "layer order", "title", "author",
                           "description", "unit", "keys", "unassigned"}) {
    EXPECT_NE(all.find(word), std::string::npos) << word << " in\n" << all;
  }
}

TEST(OpxWriter, TextsSurviveWhateverTheirCharacters) {
  PatternFile file = test::fileWithEverythingDrawn();
  file.title = "<a & \"b\">";
  file.description = "two\nlines\r\nand ]]> an end";
  const PatternFile again = readOpx(writeOpxPattern(file).text);
  EXPECT_EQ(again.title, file.title);
  EXPECT_EQ(again.description, file.description);
  EXPECT_EQ(again.author, file.author);
}

}  // namespace
}  // namespace kiri
