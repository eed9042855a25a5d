// What is read from SVG drawings.
// SPDX-License-Identifier: MIT
#include "io/patterns/svg_reader.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "io/patterns/svg_writer.h"

namespace kiri {
namespace {

std::string svgOf(const std::string& inside, const std::string& head = "") {
  return "<svg xmlns=\"http://www.w3.org/2000/svg\" " + head + ">" + inside + "</svg>";
}

PatternFile readDrawing(const std::string& text) {
  const Result<PatternFile> file = readSvgPattern(text, "a.svg");
  EXPECT_TRUE(file) << (file ? "" : file.error().message);
  return file ? *file : PatternFile{};
}

PatternFile drawn(const std::string& inside, const std::string& head = "") {
  return readDrawing(svgOf(inside, head));
}

std::string lettersOf(const PatternFile& file) {
  std::string letters;
  for (const DrawnCrease& line : file.drawing.lines) {
    letters += "BMVFUCJ"[static_cast<std::size_t>(line.assignment)];
  }
  return letters;
}

/// Notes that hold the words.
std::size_t notesWith(const PatternFile& file, const std::string& words) {
  return static_cast<std::size_t>(std::count_if(
      file.notes.begin(), file.notes.end(),
      [&](const std::string& note) { return note.find(words) != std::string::npos; }));
}

std::string line(const std::string& attributes, const std::string& ends = "0 0 1 1") {
  std::vector<std::string> at(1);
  for (const char c : ends) {
    if (c == ' ') {
      at.emplace_back();
    } else {
      at.back() += c;
    }
  }
  return "<line x1='" + at[0] + "' y1='" + at[1] + "' x2='" + at[2] + "' y2='" + at[3] + "' " +
         attributes + "/>";
}

TEST(SvgReader, ColoursMeanWhatTheyMeanInOtherPrograms) {
  struct Case {
    const char* colour;
    char letter;
    bool isListed;
  };
  for (const Case& c : {Case{"#ff0000", 'M', true},
                        Case{"red", 'M', true},
                        Case{"#F00", 'M', true},
                        Case{"rgb(255,0,0)", 'M', true},
                        Case{"rgb(100%, 0%, 0%)", 'M', true},
                        Case{"hsl(0, 100%, 50%)", 'M', true},
                        Case{"rgb(255 0 0 / 100%)", 'M', true},
                        Case{"blue", 'V', true},
                        Case{"#0000ffff", 'V', true},
                        Case{"hsla(240, 100%, 50%, 1)", 'V', true},
                        Case{"black", 'B', true},
                        Case{"lime", 'C', true},
                        Case{"green", 'C', true},
                        Case{"yellow", 'J', true},
                        Case{"#ff00ff", 'U', true},
                        Case{"gray", 'F', true},
                        Case{"#888", 'F', true},
                        Case{"hsl(0, 0%, 50%)", 'F', true},
                        Case{"darkred", 'M', false},
                        Case{"#ff8080", 'M', false},
                        Case{"navy", 'V', false},
                        Case{"#8080ff", 'V', false},
                        Case{"#101010", 'B', false},
                        Case{"silver", 'F', false},
                        Case{"cyan", 'F', false},
                        Case{"purple", 'U', false},
                        Case{"#00c020", 'C', false}}) {
    const PatternFile file = drawn(line("stroke='" + std::string(c.colour) + "'"));
    EXPECT_EQ(lettersOf(file), std::string(1, c.letter)) << c.colour;
    EXPECT_EQ(notesWith(file, "nearest"), c.isListed ? 0U : 1U) << c.colour;
  }
}

TEST(SvgReader, EveryUnlistedColourIsToldWithItsCount) {
  const PatternFile file = drawn(line("stroke='navy'") + line("stroke='#000080'", "2 2 3 3") +
                                 line("stroke='darkred'", "4 4 5 5"));
  EXPECT_EQ(notesWith(file, "2 lines in #000080 read as valley"), 1U);
  EXPECT_EQ(notesWith(file, "1 line in #8b0000 read as mountain"), 1U);
}

TEST(SvgReader, DataWinOverColours) {
  const PatternFile file =
      drawn(line("stroke='red' data-assignment='V' data-foldAngle='120.5' opacity='0.5'"));
  ASSERT_EQ(lettersOf(file), "V");
  EXPECT_EQ(file.drawing.lines[0].angle, 120.5);
  EXPECT_EQ(lettersOf(drawn(line("data-assignment='f'"))), "F");
  EXPECT_EQ(lettersOf(drawn(line("data-foldAngle='-90'"))), "M");
  EXPECT_EQ(lettersOf(drawn("<g data-assignment='C'>" + line("stroke='red'") + "</g>")), "C");
}

TEST(SvgReader, AnglesAreOpacityTimesStrokeOpacityOfAHalfTurn) {
  EXPECT_EQ(drawn(line("stroke='red' opacity='.5'")).drawing.lines[0].angle, -90);
  EXPECT_EQ(drawn(line("stroke='blue' stroke-opacity='50%' opacity='.5'")).drawing.lines[0].angle,
            45);
  EXPECT_EQ(drawn("<g opacity='0.5'>" + line("stroke='rgba(0,0,255,.5)'") + "</g>")
                .drawing.lines[0]
                .angle,
            45);
  EXPECT_FALSE(drawn(line("stroke='blue' opacity='1'")).drawing.lines[0].angle);
  EXPECT_FALSE(drawn(line("stroke='black' opacity='.5'")).drawing.lines[0].angle);
  EXPECT_EQ(notesWith(drawn(line("stroke='red' opacity='.5'")), "1 line folds part of the way"),
            1U);
}

TEST(SvgReader, RulesAreAppliedAsCssHasIt) {
  const std::string sheet =
      "<style>/* none { } */ <![CDATA[ line { stroke: blue } .m{stroke:red;stroke-opacity:.5}\n"
      "#one { stroke: #000 } g.outer > .n { stroke: yellow } g .n { stroke: magenta }\n"
      "@media print { line { stroke: lime } } .w:hover { stroke: lime }\n"
      ".k { stroke: gray !important }]]></style>";
  EXPECT_EQ(lettersOf(drawn(sheet + line(""))), "V");
  EXPECT_EQ(lettersOf(drawn(sheet + line("class='x m' stroke='lime'"))), "M");
  EXPECT_EQ(drawn(sheet + line("class='m'")).drawing.lines[0].angle, -90);
  EXPECT_EQ(lettersOf(drawn(sheet + line("class='m' id='one'"))), "B");
  EXPECT_EQ(lettersOf(drawn(sheet + line("class='m' style='stroke: lime'"))), "C");
  EXPECT_EQ(lettersOf(drawn(sheet + line("class='k' style='stroke: lime'"))), "F");
  EXPECT_EQ(lettersOf(drawn(sheet + "<g>" + line("class='n'") + "</g>")), "U");
  EXPECT_EQ(lettersOf(drawn(sheet + "<g class='outer'>" + line("class='n'") + "</g>")), "J");
  EXPECT_EQ(notesWith(drawn(sheet + line("")), "2 style rules were left out"), 1U);
}

TEST(SvgReader, WhatIsHiddenIsLeftOutAndTold) {
  const PatternFile file =
      drawn(line("stroke='red'") + "<g style='display:none'>" + line("stroke='red'") +
            "</g><g visibility='hidden'>" + line("stroke='red'") +
            line("stroke='blue' visibility='visible'") + "</g>" + "<text>no</text><image/>" +
            line("stroke='none'") + "<defs>" + line("stroke='red'") + "</defs>" +
            "<clipPath id='c'>" + line("stroke='red'") + "</clipPath>");
  EXPECT_EQ(lettersOf(file), "MV");
  EXPECT_EQ(notesWith(file, "2 hidden elements"), 1U);
  EXPECT_EQ(notesWith(file, "1 text left out"), 1U);
  EXPECT_EQ(notesWith(file, "1 image left out"), 1U);
}

TEST(SvgReader, ACopyIsReadWhereItIsShown) {
  const std::string defs = "<defs><g id='a'>" + line("stroke='red'", "0 0 1 0") +
                           "</g><symbol id='s' viewBox='0 0 2 2'>" + line("", "0 0 2 2") +
                           "</symbol></defs>";
  const PatternFile file =
      drawn(defs + "<use href='#a' x='10' y='20'/><use xlink:href='#a' transform='scale(2)'/>" +
            "<use href='#s' width='8' height='4' stroke='blue'/><use href='#lost'/>");
  ASSERT_EQ(lettersOf(file), "MMV");
  EXPECT_EQ(file.drawing.lines[0].to, (Vec2{11, -20}));
  EXPECT_EQ(file.drawing.lines[1].to, (Vec2{2, 0}));
  EXPECT_EQ(file.drawing.lines[2].from, (Vec2{2, 0}));  // in the middle of the wider window
  EXPECT_EQ(file.drawing.lines[2].to, (Vec2{6, -4}));
  EXPECT_EQ(notesWith(file, "1 copy"), 1U);
}

TEST(SvgReader, CopiesOfCopiesEndInASentence) {
  std::string bomb = "<defs><g id='g0'>" + line("stroke='red'") + "</g>";
  for (int i = 0; i < 18; ++i) {
    bomb += "<g id='g" + std::to_string(i + 1) + "'>";
    for (int k = 0; k < 10; ++k) bomb += "<use href='#g" + std::to_string(i) + "'/>";
    bomb += "</g>";
  }
  const Result<PatternFile> file = readSvgPattern(svgOf(bomb + "</defs><use href='#g18'/>"), "b");
  ASSERT_FALSE(file);
  EXPECT_NE(file.error().message.find("<use>"), std::string::npos);
  // One that holds itself is followed a while, then no more.
  EXPECT_EQ(notesWith(drawn("<g id='a'>" + line("stroke='red'") + "<use href='#a'/></g>"), "copy"),
            1U);
}

TEST(SvgReader, PageSizesGiveMillimetresWhereTheyHaveAny) {
  const std::string one = line("stroke='red'");
  EXPECT_EQ(drawn(one, "width='200mm' height='100mm' viewBox='0 0 200 100'").mmPerUnit, 1);
  EXPECT_EQ(drawn(one, "width='20cm' viewBox='0 0 20 10'").mmPerUnit, 10);
  EXPECT_EQ(drawn(one, "width='2in' height='2in' viewBox='0 0 1 1'").mmPerUnit, 50.8);
  EXPECT_EQ(drawn(one, "width='720pt' viewBox='0 0 720 720'").mmPerUnit, 25.4 / 72);
  EXPECT_EQ(drawn(one, "width='10in'").mmPerUnit, 25.4 / 96);
  EXPECT_FALSE(drawn(one, "width='200px' height='100px' viewBox='0 0 200 100'").mmPerUnit);
  EXPECT_FALSE(drawn(one, "viewBox='0 0 200 100'").mmPerUnit);
  EXPECT_FALSE(drawn(one, "width='100%'").mmPerUnit);
}

TEST(SvgReader, FilledShapesSayWhereThePaperIsWhenNoLineDoes) {
  const std::string face = "<rect width='4' height='2' fill='white'/>";
  const std::string crease = line("stroke='red'", "2 0 2 2") + line("stroke='gray'", "0 1 4 1");
  const PatternFile file = drawn(face + crease);
  ASSERT_EQ(file.drawing.faces.size(), 1U);
  EXPECT_EQ(file.drawing.faces[0].size(), 4U);
  EXPECT_EQ(notesWith(file, "the paper is where"), 1U);
  const std::string border = "<rect width='4' height='2' fill='white' stroke='black'/>";
  EXPECT_TRUE(drawn(face + border + crease).drawing.faces.empty());
  EXPECT_TRUE(drawn("<rect width='100' height='100'/>" + crease).drawing.faces.empty());
}

TEST(SvgReader, RefusesWithASentenceWhatHasNoLines) {
  for (const std::string& text :
       {std::string(), std::string("hello"), std::string("<html></html>"), svgOf(""),
        svgOf("<text>only words</text>"), svgOf("<path d='M0 0' stroke='red'/>")}) {
    const Result<PatternFile> file = readSvgPattern(text, "a.svg");
    ASSERT_FALSE(file) << text;
    EXPECT_EQ(file.error().code, ErrorCode::BadFile);
    EXPECT_EQ(file.error().message.find("a.svg: "), 0U) << file.error().message;
  }
}

TEST(SvgReader, ReadsWhatComesBeforeTheDamage) {
  const PatternFile file = readDrawing("<svg>" + line("stroke='red'") + "<line x1='0' <");
  EXPECT_EQ(lettersOf(file).substr(0, 1), "M");
  EXPECT_EQ(notesWith(file, "damaged at line 1"), 1U);
}

TEST(SvgReader, WhatWasWrittenIsReadBackToTheLastBit) {
  PatternFile file;
  file.title = "a < b & \"c\"";
  file.author = "A. U. Thor";
  file.description = "two\nlines";
  file.mmPerUnit = 10;
  std::uint64_t seed = 7;
  const auto next = [&] {
    seed = seed * 6364136223846793005u + 1442695040888963407u;
    return static_cast<double>(seed >> 11) / 9007199254740992.0 * 400 - 200;
  };
  for (std::size_t i = 0; i < 700; ++i) {
    const auto assignment = static_cast<Assignment>(i / 100);
    DrawnCrease crease{{next(), next()}, {next(), i % 5 == 0 ? 0 : next()}, assignment, {}};
    const bool folds = assignment == Assignment::Mountain || assignment == Assignment::Valley;
    if (folds && i % 3 != 0) {
      crease.angle = (assignment == Assignment::Mountain ? -0.9 : 0.9) * std::fabs(next());
    }
    file.drawing.lines.push_back(crease);
  }
  const WrittenPattern written = writeSvgDrawing(file);
  EXPECT_TRUE(written.losses.empty());
  PatternFile back = readDrawing(written.text);
  EXPECT_TRUE(back.notes.empty()) << back.notes.front();
  EXPECT_EQ(back.title, file.title);
  EXPECT_EQ(back.author, file.author);
  EXPECT_EQ(back.description, file.description);
  EXPECT_EQ(back.mmPerUnit, file.mmPerUnit);
  ASSERT_EQ(back.drawing.lines.size(), file.drawing.lines.size());
  // The groups have another order than the letters; within each the order is kept.
  const auto byAssignment = [](const DrawnCrease& a, const DrawnCrease& b) {
    return a.assignment < b.assignment;
  };
  std::stable_sort(back.drawing.lines.begin(), back.drawing.lines.end(), byAssignment);
  EXPECT_TRUE(back.drawing.lines == file.drawing.lines);
}

TEST(SvgReader, ShowsTheFrontAsTheScreenDoes) {
  // An L of creases on the screen: from the corner up and to the right. Seen from the front with y
  // up it must turn the same way, and the mountain stay the mountain.
  const PatternFile file =
      drawn("<path d='M0 10V0' stroke='red'/><path d='M0 10H5' stroke='blue'/>");
  ASSERT_EQ(lettersOf(file), "MV");
  const Vec2 up = file.drawing.lines[0].to - file.drawing.lines[0].from;
  const Vec2 right = file.drawing.lines[1].to - file.drawing.lines[1].from;
  EXPECT_GT(up.y, 0);
  EXPECT_GT(right.x, 0);
  EXPECT_LT(cross(up, right), 0);
}

TEST(SvgWriter, ListsWhatItCannotHold) {
  PatternFile file;
  file.drawing.lines.push_back({{0, 0}, {1, 0}, Assignment::Mountain, {}});
  file.drawing.orders.push_back({{0, 0}, {1, 1}, true});
  file.drawing.faces.push_back({{0, 0}, {1, 0}, {0, 1}});
  file.unknown = "{}";
  EXPECT_EQ(writeSvgDrawing(file).losses.size(), 3U);
}

}  // namespace
}  // namespace kiri
