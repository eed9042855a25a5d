// Points and directions in two and three dimensions.
// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

namespace kiri {

/// A point or direction in a plane: the paper frame, or the coordinates of one plane. In mm.
struct Vec2 {
  double x = 0;
  double y = 0;

  constexpr Vec2 operator+(Vec2 o) const { return {x + o.x, y + o.y}; }
  constexpr Vec2 operator-(Vec2 o) const { return {x - o.x, y - o.y}; }
  constexpr Vec2 operator-() const { return {-x, -y}; }
  constexpr Vec2 operator*(double s) const { return {x * s, y * s}; }
  constexpr Vec2 operator/(double s) const { return {x / s, y / s}; }
  constexpr bool operator==(const Vec2&) const = default;
};

constexpr Vec2 operator*(double s, Vec2 v) { return v * s; }
constexpr double dot(Vec2 a, Vec2 b) { return a.x * b.x + a.y * b.y; }
/// z of the cross product: positive when b lies counter-clockwise of a.
constexpr double cross(Vec2 a, Vec2 b) { return a.x * b.y - a.y * b.x; }
inline double length(Vec2 v) { return std::sqrt(dot(v, v)); }
inline double distance(Vec2 a, Vec2 b) { return length(a - b); }
/// The direction of v. Requires a vector that is not zero.
inline Vec2 normalized(Vec2 v) { return v / length(v); }
/// v turned by 90 degrees counter-clockwise.
constexpr Vec2 perpendicular(Vec2 v) { return {-v.y, v.x}; }
constexpr Vec2 lerp(Vec2 a, Vec2 b, double t) { return a * (1 - t) + b * t; }

/// A point or direction in the model frame. In mm.
struct Vec3 {
  double x = 0;
  double y = 0;
  double z = 0;

  constexpr Vec3 operator+(Vec3 o) const { return {x + o.x, y + o.y, z + o.z}; }
  constexpr Vec3 operator-(Vec3 o) const { return {x - o.x, y - o.y, z - o.z}; }
  constexpr Vec3 operator-() const { return {-x, -y, -z}; }
  constexpr Vec3 operator*(double s) const { return {x * s, y * s, z * s}; }
  constexpr Vec3 operator/(double s) const { return {x / s, y / s, z / s}; }
  constexpr bool operator==(const Vec3&) const = default;
};

constexpr Vec3 operator*(double s, Vec3 v) { return v * s; }
constexpr double dot(Vec3 a, Vec3 b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
constexpr Vec3 cross(Vec3 a, Vec3 b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline double length(Vec3 v) { return std::sqrt(dot(v, v)); }
inline double distance(Vec3 a, Vec3 b) { return length(a - b); }
/// The direction of v. Requires a vector that is not zero.
inline Vec3 normalized(Vec3 v) { return v / length(v); }
/// The shadow of a model-frame point on the plane that the viewer of the front looks at.
constexpr Vec2 flatten(Vec3 v) { return {v.x, v.y}; }

}  // namespace kiri
