// Borders of facets as they appear in a view.
// SPDX-License-Identifier: MIT
#include "render/visibility/projection.h"

#include <algorithm>

namespace kiri {
namespace {

/// The curve in the view and how it moves with the parameter of the arc on the paper.
class Rational {
 public:
  Rational(const Arc& onPaper, const Rigid& pose, const ViewFrame& view)
      : onPaper_(onPaper), pose_(pose), view_(view) {}

  double near(double t) const { return view_.enlargement(pose_.apply(pointAt(onPaper_, t))); }
  Vec2 at(double t) const { return view_.project(pose_.apply(pointAt(onPaper_, t))); }
  Vec2 speedAt(double t) const {
    const Vec3 point = pose_.apply(pointAt(onPaper_, t));
    const Vec3 speed = pose_.direction(tangentAt(onPaper_, t));
    const double near = view_.enlargement(point);
    const double nearer = near * near / view_.eyeDistance * dot(speed, view_.toEye);
    return view_.direction(speed) * near + view_.direction(point - view_.centre) * nearer;
  }

  /// The cubic with the same ends and the same speeds there.
  Arc cubic(double from, double to) const {
    const double third = (to - from) / 3;
    const Vec2 start = at(from);
    const Vec2 end = at(to);
    return Arc::cubic(start, start + speedAt(from) * third, end - speedAt(to) * third, end);
  }

  bool isNear(const Arc& arc, double from, double to, double tolerance) const {
    constexpr double kPlaces[] = {0.25, 0.5, 0.75};
    return std::all_of(std::begin(kPlaces), std::end(kPlaces), [&](double t) {
      return distance(pointAt(arc, t), at(from + (to - from) * t)) <= tolerance;
    });
  }

 private:
  const Arc& onPaper_;
  const Rigid& pose_;
  const ViewFrame& view_;
};

void divide(const Rational& curve, double from, double to, double tolerance, int depth,
            std::vector<SeenArc>& out) {
  constexpr int kDeepest = 12;
  const Arc arc = curve.cubic(from, to);
  if (depth == kDeepest || curve.isNear(arc, from, to, tolerance)) {
    out.push_back({arc, from, to, curve.near(from), curve.near(to)});
    return;
  }
  const double middle = (from + to) / 2;
  divide(curve, from, middle, tolerance, depth + 1, out);
  divide(curve, middle, to, tolerance, depth + 1, out);
}

}  // namespace

double SeenArc::onPaper(double t) const {
  if (t <= 0) return from;
  if (t >= 1) return to;
  // On a straight line the nearer half looks longer; the cubics keep the parameter.
  const double s = arc.isCurved ? t : t * nearEnd / (t * nearEnd + (1 - t) * nearStart);
  return from + (to - from) * s;
}

void appendSeen(const Arc& onPaper, const Rigid& pose, const ViewFrame& view, double tolerance,
                std::vector<SeenArc>& out) {
  const Rational curve(onPaper, pose, view);
  if (!onPaper.isCurved) {
    out.push_back({Arc::line(curve.at(0), curve.at(1)), 0, 1, curve.near(0), curve.near(1)});
    return;
  }
  if (view.isPerspective()) {
    divide(curve, 0, 1, tolerance, 0, out);
    return;
  }
  const auto place = [&](Vec2 p) { return view.project(pose.apply(p)); };
  out.push_back({Arc::cubic(place(onPaper.start), place(onPaper.control1), place(onPaper.control2),
                            place(onPaper.end)),
                 0, 1, 1, 1});
}

}  // namespace kiri
