// Crease patterns in the formats of other programs: what a file holds, in one shape for all.
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/creases/crease_drawing.h"

namespace kiri {

enum class PatternFormat { Fold, Cp, Opx, Svg, Dxf };

/// What a file holds. Coordinates are in the paper frame (y up, seen from the front): files whose y
/// points down are mirrored by the reader, which keeps mountains mountains as their programs show
/// them (guide: handedness).
struct PatternFile {
  PatternFormat format = PatternFormat::Fold;
  CreaseDrawing drawing;
  std::string title;
  std::string author;
  std::string description;
  /// 1 for mm, 10 for cm, 25.4 for inches; none: the file's unit has no size.
  std::optional<double> mmPerUnit;
  std::string
      unknown;  ///< FOLD: keys of others of the whole file, as JSON text, kept for the writer
  std::vector<std::string> notes;  ///< sentences: what was ignored or guessed, with counts
};

/// The pattern in `text`. The format follows from the ending of `fileName`, or, where that says
/// nothing, from what the text looks like. Never throws, whatever the bytes. Errors: BadFile - with
/// file, place and remedy; a file that can be used in part is used, and notes say what was left
/// out.
Result<PatternFile> readPattern(std::string_view text, std::string_view fileName);

/// The format that a name's ending means.
std::optional<PatternFormat> patternFormatOf(std::string_view fileName);
/// The format that the text looks like; none when it looks like no pattern at all.
std::optional<PatternFormat> sniffedFormat(std::string_view text);

/// A pattern as text in one format, and sentences about what the format cannot hold.
struct WrittenPattern {
  std::string text;
  std::vector<std::string> losses;
};
/// Writes what `file` holds in another format: coordinates to the last bit where the format has
/// decimals for it. Angles other than 180 degrees, cuts, joins, orders, texts are listed where they
/// cannot be held. A FOLD file written gets faces and the keys of others back.
WrittenPattern writePattern(const PatternFile& file, PatternFormat format);

}  // namespace kiri
