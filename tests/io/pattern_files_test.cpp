// SVG of the crease pattern and OBJ of the model: contours are closed and exact, shapes have the
// right size. SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <sstream>
#include <string>
#include <vector>

#include "io/obj_writer.h"
#include "io/svg_pattern_writer.h"
#include "tests/support/model_text.h"

namespace kiri {
namespace {

std::size_t countOf(const std::string& text, const std::string& part) {
  std::size_t count = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1))
    ++count;
  return count;
}

TEST(SvgPattern, ClosesOneContourForTheRimAndOneForEachHole) {
  const std::string svg =
      writeSvgPattern(test::run("polygon 0,0 100,0 100,80 0,80 hole 40,20 60,20 60,40 40,40\nfold "
                                "a mountain 50,0 50,80 left"));
  EXPECT_EQ(countOf(svg, "Z\" data-assignment=\"B\""), 2u) << svg;
  EXPECT_EQ(countOf(svg, "data-assignment=\"M\" data-foldAngle=\"-180\" data-fold=\"a\""), 2u)
      << svg;
  EXPECT_EQ(countOf(svg, "viewBox=\"0 0 100 80\""), 1u);
}

TEST(SvgPattern, KeepsPaperUpright) {
  // A crease in the upper left of the paper is in the upper left of the picture, where y points
  // down.
  const std::string svg =
      writeSvgPattern(test::run("square 100\nfold a valley 90 0,70 30,100 left"));
  EXPECT_TRUE(countOf(svg, "M0 30 L30 0") + countOf(svg, "M30 0 L0 30") == 1) << svg;
  EXPECT_EQ(countOf(svg, "stroke-opacity=\"0.5\""), 1u) << "half folded";
}

TEST(SvgPattern, KeepsCurvesExact) {
  const std::string svg = writeSvgPattern(test::run("disc 50"));
  EXPECT_EQ(countOf(svg, " C"), 32u);
  EXPECT_EQ(countOf(svg, " L"), 0u);
}

TEST(SvgPattern, DrawsTearsApart) {
  const std::string svg = writeSvgPattern(
      test::run("square 100\nfold a valley 50,0 50,100 left\nunfold all\ntear 50,0 50,40"));
  EXPECT_EQ(countOf(svg, "data-assignment=\"C\""), 1u) << svg;
  EXPECT_EQ(countOf(svg, "Z\" data-assignment=\"B\""), 1u);
  EXPECT_EQ(countOf(svg, "data-assignment=\"F\""), 1u);
}

struct Solid {
  std::vector<Vec3> vertices;
  std::vector<std::vector<std::size_t>> triangles;
};

Solid solidOf(const std::string& obj) {
  Solid out;
  std::istringstream lines(obj);
  std::string line;
  while (std::getline(lines, line)) {
    std::istringstream words(line);
    std::string kind;
    words >> kind;
    if (kind == "v") {
      Vec3 p;
      words >> p.x >> p.y >> p.z;
      out.vertices.push_back(p);
    } else if (kind == "f") {
      std::vector<std::size_t> corners;
      std::string corner;
      while (words >> corner) corners.push_back(std::strtoul(corner.c_str(), nullptr, 10) - 1);
      out.triangles.push_back(corners);
    }
  }
  return out;
}

double areaOf(const Solid& solid) {
  double sum = 0;
  for (const std::vector<std::size_t>& t : solid.triangles) {
    const Vec3 a = solid.vertices.at(t.at(0));
    sum += length(cross(solid.vertices.at(t.at(1)) - a, solid.vertices.at(t.at(2)) - a)) / 2;
  }
  return sum;
}

TEST(ObjWriter, KeepsTheAreaOfFoldedAndCutPaper) {
  const FoldedState state = test::run(
      "square 100\nfold a valley 90 50,0 50,100 left\n"
      "curve 60,10 90,10 90,90 60,90 closed keep 5,5");
  const Solid solid = solidOf(writeObj(state, {}).text);
  EXPECT_NEAR(areaOf(solid), areaOf(state.pattern), 1e-3 * areaOf(state.pattern));
  const Solid twice = solidOf(writeObj(state, {"", {{0, 0}, {100, 100}}, true, 0, false}).text);
  EXPECT_EQ(twice.triangles.size(), 2 * solid.triangles.size());
  bool isUpright = false;
  for (const Vec3 p : solid.vertices) isUpright = isUpright || p.z > 40;
  EXPECT_TRUE(isUpright) << "the folded side stands up";
}

TEST(ObjWriter, LaysThePatternFlat) {
  ObjOptions options;
  options.isPattern = true;
  for (const Vec3 p :
       solidOf(writeObj(test::run("square 100\nfold a valley 90 50,0 50,100 left"), options).text)
           .vertices) {
    EXPECT_EQ(p.z, 0);
  }
}

}  // namespace
}  // namespace kiri
