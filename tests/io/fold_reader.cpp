// A FOLD frame as plain arrays, and folding it again from its angles alone: for tests, apart from
// our writer. SPDX-License-Identifier: MIT
#include "tests/io/fold_reader.h"

#include <cmath>
#include <deque>
#include <stdexcept>

namespace kiri::test {

namespace {

Point plus(const Point& a, const Point& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }
Point times(const Point& a, double s) { return {a[0] * s, a[1] * s, a[2] * s}; }
Point unit(const Point& a) { return times(a, 1 / std::sqrt(dotted(a, a))); }

/// Rodrigues' formula: `p` turned about the axis through `a` and `b` by `radians`, right-handed.
Point turned(const Point& p, const Point& a, const Point& b, double radians) {
  const Point k = unit(minus(b, a));
  const Point v = minus(p, a);
  const Point rotated =
      plus(plus(times(v, std::cos(radians)), times(crossed(k, v), std::sin(radians))),
           times(k, dotted(k, v) * (1 - std::cos(radians))));
  return plus(a, rotated);
}

/// Takes the plane of the flat pattern to space.
struct Place {
  Point origin;
  Point x;
  Point y;
  Point apply(const Point& p) const { return plus(origin, plus(times(x, p[0]), times(y, p[1]))); }
};

/// The place that takes three flat corners to three corners in space.
Place placeFrom(const std::vector<Point>& flat, const std::vector<Point>& space) {
  const Point e = unit(minus(flat[1], flat[0]));
  const Point along = unit(minus(space[1], space[0]));
  const Point up = unit(crossed(along, minus(space[2], space[0])));
  const Point across = crossed(up, along);
  Place out;
  out.x = plus(times(along, e[0]), times(across, -e[1]));
  out.y = plus(times(along, e[1]), times(across, e[0]));
  out.origin = minus(space[0], plus(times(out.x, flat[0][0]), times(out.y, flat[0][1])));
  return out;
}

std::vector<Point> cornersOf(const Frame& frame, int face) {
  std::vector<Point> out;
  for (const int v : frame.faces[static_cast<std::size_t>(face)]) {
    out.push_back(frame.vertices[static_cast<std::size_t>(v)]);
  }
  return out;
}

/// True when the face runs from `a` straight on to `b`.
bool runsAlong(const std::vector<int>& face, int a, int b) {
  for (std::size_t i = 0; i < face.size(); ++i) {
    if (face[i] == a && face[(i + 1) % face.size()] == b) return true;
  }
  return false;
}

template <class T>
std::vector<T> listOf(const nlohmann::json& json, const char* name) {
  return json.at(name).get<std::vector<T>>();
}

}  // namespace

Point minus(const Point& a, const Point& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }

Point crossed(const Point& a, const Point& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

double dotted(const Point& a, const Point& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

double apart(const Point& a, const Point& b) { return std::sqrt(dotted(minus(a, b), minus(a, b))); }

Point normalOf(const std::vector<Point>& face) {
  Point sum{0, 0, 0};
  for (std::size_t i = 0; i < face.size(); ++i) {
    sum = plus(sum, crossed(minus(face[i], face[0]), minus(face[(i + 1) % face.size()], face[0])));
  }
  return unit(sum);
}

Frame frameOf(const nlohmann::json& json) {
  Frame out;
  for (std::vector<double> at : listOf<std::vector<double>>(json, "vertices_coords")) {
    at.resize(3, 0.0);
    out.vertices.push_back({at[0], at[1], at[2]});
  }
  out.edges = listOf<std::array<int, 2>>(json, "edges_vertices");
  out.assignments = listOf<std::string>(json, "edges_assignment");
  out.angles = listOf<double>(json, "edges_foldAngle");
  for (const nlohmann::json& faces : json.at("edges_faces")) {
    out.edgeFaces.push_back({faces.at(0).is_null() ? -1 : faces.at(0).get<int>(),
                             faces.at(1).is_null() ? -1 : faces.at(1).get<int>()});
  }
  out.faces = listOf<std::vector<int>>(json, "faces_vertices");
  out.orders = listOf<std::array<int, 3>>(json, "faceOrders");
  const std::size_t count = out.edges.size();
  if (out.assignments.size() != count || out.angles.size() != count ||
      out.edgeFaces.size() != count) {
    throw std::runtime_error("the edges_ arrays have different lengths");
  }
  return out;
}

std::vector<std::vector<Point>> folded(const Frame& flat, const std::vector<Point>& start,
                                       double scale) {
  std::vector<std::vector<Point>> out(flat.faces.size());
  std::vector<Place> places(flat.faces.size());
  places[0] = placeFrom(cornersOf(flat, 0), start);
  std::deque<int> queue = {0};
  std::vector<bool> isSeen(flat.faces.size(), false);
  isSeen[0] = true;
  while (!queue.empty()) {
    const int face = queue.front();
    queue.pop_front();
    const Place& place = places[static_cast<std::size_t>(face)];
    for (const Point& p : cornersOf(flat, face))
      out[static_cast<std::size_t>(face)].push_back(place.apply(p));
    for (std::size_t e = 0; e < flat.edges.size(); ++e) {
      const auto [left, right] = flat.edgeFaces[e];
      const bool holds = flat.assignments[e] != "B" && flat.assignments[e] != "C";
      if (!holds || (left != face && right != face)) continue;
      const int other = left == face ? right : left;
      if (other < 0 || isSeen[static_cast<std::size_t>(other)]) continue;
      auto [a, b] = flat.edges[e];
      if (!runsAlong(flat.faces[static_cast<std::size_t>(face)], a, b)) std::swap(a, b);
      // The known face is on the left of a to b. Turning what is on the right by a negative angle
      // about that direction lifts it towards the normal of the known face: a valley.
      const double degrees = flat.angles[e] * scale;
      const double radians = -degrees * std::acos(-1.0) / 180;
      const Point from = place.apply(flat.vertices[static_cast<std::size_t>(a)]);
      const Point to = place.apply(flat.vertices[static_cast<std::size_t>(b)]);
      const auto moved = [&](const Point& p) { return turned(p, from, to, radians); };
      Place& next = places[static_cast<std::size_t>(other)];
      next.origin = moved(place.origin);
      next.x = minus(moved(plus(place.origin, place.x)), next.origin);
      next.y = minus(moved(plus(place.origin, place.y)), next.origin);
      isSeen[static_cast<std::size_t>(other)] = true;
      queue.push_back(other);
    }
  }
  return out;
}

}  // namespace kiri::test
