// SVG files beside what Origami Simulator itself made of them.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "core/geometry/cubic.h"
#include "io/file.h"
#include "io/json_tree.h"
#include "io/patterns/svg_reader.h"

namespace kiri {
namespace {

namespace fs = std::filesystem;

struct TwinEdge {
  Vec2 from;
  Vec2 to;
  char letter = 'U';
  double angle = 0;
};

/// The edges of a FOLD file that lies in the plane of x and z, as Origami Simulator writes it.
std::vector<TwinEdge> twinEdges(const fs::path& path) {
  std::vector<TwinEdge> edges;
  const Result<std::string> text = readFile(path.string());
  if (!text) return edges;
  const Result<JsonValue> tree = parseJson(*text, "twin");
  if (!tree) return edges;
  const JsonValue* vertices = tree->find("vertices_coords");
  const JsonValue* ends = tree->find("edges_vertices");
  const JsonValue* letters = tree->find("edges_assignment");
  const JsonValue* angles = tree->find("edges_foldAngle");
  if (vertices == nullptr || ends == nullptr || letters == nullptr || angles == nullptr)
    return edges;
  const auto place = [&](double index) {
    const JsonValue& v = vertices->items[static_cast<std::size_t>(index)];
    return Vec2{v.items[0].number, -v.items[2].number};
  };
  for (std::size_t i = 0; i < ends->items.size(); ++i) {
    const JsonValue& e = ends->items[i];
    edges.push_back({place(e.items[0].number), place(e.items[1].number), letters->items[i].text[0],
                     angles->items[i].number});
  }
  return edges;
}

double missFrom(const DrawnCrease& line, Vec2 p) {
  return nearestOn(Arc::line(line.from, line.to), p).distance;
}

double angleOf(const DrawnCrease& line) {
  if (line.angle) return *line.angle;
  return line.assignment == Assignment::Mountain ? -180
         : line.assignment == Assignment::Valley ? 180
                                                 : 0;
}

char letterOf(const DrawnCrease& line) {
  // A join is a "facet crease" there.
  return "BMVFUCF"[static_cast<std::size_t>(line.assignment)];
}

/// Total length of the lines of each letter that stand for creases and cuts.
template <class Edges, class Letter>
std::map<char, double> lengthsOf(const Edges& edges, const Letter& letter) {
  std::map<char, double> lengths;
  for (const auto& edge : edges) lengths[letter(edge)] += distance(edge.from, edge.to);
  return lengths;
}

struct Twin {
  const char* folder;
  const char* name;
};

constexpr std::array<Twin, 12> kTwins{{{"Bases", "birdBase"},
                                       {"Curved", "Origami_Sphere_16Flaps"},
                                       {"Curved", "shell14"},
                                       {"Kirigami", "auxetic_triangle"},
                                       {"Kirigami", "triPerfTess"},
                                       {"Origami", "MoosersTrainRigid-Gardner"},
                                       {"Origami", "flappingBird"},
                                       {"Origami", "singlesquaretwist"},
                                       {"Polygami", "polygamiCross"},
                                       {"Popup", "housePopup"},
                                       {"Tessellations", "FTpoly7"},
                                       {"Tessellations", "huffmanRectangularWeave"}}};

TEST(SvgTwins, HaveTheLinesAssignmentsAndAnglesOfOrigamiSimulator) {
  const fs::path root = KIRI_SOURCE_DIR "/../shared/data/formats/origami-simulator";
  if (!fs::is_directory(root)) GTEST_SKIP() << "no files beside the checkout";
  for (const Twin& twin : kTwins) {
    const std::string name = std::string(twin.folder) + "/" + twin.name;
    const Result<std::string> text = readFile((root / (name + ".svg")).string());
    ASSERT_TRUE(text) << name;
    const Result<PatternFile> file = readSvgPattern(*text, name);
    ASSERT_TRUE(file) << name;
    const std::vector<TwinEdge> edges =
        twinEdges(root / "as_fold" / (std::string(twin.folder) + "__" + twin.name + ".fold"));
    ASSERT_FALSE(edges.empty()) << name;
    constexpr double kMerged = 3;  // units within which it merges vertices
    std::size_t missed = 0;
    for (const TwinEdge& edge : edges) {
      // What it added to make triangles has no line in the drawing.
      if (edge.letter == 'F') continue;
      const Vec2 middle = (edge.from + edge.to) / 2;
      const bool isThere = std::any_of(
          file->drawing.lines.begin(), file->drawing.lines.end(), [&](const DrawnCrease& line) {
            return letterOf(line) == edge.letter && missFrom(line, middle) < kMerged &&
                   std::abs(angleOf(line) - edge.angle) < 0.01;
          });
      if (!isThere) ++missed;
    }
    EXPECT_EQ(missed, 0U) << name << " of " << edges.size();
    const auto own = lengthsOf(file->drawing.lines, letterOf);
    auto theirs = lengthsOf(edges, [](const TwinEdge& edge) { return edge.letter; });
    for (const char letter : {'M', 'V', 'C'}) {
      const double length = own.count(letter) > 0 ? own.at(letter) : 0;
      // It leaves out lines that lie on others.
      EXPECT_GE(length, 0.99 * theirs[letter]) << name << " " << letter;
      EXPECT_LE(length, 1.03 * theirs[letter]) << name << " " << letter;
    }
  }
}

}  // namespace
}  // namespace kiri
