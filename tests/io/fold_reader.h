// A FOLD frame as plain arrays, and folding it again from its angles alone: for tests, apart from
// our writer. SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace kiri::test {

using Point = std::array<double, 3>;

struct Frame {
  std::vector<Point> vertices;
  std::vector<std::array<int, 2>> edges;
  std::vector<std::string> assignments;
  std::vector<double> angles;
  std::vector<std::array<int, 2>> edgeFaces;  ///< -1: none
  std::vector<std::vector<int>> faces;
  std::vector<std::array<int, 3>> orders;
};

/// Reads a frame; throws when an array is missing or has the wrong length.
Frame frameOf(const nlohmann::json& json);

/// The vertices of each face after folding from `edges_foldAngle`, with face 0 where `start` puts
/// its first three corners. Faces that hinges (M, V, F) and joins (J) do not reach stay empty.
/// `scale` multiplies the angles. As the specification says: faces run counter-clockwise, a valley
/// turns the faces' normals towards each other.
std::vector<std::vector<Point>> folded(const Frame& flat, const std::vector<Point>& start,
                                       double scale = 1);

Point minus(const Point& a, const Point& b);
Point crossed(const Point& a, const Point& b);
double dotted(const Point& a, const Point& b);
double apart(const Point& a, const Point& b);
Point normalOf(const std::vector<Point>& face);

}  // namespace kiri::test
