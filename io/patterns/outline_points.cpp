// Reads points line by line; what stands in other columns is let be.
// SPDX-License-Identifier: MIT
#include "io/patterns/outline_points.h"

#include <algorithm>
#include <cctype>
#include <optional>

#include "io/patterns/plain_number.h"
#include "io/patterns/text_lines.h"

namespace kiri {
namespace {

constexpr std::size_t kMostPoints = 100'000;

using Fields = std::vector<std::string>;

std::string lowered(std::string_view text) {
  std::string out(text);
  std::transform(out.begin(), out.end(), out.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return out;
}

std::string_view unquoted(std::string_view text) {
  const bool isQuoted = text.size() >= 2 && text.front() == '"' && text.back() == '"';
  return isQuoted ? text.substr(1, text.size() - 2) : text;
}

/// Fields between separators; blanks that stand together count once.
Fields fieldsOfPoint(std::string_view line) {
  const char mark = line.find(';') != std::string_view::npos    ? ';'
                    : line.find('\t') != std::string_view::npos ? '\t'
                    : line.find(',') != std::string_view::npos  ? ','
                                                                : ' ';
  Fields fields;
  for (line = trimmed(line); !line.empty();) {
    const std::size_t end = std::min(line.find(mark), line.size());
    std::string field(unquoted(trimmed(line.substr(0, end))));
    if (mark == ';') std::replace(field.begin(), field.end(), ',', '.');
    fields.push_back(std::move(field));
    line.remove_prefix(std::min(end + 1, line.size()));
    if (mark == ' ') line = trimmed(line);
  }
  return fields;
}

/// Where x and y stand.
struct Columns {
  std::size_t x = 0;
  std::size_t y = 1;
  std::size_t count = 0;  ///< of the names; 0: there were none
};

Columns columnsOf(const Fields& names) {
  Columns columns;
  columns.count = names.size();
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (lowered(names[i]) == "x") columns.x = i;
    if (lowered(names[i]) == "y") columns.y = i;
  }
  return columns;
}

std::optional<Vec2> pointFrom(const Fields& fields, const Columns& columns) {
  // Tables of R have one field more in the rows than in the names: that of the row.
  const std::size_t shift = columns.count > 0 && fields.size() == columns.count + 1 ? 1 : 0;
  if (std::max(columns.x, columns.y) + shift >= fields.size()) return std::nullopt;
  const auto x = numberOf(fields[columns.x + shift]);
  const auto y = numberOf(fields[columns.y + shift]);
  if (!x || !y || !isDrawable(*x) || !isDrawable(*y)) return std::nullopt;
  return Vec2{*x, *y};
}

bool hasNumber(const Fields& fields) {
  return std::any_of(fields.begin(), fields.end(),
                     [](const std::string& field) { return numberOf(field).has_value(); });
}

std::string shortened(std::string_view line) {
  constexpr std::size_t kShown = 40;
  return line.size() <= kShown ? std::string(line) : std::string(line.substr(0, kShown)) + "...";
}

Error badLine(std::string_view fileName, std::size_t number, std::string_view line) {
  return {ErrorCode::BadFile, std::string(fileName) + " line " + std::to_string(number) + ": \"" +
                                  shortened(trimmed(line)) +
                                  "\" is no point; each line of an outline holds two numbers, x "
                                  "and y, and the first line may name the columns"};
}

/// Points that repeat the one before, or the last the first.
void dropRepeated(OutlinePoints& out) {
  const std::size_t before = out.points.size();
  out.points.erase(std::unique(out.points.begin(), out.points.end()), out.points.end());
  while (out.points.size() > 1 && out.points.back() == out.points.front()) out.points.pop_back();
  const std::size_t dropped = before - out.points.size();
  if (dropped > 1) {
    out.notes.push_back(std::to_string(dropped) + " points that repeat their neighbour left out");
  }
}

}  // namespace

bool isNamedLikePoints(std::string_view fileName) {
  const std::size_t dot = fileName.rfind('.');
  if (dot == std::string_view::npos) return false;
  const std::string ending = lowered(fileName.substr(dot));
  return ending == ".csv" || ending == ".txt" || ending == ".tsv" || ending == ".dat" ||
         ending == ".xy";
}

Result<OutlinePoints> readOutlinePoints(std::string_view text, std::string_view fileName) {
  OutlinePoints out;
  Columns columns;
  TextLines lines(text);
  while (const std::optional<std::string_view> line = lines.next()) {
    const std::string_view content = trimmed(*line);
    if (content.empty() || content.front() == '#') continue;
    const Fields fields = fieldsOfPoint(content);
    if (out.points.empty() && columns.count == 0 && !hasNumber(fields)) {
      columns = columnsOf(fields);
      continue;
    }
    const std::optional<Vec2> point = pointFrom(fields, columns);
    if (!point) return badLine(fileName, lines.number(), *line);
    if (out.points.size() == kMostPoints) {
      return Error{ErrorCode::BadFile, std::string(fileName) + " holds more than " +
                                           std::to_string(kMostPoints) +
                                           " points; thin the outline out first"};
    }
    out.points.push_back(*point);
  }
  dropRepeated(out);
  if (out.points.size() >= 3) return out;
  return Error{ErrorCode::BadFile,
               std::string(fileName) + " holds " + std::to_string(out.points.size()) +
                   " different points; an outline takes three or more, one a line: x and y"};
}

}  // namespace kiri
