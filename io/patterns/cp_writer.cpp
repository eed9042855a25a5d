// Writing .cp files (docs/formats/cp.md).
// SPDX-License-Identifier: MIT
#include "io/json_tree.h"
#include "io/patterns/cp_format.h"
#include "io/patterns/losses.h"

namespace kiri {

namespace {

char typeOfCpLine(Assignment assignment) {
  switch (assignment) {
    case Assignment::Border:
    case Assignment::Cut:
      return '1';
    case Assignment::Mountain:
      return '2';
    case Assignment::Valley:
      return '3';
    case Assignment::Flat:
    case Assignment::Join:
      return '4';
    case Assignment::Unassigned:
      break;
  }
  return '0';
}

}  // namespace

WrittenPattern writeCpPattern(const PatternFile& file) {
  WrittenPattern out;
  FormatRoom room;
  room.name = ".cp";
  room.hasFlat = room.hasUnassigned = true;
  out.losses = lossesOf(file, room);
  bool isOpen = false;
  for (const DrawnCrease& line : file.drawing.lines) {
    isOpen = isOpen || line.assignment == Assignment::Unassigned;
    out.text += typeOfCpLine(line.assignment);
    for (const double number : {line.from.x, 0 - line.from.y, line.to.x, 0 - line.to.y}) {
      out.text += ' ' + numberText(number);
    }
    out.text += '\n';
  }
  if (isOpen) {
    out.losses.emplace_back(
        ".cp: unassigned creases have type 0, which Oriedita and ORIPA read as auxiliary lines");
  }
  return out;
}

}  // namespace kiri
