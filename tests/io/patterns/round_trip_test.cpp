// Each format through each other: geometry to the last bit, and no loss that is not told.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <string>
#include <tuple>
#include <vector>

#include "io/patterns/pattern_file.h"
#include "tests/io/patterns/pattern_texts.h"

namespace kiri {
namespace {

using test::allPatternFormats;
using test::nameOfFormat;

bool isHeld(PatternFormat format, Assignment assignment) {
  const bool isOwn = assignment == Assignment::Cut || assignment == Assignment::Join;
  return !isOwn || (format != PatternFormat::Cp && format != PatternFormat::Opx);
}

bool holdsAngles(PatternFormat format) {
  return format == PatternFormat::Fold || format == PatternFormat::Svg;
}

Assignment afterwards(PatternFormat format, Assignment assignment) {
  if (isHeld(format, assignment)) return assignment;
  return assignment == Assignment::Cut ? Assignment::Border : Assignment::Flat;
}

double angleMeant(const DrawnCrease& line) {
  if (line.angle) return *line.angle;
  if (line.assignment == Assignment::Valley) return 180;
  return line.assignment == Assignment::Mountain ? -180 : 0;
}

bool isLost(const WrittenPattern& written, const std::string& word) {
  for (const std::string& loss : written.losses) {
    if (loss.find(word) != std::string::npos) return true;
  }
  return false;
}

/// Lines in an order of their own: SVG groups them by what they mean.
std::vector<DrawnCrease> sortedLines(const PatternFile& file, PatternFormat format) {
  std::vector<DrawnCrease> out = file.drawing.lines;
  const auto key = [&](const DrawnCrease& line) {
    return std::tuple(line.from.x, line.from.y, line.to.x, line.to.y,
                      afterwards(format, line.assignment), angleMeant(line));
  };
  std::sort(out.begin(), out.end(),
            [&](const DrawnCrease& a, const DrawnCrease& b) { return key(a) < key(b); });
  return out;
}

/// Holds when `after` is `before` as that format keeps it.
void expectKept(const PatternFile& before, const PatternFile& after, PatternFormat format,
                const WrittenPattern& written) {
  ASSERT_EQ(after.drawing.lines.size(), before.drawing.lines.size());
  const std::vector<DrawnCrease> linesBefore = sortedLines(before, format);
  const std::vector<DrawnCrease> linesAfter = sortedLines(after, format);
  for (std::size_t i = 0; i < linesBefore.size(); ++i) {
    const DrawnCrease& was = linesBefore[i];
    const DrawnCrease& is = linesAfter[i];
    EXPECT_EQ(is.from, was.from);
    EXPECT_EQ(is.to, was.to);
    EXPECT_EQ(is.assignment, afterwards(format, was.assignment));
    if (!isHeld(format, was.assignment)) {
      EXPECT_TRUE(isLost(written, was.assignment == Assignment::Cut ? "cut" : "join"));
    }
    if (was.assignment == Assignment::Unassigned) continue;
    if (angleMeant(is) != angleMeant(was)) {
      EXPECT_FALSE(holdsAngles(format));
      EXPECT_TRUE(isLost(written, "angle"));
    }
  }
}

TEST(PatternRoundTrips, EveryFormatKeepsRandomDrawingsThroughEveryOther) {
  std::mt19937_64 random(11);
  for (int i = 0; i < 40; ++i) {
    const PatternFile first = test::randomPatternFile(random);
    for (const PatternFormat a : allPatternFormats()) {
      const WrittenPattern inA = writePattern(first, a);
      const Result<PatternFile> second = readPattern(inA.text, nameOfFormat(a));
      ASSERT_TRUE(second.isOk()) << second.error().message;
      EXPECT_EQ(second->format, a);
      expectKept(first, *second, a, inA);
      for (const PatternFormat b : allPatternFormats()) {
        const WrittenPattern inB = writePattern(*second, b);
        const Result<PatternFile> third = readPattern(inB.text, nameOfFormat(b));
        ASSERT_TRUE(third.isOk()) << third.error().message;
        expectKept(*second, *third, b, inB);
        ASSERT_FALSE(HasFailure()) << "drawing " << i << "\n" << inA.text << "\n" << inB.text;
      }
    }
  }
}

TEST(PatternRoundTrips, FoldKeepsEverything) {
  const PatternFile file = test::fileWithEverythingDrawn();
  const WrittenPattern written = writePattern(file, PatternFormat::Fold);
  EXPECT_TRUE(written.losses.empty()) << written.losses.front();
  const Result<PatternFile> again = readPattern(written.text, "a.fold");
  ASSERT_TRUE(again.isOk()) << again.error().message;
  EXPECT_EQ(again->title, file.title);
  EXPECT_EQ(again->author, file.author);
  EXPECT_EQ(again->description, file.description);
  EXPECT_EQ(again->mmPerUnit, file.mmPerUnit);
  EXPECT_EQ(again->unknown, file.unknown);
  EXPECT_EQ(again->drawing.faces.size(), 6u);
  ASSERT_EQ(again->drawing.orders.size(), 2u);
  EXPECT_TRUE(again->drawing.orders[0].isFront);
  EXPECT_FALSE(again->drawing.orders[1].isFront);
  EXPECT_EQ(writePattern(*again, PatternFormat::Fold).text, written.text);
}

TEST(PatternRoundTrips, EveryFormatIsRecognisedByItsTextAlone) {
  const PatternFile file = test::fileWithEverythingDrawn();
  for (const PatternFormat format : allPatternFormats()) {
    const WrittenPattern written = writePattern(file, format);
    EXPECT_EQ(sniffedFormat(written.text), format) << nameOfFormat(format);
    EXPECT_EQ(patternFormatOf("x/Y." + nameOfFormat(format)), format);
    EXPECT_TRUE(readPattern(written.text, "clipboard").isOk());
  }
}

TEST(PatternRoundTrips, FacesOfADrawingThatNeedsRepairsAreLeftOutAndThatIsTold) {
  PatternFile file;
  file.drawing.lines = {
      {{0, 0}, {2, 0}, Assignment::Border, {}},   {{2, 0}, {2, 2}, Assignment::Border, {}},
      {{2, 2}, {0, 2}, Assignment::Border, {}},   {{0, 2}, {0, 0}, Assignment::Border, {}},
      {{0, 0}, {2, 2}, Assignment::Mountain, {}}, {{0, 2}, {2, 0}, Assignment::Valley, {}}};
  const WrittenPattern written = writePattern(file, PatternFormat::Fold);
  EXPECT_TRUE(isLost(written, "faces of the pattern were left out"));
  EXPECT_EQ(written.text.find("faces_vertices"), std::string::npos);
}

TEST(PatternRoundTrips, AUnitThatFoldHasNoNameForComesBack) {
  PatternFile file = test::fileWithEverythingDrawn();
  file.mmPerUnit = 25.4 / 96;
  const Result<PatternFile> again =
      readPattern(writePattern(file, PatternFormat::Fold).text, "a.fold");
  ASSERT_TRUE(again.isOk());
  EXPECT_EQ(again->mmPerUnit, file.mmPerUnit);
}

}  // namespace
}  // namespace kiri
