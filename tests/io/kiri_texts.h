// Model files as texts, for the tests of reading and writing.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

namespace kiri::test {

/// A file with these steps on a square of 150 mm; the steps start on line 5.
inline std::string fileWithSteps(const std::string& steps) {
  return R"({"format": "kiri", "version": 1,
 "title": "A test",
 "sheet": {"shape": "square", "side": 150},
 "steps": [
)" + steps +
         "\n]}\n";
}

/// A file with this sheet, which stands on line 2.
inline std::string fileWithSheet(const std::string& sheet) {
  return "{\"format\": \"kiri\", \"version\": 1, \"steps\": [],\n\"sheet\": " + sheet + "}\n";
}

/// One step of every kind and with every choice that the format has.
inline std::vector<std::string> everyStep() {
  return {
      R"({"do": "fold", "name": "mid-vein", "title": "In half", "line": {"paper": [[75, 0], [75, 150]]}, "type": "valley", "angle": 180, "move": "left"})",
      R"({"do": "fold", "line": {"paper": [[0, 0], [75, 75]], "facet": [10, 30]}, "type": "mountain", "angle": 90, "layers": {"top": 2}, "move": "right", "notes": "n"})",
      R"({"do": "fold", "name": "c", "line": {"model": [[0, 0], [75, 75]]}, "type": "mountain", "angle": 12.5, "layers": {"facets": [[1, 2], {"paper": [3, 4]}]}, "move": {"point": [3, 4]}})",
      R"({"do": "fold", "name": "d", "line": {"model": [[0, 0], [75, 75]]}, "type": "valley", "angle": 180, "move": {"facets": [{"paper": [1, 2]}, [3, 4]]}})",
      R"({"do": "angle", "fold": "mid-vein", "angle": -90})",
      R"({"do": "angle", "fold": {"model": [75, 20]}, "angle": 0})",
      R"({"do": "unfold"})",
      R"({"do": "unfold", "folds": ["c", [75, 20]], "sequence": "together"})",
      R"({"do": "refold", "folds": ["mid-vein"]})",
      R"({"do": "tear", "path": {"paper": [[75, 0], [75, 40]]}})",
      R"({"do": "tear", "path": {"model": [[75, 0], [75, 40], [80, 50]]}, "layers": {"top": 1}})",
      R"({"do": "mend", "path": "all"})",
      R"({"do": "mend", "path": {"paper": [[75, 0], [75, 40]]}, "layers": {"facets": [[1, 1]]}})",
      R"({"do": "add edge", "line": {"model": [[1, 1], [20, 20]]}})",
      R"({"do": "straight cut", "line": {"paper": [[0, 10], [150, 10]]}, "keep": "all"})",
      R"({"do": "straight cut", "line": {"model": [[0, 10], [150, 10]]}, "layers": {"top": 3}, "keep": [[75, 75], {"paper": [1, 2]}]})",
      R"({"do": "curve cut", "curve": {"model": [[0, 0], [10, 20], [30, 20], [40, 0]]}, "keep": [[75, 75]]})",
      R"({"do": "curve cut", "curve": {"paper": [[0, 0], [10, 20], [30, 0]], "facet": [5, 5], "closed": true}, "layers": {"top": 1}, "keep": "all"})",
      R"({"do": "curve cut", "curve": {"model": [[0, 0], [10, 20], [30, 20], [40, 0]], "ends": "free"}, "keep": "all"})",
      R"({"do": "turn over"})",
      R"({"do": "turn over", "axis": "horizontal"})",
      R"({"do": "rotate", "degrees": 30})",
      R"({"do": "rotate", "degrees": -12.25, "about": [75, 75]})",
      R"({"do": "move", "by": [10, -5]})",
      R"({"do": "straight cut", "line": {"model": [[0, 10], [150, 10]]}, "layers": "through", "keep": [[75, 75]]})",
      R"({"do": "pattern", "vertices": [[75, 0], [75, 150]], "creases": [[0, 1, "V"]]})",
      R"({"do": "tear", "path": {"paper": [[75, 0], [75, 40]]}, "layers": "all"})",
      R"({"do": "pattern", "name": "p", "vertices": [[75, 0], [75, 75], [75, 150], [0, 75], [150, 75]], "creases": [[0, 1, "V", 90], [1, 2, "M"], [3, 1, "U"], [1, 4, "F"], [0, 3, "J"], [0, 4, "C"]], "folded": true, "resting": [1, 2], "layers": [[1, 2], [3, 4]], "exceptions": [[[1, 2], [3, 4]]]})",
  };
}

inline std::string joinedSteps(const std::vector<std::string>& steps) {
  std::string out;
  for (const std::string& step : steps) out += (out.empty() ? "  " : ",\n  ") + step;
  return out;
}

/// A file with all of everyStep().
inline std::string fileWithEverything() { return fileWithSteps(joinedSteps(everyStep())); }

}  // namespace kiri::test
