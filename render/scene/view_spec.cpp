// How a picture of the folded model is taken, in the words of a person.
// SPDX-License-Identifier: MIT
#include "render/scene/view_spec.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "core/base/text.h"
#include "core/paper/boxes.h"
#include "render/scene/shadow.h"
#include "render/scene/spread.h"

namespace kiri {
namespace {

Status within(double value, double low, double high, const char* what, const char* unit) {
  if (value >= low && value <= high) return std::monostate{};
  return Error{ErrorCode::BadValue,
               std::string(what) + " must lie between " + text(low) + " and " + text(high) + unit,
               {}};
}

}  // namespace

Status checkViewSpec(const ViewSpec& spec) {
  constexpr double kFullTurn = 360;
  constexpr double kPole = 90;
  constexpr double kWidest = 120;
  constexpr double kFarthest = 1000;
  for (const Status& status :
       {within(spec.azimuth, -kFullTurn, kFullTurn, "the azimuth of a view", " degrees"),
        within(spec.elevation, -kPole, kPole, "the elevation of a view", " degrees"),
        within(spec.fieldOfView, 0, kWidest, "the field of view", " degrees (0: no perspective)"),
        within(spec.explode, 0, kFarthest, "the gap between exploded layers", " mm"),
        within(spec.thickness, 0, kFarthest, "the thickness of the paper", " mm")}) {
    if (!status) return status;
  }
  return std::monostate{};
}

std::optional<FoldedState> spreadFor(const FoldedState& state, const ViewSpec& spec) {
  const double gap = spec.explode + spec.thickness;
  if (!(gap > 0)) return std::nullopt;
  return spread(state, gap, spec.explode == 0);
}

Sphere sphereOf(const FoldedState& state, const ViewSpec& spec) {
  if (const std::optional<FoldedState> shown = spreadFor(state, spec)) {
    ViewSpec rest = spec;
    rest.explode = rest.thickness = 0;
    return sphereOf(*shown, rest);
  }
  Sphere sphere{modelBoxOf(state).middle(), 0};
  const auto grow = [&](Vec3 p) {
    sphere.radius = std::max(sphere.radius, distance(sphere.centre, p));
  };
  for (std::size_t i = 0; i < state.pattern.facets.size(); ++i) {
    for (const EdgeUse use : state.pattern.facets[i].border) {
      const Arc arc = arcOf(state.pattern, use);
      grow(state.poses[i].apply(arc.start));
      if (!arc.isCurved) continue;
      grow(state.poses[i].apply(arc.control1));  // the curve lies between its control points
      grow(state.poses[i].apply(arc.control2));
    }
  }
  if (spec.hasShadow) {
    for (const Vec3 p : shadowPoints(state)) grow(p);
  }
  return sphere;
}

Sphere joined(const Sphere& a, const Sphere& b) {
  const double apart = distance(a.centre, b.centre);
  if (apart + b.radius <= a.radius) return a;
  if (apart + a.radius <= b.radius) return b;
  const double radius = (apart + a.radius + b.radius) / 2;
  return {a.centre + (b.centre - a.centre) * ((radius - a.radius) / apart), radius};
}

Result<ViewFrame> frameOf(const ViewSpec& spec, const Sphere& sphere) {
  const Status status = checkViewSpec(spec);
  if (!status) return status.error();
  const ViewFrame view = viewFrom(spec.azimuth, spec.elevation);
  if (!(spec.fieldOfView > 0) || !(sphere.radius > 0)) return view;
  return withEye(view, sphere, sphere.radius / cosSinDegrees(spec.fieldOfView / 2).sin);
}

Result<ViewFrame> withEye(const ViewFrame& view, const Sphere& sphere, double distance) {
  constexpr double kNearest = 10.0 / 9;  // the nearest point of the ball is enlarged tenfold there
  if (!(distance >= kNearest * sphere.radius)) {
    return Error{ErrorCode::BadValue,
                 "the eye would be " + text(distance) +
                     " mm from the middle of the model, inside it or too close; choose at least " +
                     text(kNearest * sphere.radius) + " mm",
                 {}};
  }
  ViewFrame out = view;
  out.centre = sphere.centre;
  out.eyeDistance = distance;
  return out;
}

Box boxOf(const ViewFrame& view, const Sphere& sphere) {
  const Vec2 middle = view.project(sphere.centre);
  double radius = sphere.radius;
  if (view.isPerspective()) {  // the cone that touches the ball, in the plane through its middle
    const double away = view.eyeDistance;
    radius = away * radius / std::sqrt(away * away - radius * radius);
  }
  const Vec2 half{radius, radius};
  return {middle - half, middle + half};
}

}  // namespace kiri
