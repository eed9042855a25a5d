// Patterns that tests of the formats share.
// SPDX-License-Identifier: MIT
#pragma once

#include <random>
#include <string>
#include <vector>

#include "io/patterns/pattern_file.h"

namespace kiri::test {

/// True when a note holds the words.
inline bool patternTells(const PatternFile& file, const std::string& words) {
  for (const std::string& note : file.notes) {
    if (note.find(words) != std::string::npos) return true;
  }
  return false;
}

inline const std::vector<PatternFormat>& allPatternFormats() {
  static const std::vector<PatternFormat> kAll = {PatternFormat::Fold, PatternFormat::Cp,
                                                  PatternFormat::Opx, PatternFormat::Svg,
                                                  PatternFormat::Dxf};
  return kAll;
}

inline std::string nameOfFormat(PatternFormat format) {
  switch (format) {
    case PatternFormat::Fold:
      return "a.fold";
    case PatternFormat::Cp:
      return "a.cp";
    case PatternFormat::Opx:
      return "a.opx";
    case PatternFormat::Svg:
      return "a.svg";
    case PatternFormat::Dxf:
      break;
  }
  return "a.dxf";
}

/// A square with every kind of line, angles, orders and texts.
inline PatternFile fileWithEverythingDrawn() {
  PatternFile file;
  file.title = "title";
  file.author = "author";
  file.description = "description";
  file.mmPerUnit = 10;
  file.unknown = R"({"other:key": [1, {"a": null}]})";
  CreaseDrawing& d = file.drawing;
  d.lines = {
      {{0, 0}, {2, 0}, Assignment::Border, {}},       {{2, 0}, {4, 0}, Assignment::Border, {}},
      {{4, 0}, {4, 4}, Assignment::Border, {}},       {{4, 4}, {2, 4}, Assignment::Border, {}},
      {{2, 4}, {0, 4}, Assignment::Border, {}},       {{0, 4}, {0, 0}, Assignment::Border, {}},
      {{2, 0}, {2, 1}, Assignment::Mountain, -30.25}, {{2, 1}, {2, 4}, Assignment::Valley, {}},
      {{0, 0}, {2, 1}, Assignment::Unassigned, {}},   {{4, 4}, {2, 1}, Assignment::Flat, {}},
      {{4, 0}, {2, 1}, Assignment::Cut, {}},          {{0, 4}, {2, 1}, Assignment::Join, {}}};
  d.orders = {{{3, 0.25}, {1, 0.1}, true}, {{1, 3.5}, {3, 3.5}, false}};
  return file;
}

/// Lines between random points, with every kind and random angles where those mean something.
inline PatternFile randomPatternFile(std::mt19937_64& random) {
  std::uniform_real_distribution<double> place(-200, 200);
  PatternFile file;
  const std::uint64_t count = 1 + random() % 30;
  std::vector<Vec2> points;
  for (std::uint64_t i = 0; i < count + 2; ++i) {
    points.push_back(random() % 4 == 0 ? Vec2{static_cast<double>(random() % 9) * 25 - 100, 0}
                                       : Vec2{place(random), place(random)});
  }
  for (std::uint64_t i = 0; i < count; ++i) {
    DrawnCrease line{points[random() % points.size()], points[random() % points.size()],
                     static_cast<Assignment>(random() % 7), std::nullopt};
    if (line.from == line.to) continue;
    const double angle = std::uniform_real_distribution<double>(0, 180)(random);
    if (line.assignment == Assignment::Mountain && random() % 3 == 0) line.angle = -angle;
    if (line.assignment == Assignment::Valley && random() % 3 == 0) line.angle = angle;
    file.drawing.lines.push_back(line);
  }
  if (file.drawing.lines.empty())
    file.drawing.lines.push_back({{0, 0}, {1, 2}, Assignment::Border, {}});
  return file;
}

}  // namespace kiri::test
