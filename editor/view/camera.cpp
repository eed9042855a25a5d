// Trackball, pan and zoom of the eye that looks at the model.
// SPDX-License-Identifier: MIT
#include "editor/view/camera.h"

#include <algorithm>
#include <cmath>

#include "core/geometry/rigid.h"
#include "editor/view/zoom_limits.h"

namespace kiri {
namespace {

constexpr double kWidest = 120;  // degrees, see checkViewSpec
constexpr double kNarrowest = 1;
constexpr double kNearestEye = 10.0 / 9;  // radii of the ball, see withEye
constexpr double kAngledAzimuth = 30;
constexpr double kAngledElevation = 40;

Sphere withSize(const Sphere& ball) { return {ball.centre, ball.radius > 0 ? ball.radius : 1.0}; }

/// mm from the middle of the ball at which it fills the field of view; 0: orthographic.
double eyeDistanceFor(double fieldOfView, double radius) {
  return fieldOfView > 0 ? radius / cosSinDegrees(fieldOfView / 2).sin : 0;
}

/// `v` turned about an axis (Rodrigues).
Vec3 turned(Vec3 v, Vec3 axis, double cos, double sin) {
  return v * cos + cross(axis, v) * sin + axis * (dot(axis, v) * (1 - cos));
}

/// Rounding must not add up to a skewed picture.
void straighten(ViewFrame& frame) {
  frame.toEye = normalized(frame.toEye);
  frame.up = normalized(cross(frame.toEye, frame.right));
  frame.right = cross(frame.up, frame.toEye);
}

/// Pixels from the middle of the pane, y up.
Vec2 fromMiddle(Vec2 pixels, Vec2 size) { return {pixels.x - size.x / 2, size.y / 2 - pixels.y}; }

}  // namespace

double Camera::scale() const { return pixelsPerMm_ * frame_.enlargement(ball_.centre); }

/// The eye goes to `distance` above the middle of the ball (0: as far as can be); the middle stays
/// where it is in the picture, as large as it was.
void Camera::placeEye(double distance) {
  const Vec2 at = fromMiddle(map().toPixels(ball_.centre), size_);
  pixelsPerMm_ = scale();
  frame_.centre = ball_.centre;
  frame_.eyeDistance = distance;
  aside_ = -at / pixelsPerMm_;
}

void Camera::look(Preset preset, const Sphere& ball) {
  const ViewFrame axes = preset == Preset::Front  ? frontView()
                         : preset == Preset::Back ? backView()
                                                  : viewFrom(kAngledAzimuth, kAngledElevation);
  frame_.right = axes.right;
  frame_.up = axes.up;
  frame_.toEye = axes.toEye;
  fit(ball);
}

void Camera::fit(const Sphere& ball) {
  ball_ = withSize(ball);
  frame_.centre = ball_.centre;
  frame_.eyeDistance = eyeDistanceFor(fieldOfView_, ball_.radius);
  const Box box = boxOf(frame_, ball_);
  pixelsPerMm_ = kFittedPart * shorterSide(size_) / (box.high.x - box.low.x);
  aside_ = {};
  isFitted_ = true;
}

void Camera::resize(Vec2 pixels) {
  size_ = {std::max(1.0, pixels.x), std::max(1.0, pixels.y)};
  if (isFitted_) fit(ball_);
}

/// The direction, from the middle of the trackball, of its point under a pixel: on a sphere in the
/// middle, on a hyperbolic sheet that meets it smoothly beside (Bell 1988, Henriksen et al. 2004).
Vec3 Camera::onTrackball(Vec2 pixels) const {
  constexpr double kSmallest = 0.25;  // of the pane: a speck must not spin
  constexpr double kLargest = 0.6;    // one drag turns far also when zoomed in
  constexpr double kInner = 0.25;     // the middle half of the pane
  const PaneMap map = this->map();
  const double side = shorterSide(size_) / scale();
  const double radius = std::clamp(ball_.radius, kSmallest * side, kLargest * side);
  const Vec2 middle = map.toPixels(ball_.centre);
  const Vec2 inside{std::clamp(middle.x, kInner * size_.x, (1 - kInner) * size_.x),
                    std::clamp(middle.y, kInner * size_.y, (1 - kInner) * size_.y)};
  const Vec3 centre = map.frame.onPlane(map.toView(inside), ball_.centre, frame_.toEye);
  const Vec3 onPicture = map.frame.onPlane(map.toView(pixels), ball_.centre, frame_.toEye);
  const Vec3 towards = frame_.isPerspective() ? normalized(frame_.eye() - onPicture) : frame_.toEye;
  const Vec3 off = onPicture - centre;
  const Vec3 aside = off - towards * dot(off, towards);
  const double square = dot(aside, aside);
  const double height = square <= radius * radius / 2 ? std::sqrt(radius * radius - square)
                                                      : radius * radius / (2 * std::sqrt(square));
  return normalized(aside + towards * height);
}

/// Turns the model about the middle of the ball, which is to turn the eye the other way.
void Camera::turnModel(Vec3 unitAxis, double cos, double sin) {
  frame_.right = turned(frame_.right, unitAxis, cos, -sin);
  frame_.up = turned(frame_.up, unitAxis, cos, -sin);
  frame_.toEye = turned(frame_.toEye, unitAxis, cos, -sin);
  frame_.centre = ball_.centre + turned(frame_.centre - ball_.centre, unitAxis, cos, -sin);
  straighten(frame_);
}

void Camera::orbit(Vec2 from, Vec2 to, std::optional<Vec3> about) {
  const Vec3 a = onTrackball(from);
  const Vec3 b = onTrackball(to);
  const Vec3 axis = cross(a, b);
  const double sin = length(axis);
  if (!(sin > 0)) return;
  const Vec2 held = about ? map().toPixels(*about) : Vec2{};
  turnModel(axis / sin, dot(a, b), sin);
  if (about) pan(held - map().toPixels(*about));
}

void Camera::turn(double degreesRight, double degreesUp, double degreesRoll) {
  const CosSin right = cosSinDegrees(degreesRight);
  const CosSin up = cosSinDegrees(-degreesUp);
  const CosSin roll = cosSinDegrees(degreesRoll);
  turnModel(frame_.up, right.cos, right.sin);
  turnModel(frame_.right, up.cos, up.sin);
  turnModel(frame_.toEye, roll.cos, roll.sin);
}

void Camera::pan(Vec2 byPixels) {
  aside_ = aside_ + Vec2{-byPixels.x, byPixels.y} / pixelsPerMm_;
  isFitted_ = false;
}

void Camera::zoom(Vec2 about, double factor) {
  if (!(factor > 0)) return;
  const double now = scale();
  const double limited = limitedScale(now * factor, now, ball_.radius, size_);
  const double next = pixelsPerMm_ * (limited / now);
  aside_ = aside_ + fromMiddle(about, size_) * (1 / pixelsPerMm_ - 1 / next);
  pixelsPerMm_ = next;
  isFitted_ = false;
}

void Camera::setBall(const Sphere& ball) {
  isFitted_ = isFitted_ && ball_.centre == ball.centre && ball_.radius == ball.radius;
  ball_ = withSize(ball);
  if (!frame_.isPerspective()) return placeEye(0);
  const Vec3 eye = frame_.eye();
  const double distance = dot(eye - ball_.centre, frame_.toEye);
  if (distance < kNearestEye * ball_.radius) {
    return placeEye(eyeDistanceFor(fieldOfView_, ball_.radius));
  }
  // The same eye and the same picture, with the plane of true size through the new middle.
  const double part = distance / frame_.eyeDistance;
  frame_.centre = eye - frame_.toEye * distance;
  frame_.eyeDistance = distance;
  pixelsPerMm_ = pixelsPerMm_ / part;
  aside_ = aside_ * part;
}

void Camera::setPerspective(double fieldOfView) {
  fieldOfView_ = fieldOfView > 0 ? std::clamp(fieldOfView, kNarrowest, kWidest) : 0;
  placeEye(eyeDistanceFor(fieldOfView_, ball_.radius));
}

bool Camera::seesFront() const { return frame_.toEye.z > 0; }

PaneMap Camera::map() const {
  return {Pane::Model, frame_, pixelsPerMm_, frame_.direction(frame_.centre) + aside_, size_};
}

}  // namespace kiri
