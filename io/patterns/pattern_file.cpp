// Crease patterns of other programs: which format a file has, and who reads and writes it.
// SPDX-License-Identifier: MIT
#include "io/patterns/pattern_file.h"

#include <algorithm>
#include <array>
#include <utility>

#include "io/patterns/cp_format.h"
#include "io/patterns/dxf_format.h"
#include "io/patterns/fold_pattern_writer.h"
#include "io/patterns/fold_reader.h"
#include "io/patterns/opx_format.h"
#include "io/patterns/svg_reader.h"
#include "io/patterns/svg_writer.h"
#include "io/patterns/text_lines.h"

namespace kiri {

namespace {

constexpr std::size_t kMostPatternBytes = std::size_t{64} << 20;

/// The ending of a file's name in small letters, without the point; empty when there is none.
std::string endingOf(std::string_view fileName) {
  const std::size_t slash = fileName.find_last_of("/\\");
  if (slash != std::string_view::npos) fileName.remove_prefix(slash + 1);
  const std::size_t point = fileName.rfind('.');
  if (point == std::string_view::npos) return "";
  std::string out(fileName.substr(point + 1));
  for (char& c : out) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  return out;
}

Error unreadable(std::string_view fileName, const std::string& sentence) {
  return {ErrorCode::BadFile, std::string(fileName) + ": " + sentence};
}

/// What to say of a text that looks like no pattern.
Error noPattern(std::string_view fileName) {
  const std::string ending = endingOf(fileName);
  if (ending == "ori" || ending == "orh") {
    return unreadable(fileName,
                      "the own files of Oriedita and Orihime are not read; export the pattern as "
                      "FOLD or .cp there");
  }
  return unreadable(fileName,
                    "this is no crease pattern that is known here; FOLD, .cp, .opx, SVG and DXF "
                    "files are read");
}

Result<PatternFile> readAs(PatternFormat format, std::string_view text, std::string_view fileName) {
  switch (format) {
    case PatternFormat::Fold:
      return readFoldPattern(text, fileName);
    case PatternFormat::Cp:
      return readCpPattern(text, fileName);
    case PatternFormat::Opx:
      return readOpxPattern(text, fileName);
    case PatternFormat::Svg:
      return readSvgPattern(text, fileName);
    case PatternFormat::Dxf:
      break;
  }
  return readDxfPattern(text, fileName);
}

bool contains(std::string_view text, std::string_view word) {
  return text.find(word) != std::string_view::npos;
}

}  // namespace

std::optional<PatternFormat> patternFormatOf(std::string_view fileName) {
  const std::string ending = endingOf(fileName);
  if (ending == "fold") return PatternFormat::Fold;
  if (ending == "cp") return PatternFormat::Cp;
  if (ending == "opx") return PatternFormat::Opx;
  if (ending == "svg") return PatternFormat::Svg;
  if (ending == "dxf") return PatternFormat::Dxf;
  return std::nullopt;
}

std::optional<PatternFormat> sniffedFormat(std::string_view text) {
  constexpr std::size_t kStart = 4096;
  text = withoutMark(text);
  if (text.substr(0, 18) == "AutoCAD Binary DXF") return PatternFormat::Dxf;
  const std::string_view start = trimmed(text.substr(0, kStart));
  if (start.empty()) return std::nullopt;
  if (start.front() == '{') {
    const bool isFold = contains(text, "\"edges_") || contains(text, "\"faces_") ||
                        contains(text, "\"vertices_") || contains(text, "\"file_spec\"");
    return isFold ? std::optional(PatternFormat::Fold) : std::nullopt;
  }
  if (start.front() == '<') {
    if (contains(start, "java.beans") || contains(start, "oripa.")) return PatternFormat::Opx;
    const bool isSvg = contains(start, "<svg") || contains(start, ":svg") || contains(text, "<svg");
    return isSvg ? std::optional(PatternFormat::Svg) : std::nullopt;
  }
  TextLines lines(start);
  const std::string_view first = trimmed(lines.next().value_or(""));
  const std::string_view second = trimmed(lines.next().value_or(""));
  if (first == "999" || (first == "0" && second == "SECTION")) return PatternFormat::Dxf;
  if (looksLikeCp(start)) return PatternFormat::Cp;
  return std::nullopt;
}

Result<PatternFile> readPattern(std::string_view text, std::string_view fileName) {
  if (text.size() > kMostPatternBytes) {
    return unreadable(fileName, "the file has " + std::to_string(text.size() >> 20) +
                                    " MB, at most " + std::to_string(kMostPatternBytes >> 20) +
                                    " MB are read; is this the right file?");
  }
  if (trimmed(withoutMark(text)).empty()) return unreadable(fileName, "the file is empty");
  std::optional<PatternFormat> format = patternFormatOf(fileName);
  if (!format) format = sniffedFormat(text);
  if (!format) return noPattern(fileName);
  return readAs(*format, text, fileName);
}

WrittenPattern writePattern(const PatternFile& file, PatternFormat format) {
  switch (format) {
    case PatternFormat::Fold:
      return writeFoldPattern(file);
    case PatternFormat::Cp:
      return writeCpPattern(file);
    case PatternFormat::Opx:
      return writeOpxPattern(file);
    case PatternFormat::Svg:
      return writeSvgDrawing(file);
    case PatternFormat::Dxf:
      break;
  }
  return writeDxfPattern(file);
}

}  // namespace kiri
