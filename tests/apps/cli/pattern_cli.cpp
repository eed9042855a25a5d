// kiri run on crease patterns in a folder of its own, for tests.
// SPDX-License-Identifier: MIT
#include "tests/apps/cli/pattern_cli.h"

#include <unistd.h>

#include <cmath>
#include <fstream>
#include <sstream>

#include "apps/cli/run.h"

namespace kiri::cli {

PatternAnswer runKiri(const std::vector<std::string>& arguments, const PatternSetting& setting) {
  std::istringstream in(setting.input);
  std::ostringstream out;
  std::ostringstream err;
  int asked = 0;
  Console console{in, out, err, setting.showsProgress, [&] { return ++asked > setting.patience; }};
  PatternAnswer answer;
  answer.code = run(arguments, console);
  answer.out = out.str();
  answer.err = err.str();
  return answer;
}

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

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

void PatternCli::SetUp() {
  std::string pattern = (std::filesystem::temp_directory_path() / "kiri-patterns-XXXXXX").string();
  ASSERT_NE(::mkdtemp(pattern.data()), nullptr);
  folder_ = pattern;
}

void PatternCli::TearDown() { std::filesystem::remove_all(folder_); }

std::string PatternCli::put(const std::string& name, const std::string& text) const {
  std::ofstream(folder_ / name) << text;
  return path(name);
}

std::string PatternCli::get(const std::string& name) const {
  std::ifstream in(folder_ / name, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

std::size_t PatternCli::fileCount() const {
  std::size_t count = 0;
  for ([[maybe_unused]] const auto& entry : std::filesystem::directory_iterator(folder_)) ++count;
  return count;
}

}  // namespace kiri::cli
