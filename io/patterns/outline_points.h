// Outlines as lists of points: what programs for shape analysis write (Momocs, ImageJ, R, tables).
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/base/vec.h"

namespace kiri {

struct OutlinePoints {
  std::vector<Vec2> points;  ///< in the units of the file, y up; no two in a row are alike
  std::vector<std::string> notes;
};

/// Whether the name ends in .csv, .txt, .tsv, .dat or .xy.
bool isNamedLikePoints(std::string_view fileName);

/// One point a line: two numbers apart by a comma, a semicolon, blanks or a tab. A line of names
/// may come first; where it names columns x and y, those are read, else the first two. With
/// semicolons between the numbers a comma is a decimal point. Empty lines and lines that begin with
/// # are left out. The last point may repeat the first. Errors: BadFile - with the line, what is
/// wrong there and what is expected; fewer than three points; too many.
Result<OutlinePoints> readOutlinePoints(std::string_view text, std::string_view fileName);

}  // namespace kiri
