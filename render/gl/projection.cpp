// A view as the numbers that shaders take.
// SPDX-License-Identifier: MIT
#include "render/gl/projection.h"

#include <algorithm>
#include <cmath>

namespace kiri {
namespace {

/// A function of a place q: dot(slope, q) + value.
struct Linear {
  Vec3 slope;
  double value = 0;

  Linear operator+(const Linear& o) const { return {slope + o.slope, value + o.value}; }
  Linear operator*(double s) const { return {slope * s, value * s}; }
};

float narrow(double x) { return static_cast<float>(x); }

double depthRange(const GlView& view) { return std::abs(view.nearDepth - view.farDepth); }

}  // namespace

std::array<float, 16> clipMatrix(const GlView& view, Vec3 origin) {
  const ViewFrame& frame = view.frame;
  const Vec3 centre = frame.isPerspective() ? frame.centre : Vec3{};
  const Vec3 from = origin - centre;
  const Linear aside{frame.right, dot(from, frame.right)};
  const Linear upward{frame.up, dot(from, frame.up)};
  const Linear ahead{frame.toEye, dot(from, frame.toEye)};
  Linear w{{}, 1};
  if (frame.isPerspective()) w = w + ahead * (-1 / frame.eyeDistance);

  const Vec2 shift = frame.direction(centre) - view.centre;
  const double low = std::min(view.nearDepth, view.farDepth);
  const double range = depthRange(view);
  const std::array<Linear, 4> rows{
      (aside + w * shift.x) * (2 * view.pixelsPerMm / view.width),
      (upward + w * shift.y) * (2 * view.pixelsPerMm / view.height),
      w * (1 + 2 * low / range) + ahead * (-2 / range),
      w,
  };
  std::array<float, 16> out{};
  for (std::size_t r = 0; r < 4; ++r) {
    out[r] = narrow(rows[r].slope.x);
    out[4 + r] = narrow(rows[r].slope.y);
    out[8 + r] = narrow(rows[r].slope.z);
    out[12 + r] = narrow(rows[r].value);
  }
  return out;
}

std::array<float, 9> viewMatrix(const ViewFrame& frame) {
  const auto column = [](double a, double b, double c) {
    return std::array{narrow(a), narrow(b), narrow(c)};
  };
  const auto x = column(frame.right.x, frame.up.x, frame.toEye.x);
  const auto y = column(frame.right.y, frame.up.y, frame.toEye.y);
  const auto z = column(frame.right.z, frame.up.z, frame.toEye.z);
  return {x[0], x[1], x[2], y[0], y[1], y[2], z[0], z[1], z[2]};
}

std::array<float, 4> eyeOf(const ViewFrame& frame, Vec3 origin) {
  const Vec3 eye = frame.isPerspective() ? frame.eye() - origin : frame.toEye;
  return {narrow(eye.x), narrow(eye.y), narrow(eye.z), frame.isPerspective() ? 1.0F : 0.0F};
}

float flatSlopeOf(const GlView& view) { return narrow(2 / (depthRange(view) * view.pixelsPerMm)); }

}  // namespace kiri
