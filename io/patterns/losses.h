// What a pattern would lose in a format, said before it is written.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "io/patterns/pattern_file.h"

namespace kiri {

/// What a format has room for, beside lines, borders, mountains and valleys.
struct FormatRoom {
  std::string name;  ///< as it stands in sentences: ".cp"
  bool hasAngles = false;
  bool hasFlat = false;
  bool hasUnassigned = false;
  bool hasCuts = false;
  bool hasJoins = false;
  bool hasFaces = false;
  bool hasOrders = false;
  bool hasTitle = false;
  bool hasAuthor = false;
  bool hasDescription = false;
  bool hasUnit = false;
  bool hasKeys = false;  ///< keys of other programs
  std::string cutsBecome = "borders";
  std::string joinsBecome = "auxiliary lines";
};

/// A sentence for each kind of thing that is in the file and has no room, with its count.
std::vector<std::string> lossesOf(const PatternFile& file, const FormatRoom& room);

}  // namespace kiri
