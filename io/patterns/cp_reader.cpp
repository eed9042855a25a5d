// Reading .cp files (docs/formats/cp.md).
// SPDX-License-Identifier: MIT
#include <array>
#include <optional>
#include <string>

#include "io/patterns/cp_format.h"
#include "io/patterns/plain_number.h"
#include "io/patterns/tally.h"
#include "io/patterns/text_lines.h"

namespace kiri {

namespace {

/// type x1 y1 x2 y2; none when the line is something else.
std::optional<std::array<double, 5>> fieldsOf(std::string_view line) {
  std::array<double, 5> out{};
  for (double& field : out) {
    line = trimmed(line);
    const std::optional<double> value = takeNumber(line);
    const bool isWhole = line.empty() || isBlankOrComma(line.front());
    if (!value || !isWhole || !isDrawable(*value)) return std::nullopt;
    if (!line.empty() && line.front() == ',') line.remove_prefix(1);
    field = *value;
  }
  return trimmed(line).empty() ? std::optional(out) : std::nullopt;
}

/// The assignment of a type; none for types that nobody knows.
std::optional<Assignment> assignmentOfType(double type) {
  if (type == 0) return Assignment::Unassigned;
  if (type == 1) return Assignment::Border;
  if (type == 2) return Assignment::Mountain;
  if (type == 3) return Assignment::Valley;
  if (type == 4) return Assignment::Flat;
  return std::nullopt;
}

}  // namespace

Result<PatternFile> readCpPattern(std::string_view text, std::string_view fileName) {
  PatternFile file;
  file.format = PatternFormat::Cp;
  Tally bad;
  Tally strange;
  TextLines lines(text);
  while (const std::optional<std::string_view> line = lines.next()) {
    if (trimmed(*line).empty()) continue;
    const std::optional<std::array<double, 5>> fields = fieldsOf(*line);
    if (!fields) {
      bad.add(lines.number());
      continue;
    }
    const auto [type, x1, y1, x2, y2] = *fields;
    const std::optional<Assignment> assignment = assignmentOfType(type);
    if (!assignment) strange.add(lines.number());
    // y points down in the file. From zero, so that 0 does not become -0.
    file.drawing.lines.push_back(
        {{x1, 0 - y1}, {x2, 0 - y2}, assignment.value_or(Assignment::Flat), std::nullopt});
  }
  if (file.drawing.lines.empty()) {
    return Error{ErrorCode::BadFile,
                 std::string(fileName) +
                     ": no line of the file is one of a .cp file (type x1 y1 x2 y2, five numbers "
                     "with spaces between); is this the right file?"};
  }
  bad.tell(file.notes, "line of the file", "lines of the file",
           "not of the form type x1 y1 x2 y2; left out");
  strange.tell(file.notes, "line of the file", "lines of the file",
               "of a type that is none of 0 to 4; taken as auxiliary");
  return file;
}

bool looksLikeCp(std::string_view text) {
  constexpr int kLinesToLookAt = 20;
  TextLines lines(text);
  for (int i = 0; i < kLinesToLookAt; ++i) {
    const std::optional<std::string_view> line = lines.next();
    if (!line) return false;
    if (const auto fields = fieldsOf(*line); fields && assignmentOfType((*fields)[0])) return true;
  }
  return false;
}

}  // namespace kiri
