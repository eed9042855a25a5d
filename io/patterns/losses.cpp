// What a pattern would lose in a format, said before it is written.
// SPDX-License-Identifier: MIT
#include "io/patterns/losses.h"

#include <algorithm>
#include <cmath>

namespace kiri {

namespace {

/// True when the angle says something that the assignment does not.
bool hasOwnAngle(const DrawnCrease& line) {
  constexpr double kFull = 180;
  const bool canFold = line.assignment == Assignment::Mountain ||
                       line.assignment == Assignment::Valley ||
                       line.assignment == Assignment::Unassigned;
  return canFold && line.angle && std::abs(*line.angle) != kFull;
}

std::string countedThings(std::size_t count, const std::string& one, const std::string& many) {
  return std::to_string(count) + " " + (count == 1 ? one : many);
}

}  // namespace

std::vector<std::string> lossesOf(const PatternFile& file, const FormatRoom& room) {
  const std::vector<DrawnCrease>& lines = file.drawing.lines;
  std::vector<std::string> out;
  const auto countOf = [&](Assignment assignment) {
    return static_cast<std::size_t>(
        std::count_if(lines.begin(), lines.end(),
                      [&](const DrawnCrease& line) { return line.assignment == assignment; }));
  };
  const auto lose = [&](bool hasRoom, std::size_t count, const std::string& what,
                        const std::string& many, const std::string& became) {
    if (hasRoom || count == 0) return;
    out.push_back(room.name + " has no " + many + ": " + countedThings(count, what, many) + " " +
                  became);
  };
  const auto angled =
      static_cast<std::size_t>(std::count_if(lines.begin(), lines.end(), hasOwnAngle));
  lose(room.hasAngles, angled, "fold angle", "fold angles", "other than 180 degrees left out");
  lose(room.hasFlat, countOf(Assignment::Flat), "flat crease", "flat creases", "left out");
  lose(room.hasUnassigned, countOf(Assignment::Unassigned), "unassigned crease",
       "unassigned creases", "became auxiliary lines");
  lose(room.hasCuts, countOf(Assignment::Cut), "cut", "cuts", "became " + room.cutsBecome);
  lose(room.hasJoins, countOf(Assignment::Join), "join", "joins", "became " + room.joinsBecome);
  const bool isFacesNeeded = countOf(Assignment::Border) == 0;
  lose(room.hasFaces || !isFacesNeeded, file.drawing.faces.size(), "face", "faces",
       "left out, and no line is a border: the outline will be guessed");
  lose(room.hasOrders, file.drawing.orders.size(), "layer order", "layer orders", "left out");
  const auto loseText = [&](bool hasRoom, const std::string& text, const std::string& what) {
    if (!hasRoom && !text.empty()) out.push_back(room.name + " has no " + what + ": left out");
  };
  loseText(room.hasTitle, file.title, "title");
  loseText(room.hasAuthor, file.author, "author");
  loseText(room.hasDescription, file.description, "description");
  loseText(room.hasKeys, file.unknown, "keys of other programs (FOLD)");
  if (!room.hasUnit && file.mmPerUnit) {
    out.push_back(room.name + " has no unit of length: the true size was left out");
  }
  return out;
}

}  // namespace kiri
