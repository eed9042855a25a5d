// Cameras on the way from one view to another.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cmath>

#include "core/geometry/rigid.h"
#include "editor/view/camera.h"

namespace kiri {
namespace {

std::array<Vec3, 3> axesOf(const ViewFrame& f) { return {f.right, f.up, f.toEye}; }

/// The turn that takes the axes of `a` to those of `b`.
struct Turn {
  Vec3 axis{0, 0, 1};
  double degrees = 0;
};

Turn turnBetween(const ViewFrame& a, const ViewFrame& b) {
  const auto from = axesOf(a);
  const auto to = axesOf(b);
  const auto image = [&](Vec3 v) {
    return to[0] * dot(from[0], v) + to[1] * dot(from[1], v) + to[2] * dot(from[2], v);
  };
  const Vec3 skew =
      (cross(from[0], to[0]) + cross(from[1], to[1]) + cross(from[2], to[2])) / 2;  // axis * sin
  const double cos = (dot(from[0], to[0]) + dot(from[1], to[1]) + dot(from[2], to[2]) - 1) / 2;
  const double sin = length(skew);
  if (sin > kSamePlane) return {skew / sin, angleDegrees(cos, sin)};
  if (cos > 0) return {};
  Vec3 best;  // half a turn: v + image of v lies along the axis
  for (const Vec3 v : axesOf(ViewFrame{})) {
    const Vec3 along = v + image(v);
    if (length(along) > length(best)) best = along;
  }
  return {normalized(best), 180};
}

/// A camera as seen from a place that it shows: how large and where it appears, and where the axis
/// of the eye passes it.
struct Look {
  double scale = 1;
  Vec2 pixels;
  Vec2 axis;
  double nearness = 0;  ///< 1 / distance of the eye; 0: orthographic
};

Look lookAt(const PaneMap& map, Vec3 place) {
  Look out;
  out.scale = map.pixelsPerMm * map.frame.enlargement(place);
  out.pixels = map.toPixels(place);
  if (!map.frame.isPerspective()) return out;
  const Vec3 away = map.frame.eye() - place;
  out.axis = map.frame.direction(away);
  out.nearness = 1 / dot(away, map.frame.toEye);
  return out;
}

}  // namespace

Camera Camera::interpolated(const Camera& a, const Camera& b, double t) {
  if (!(t > 0)) return a;
  const Vec3 place = b.ball_.centre;
  const Look from = lookAt(a.map(), place);
  const Look to = lookAt(b.map(), place);
  if (t >= 1 || !(from.scale > 0) || !(to.scale > 0)) return b;

  Camera out = b;
  const Turn turn = turnBetween(a.frame_, b.frame_);
  const Rigid turned = rotationAbout({}, turn.axis, turn.degrees * t);
  out.frame_.right = turned.direction(a.frame_.right);
  out.frame_.up = turned.direction(a.frame_.up);
  out.frame_.toEye = turned.direction(a.frame_.toEye);

  const double nearness = (1 - t) * from.nearness + t * to.nearness;
  const double nearest = 10.0 / 9 * b.ball_.radius;
  out.frame_.eyeDistance = nearness > 0 ? std::max(1 / nearness, nearest) : 0;
  out.fieldOfView_ = (1 - t) * a.fieldOfView_ + t * b.fieldOfView_;
  const Vec2 axis = lerp(from.axis, to.axis, t);
  out.frame_.centre = place + out.frame_.right * axis.x + out.frame_.up * axis.y;
  out.size_ = a.size_;
  out.pixelsPerMm_ = from.scale * std::pow(to.scale / from.scale, t);
  const Vec2 pixels = lerp(from.pixels, to.pixels, t);
  const Vec2 fromMiddle{pixels.x - a.size_.x / 2, a.size_.y / 2 - pixels.y};
  out.aside_ = -axis - fromMiddle / out.pixelsPerMm_;
  out.isFitted_ = false;
  return out;
}

}  // namespace kiri
