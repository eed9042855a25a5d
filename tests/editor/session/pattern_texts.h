// Crease patterns of our own making, as the files that a person opens or pastes.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace kiri::test {

/// A sheet of 100 mm folded like a map into four; nobody said which way: 8 states.
inline constexpr const char* kMap = R"({
  "file_spec": 1.1, "frame_title": "Map", "frame_unit": "mm",
  "vertices_coords": [[0,0],[50,0],[100,0],[0,50],[50,50],[100,50],[0,100],[50,100],[100,100]],
  "edges_vertices": [[0,1],[1,2],[2,5],[5,8],[8,7],[7,6],[6,3],[3,0],[1,4],[4,7],[3,4],[4,5]],
  "edges_assignment": ["B","B","B","B","B","B","B","B","U","U","U","U"]})";

/// A strip of three, folded like a letter Z: one state.
inline constexpr const char* kAccordion = R"({
  "file_spec": 1.1, "frame_title": "Accordion", "frame_unit": "mm",
  "vertices_coords": [[0,0],[40,0],[80,0],[120,0],[120,40],[80,40],[40,40],[0,40]],
  "edges_vertices": [[0,1],[1,2],[2,3],[3,4],[4,5],[5,6],[6,7],[7,0],[1,6],[2,5]],
  "edges_assignment": ["B","B","B","B","B","B","B","B","M","V"]})";

/// Four creases that miss Kawasaki's rule in the middle of the sheet.
inline constexpr const char* kBroken = R"({
  "file_spec": 1.1, "frame_title": "Broken", "frame_unit": "mm",
  "vertices_coords": [[0,0],[70,0],[100,0],[100,50],[100,100],[50,100],[0,100],[0,50],[50,50]],
  "edges_vertices": [[0,1],[1,2],[2,3],[3,4],[4,5],[5,6],[6,7],[7,0],[8,1],[8,3],[8,5],[8,7]],
  "edges_assignment": ["B","B","B","B","B","B","B","B","M","V","V","V"]})";

/// The map again, its two lines drawn across each other without a vertex.
inline constexpr const char* kCrossing = R"({
  "file_spec": 1.1, "frame_title": "Crossing", "frame_unit": "mm",
  "vertices_coords": [[0,0],[50,0],[100,0],[100,50],[100,100],[50,100],[0,100],[0,50]],
  "edges_vertices": [[0,1],[1,2],[2,3],[3,4],[4,5],[5,6],[6,7],[7,0],[1,5],[3,7]],
  "edges_assignment": ["B","B","B","B","B","B","B","B","U","U"]})";

/// A preliminary base: what a crane begins with.
inline constexpr const char* kPreliminaryBase = R"({
  "file_spec": 1.1, "frame_title": "Preliminary base", "frame_unit": "mm",
  "vertices_coords": [[0,0],[50,0],[100,0],[100,50],[100,100],[50,100],[0,100],[0,50],[50,50]],
  "edges_vertices": [[0,1],[1,2],[2,3],[3,4],[4,5],[5,6],[6,7],[7,0],
                     [8,0],[8,2],[8,4],[8,6],[8,1],[8,3],[8,5],[8,7]],
  "edges_assignment": ["B","B","B","B","B","B","B","B","F","M","F","M","V","V","V","V"]})";

/// A grid of columns x rows facets as a FOLD file in mm. `shift`: mm by which every second row of
/// vertices is moved to the right. Assignments as Miura's: with a shift it folds flat in one way;
/// `isOpen`: nobody said which way.
inline std::string gridText(int columns, int rows, double width, double shift, bool isOpen) {
  std::string points;
  std::string edges;
  std::string assignments;
  const auto at = [columns](int i, int j) { return std::to_string(j * (columns + 1) + i); };
  const auto add = [&](int i, int j, int k, int l, const char* assignment) {
    const std::string comma = edges.empty() ? "" : ",";
    edges += comma + "[" + at(i, j) + "," + at(k, l) + "]";
    assignments += comma + "\"" + assignment + "\"";
  };
  for (int j = 0; j <= rows; ++j) {
    for (int i = 0; i <= columns; ++i) {
      const double x = i * width + (j % 2 == 0 ? 0 : shift);
      points +=
          (points.empty() ? "[" : ",[") + std::to_string(x) + "," + std::to_string(j * width) + "]";
      const bool isRim = i == 0 || i == columns;
      const bool isEven = i % 2 == 0;
      if (j < rows) add(i, j, i, j + 1, isRim ? "B" : isOpen ? "U" : isEven ? "M" : "V");
      if (i == columns) continue;
      const bool isMountain = (j % 2 == 0) != isEven;
      add(i, j, i + 1, j, j == 0 || j == rows ? "B" : isOpen ? "U" : isMountain ? "M" : "V");
    }
  }
  return R"({"file_spec":1.1,"frame_unit":"mm","vertices_coords":[)" + points +
         R"(],"edges_vertices":[)" + edges + R"(],"edges_assignment":[)" + assignments + "]}";
}

}  // namespace kiri::test
