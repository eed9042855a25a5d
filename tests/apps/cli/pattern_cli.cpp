// Crease patterns for tests of the command line.
// SPDX-License-Identifier: MIT
#include "tests/apps/cli/pattern_cli.h"

#include <cmath>
#include <sstream>

namespace kiri::cli {

std::string mapAsFold(const std::string& letter) {
  std::string vertices;
  for (const int y : {0, 30, 60}) {
    for (const int x : {0, 20, 40, 60}) {
      vertices +=
          (vertices.empty() ? "[" : ",[") + std::to_string(x) + "," + std::to_string(y) + "]";
    }
  }
  std::string edges;
  std::string letters;
  const auto add = [&](int a, int b, bool isBorder) {
    edges += (edges.empty() ? "[" : ",[") + std::to_string(a) + "," + std::to_string(b) + "]";
    letters += (letters.empty() ? "\"" : ",\"") + (isBorder ? "B" : letter) + "\"";
  };
  for (int row = 0; row < 3; ++row)
    for (int i = 0; i < 3; ++i) add(4 * row + i, 4 * row + i + 1, row != 1);
  for (int column = 0; column < 4; ++column)
    for (int i = 0; i < 2; ++i) add(column + 4 * i, column + 4 * i + 4, column % 3 == 0);
  return "{\"file_spec\": 1.1, \"frame_unit\": \"mm\", \"vertices_coords\": [" + vertices +
         "], \"edges_vertices\": [" + edges + "], \"edges_assignment\": [" + letters + "]}\n";
}

std::string starAsCp(double degrees) {
  std::ostringstream out;
  out.precision(17);
  out << "1 -50 -50 50 -50\n1 50 -50 50 50\n1 50 50 -50 50\n1 -50 50 -50 -50\n"
      << "2 0 0 0 -50\n2 0 0 0 50\n2 0 0 -50 0\n";
  constexpr double kTurn = 3.14159265358979323846 / 180;
  out << "3 0 0 50 " << 50 * std::tan(degrees * kTurn) << "\n";
  return out.str();
}

}  // namespace kiri::cli
