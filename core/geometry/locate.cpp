// Where a point lies in a region: winding number around exact curves.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <cstddef>

#include "core/geometry/orientation.h"
#include "core/geometry/region.h"

namespace kiri {
namespace {

/// Counts how often borders wind around one point, or notices that one passes within reach.
class Winding {
 public:
  Winding(Vec2 point, double reach) : point_(point), reach_(reach) {}

  bool touchesBorder() const { return touches_; }
  int count() const { return count_; }

  void add(const Arc& arc) {
    if (arc.isCurved) {
      addCurve(arc, kDepth);
    } else {
      addLine(arc.start, arc.end);
    }
  }

 private:
  static constexpr int kDepth = 50;

  void addLine(Vec2 a, Vec2 b) {
    const double top = std::max(a.y, b.y);
    const double bottom = std::min(a.y, b.y);
    if (point_.y > top + reach_ || point_.y < bottom - reach_) return;
    if (point_.x > std::max(a.x, b.x) + reach_) return;
    if (isNear(a, b)) {
      touches_ = true;
      return;
    }
    cross(a, b);
  }

  /// Adds the crossing of the ray from the point towards +x; the upper end of a segment does not
  /// belong to it.
  void cross(Vec2 a, Vec2 b) {
    const bool isBelowA = point_.y < a.y;
    if (isBelowA == (point_.y < b.y)) return;
    // The lower end comes first, so that the arc and its reverse always agree.
    const int side = isBelowA ? orientation(b, a, point_) : orientation(a, b, point_);
    if (side > 0) count_ += isBelowA ? -1 : 1;
  }

  bool isNear(Vec2 a, Vec2 b) const {
    const Vec2 along = b - a;
    const Vec2 to = point_ - a;
    const double square = dot(along, along);
    const double t = square > 0 ? std::clamp(dot(to, along) / square, 0.0, 1.0) : 0.0;
    const Vec2 off = to - along * t;
    return dot(off, off) <= reach_ * reach_;
  }

  void addCurve(const Arc& arc, int depth) {
    const Box box = boundsOf(arc);
    if (point_.y > box.high.y + reach_ || point_.y < box.low.y - reach_) return;
    if (point_.x > box.high.x + reach_) return;
    if (point_.x < box.low.x - reach_) {  // the ray passes the whole box: only the ends count
      const bool isBelowStart = point_.y < arc.start.y;
      if (isBelowStart != (point_.y < arc.end.y)) count_ += isBelowStart ? -1 : 1;
      return;
    }
    if (depth == 0 || isFlat(arc)) {
      addLine(arc.start, arc.end);
      return;
    }
    addCurve(part(arc, 0, 0.5), depth - 1);
    if (!touches_) addCurve(part(arc, 0.5, 1), depth - 1);
  }

  /// True when the chord stands for the curve: farther than any rounding below the reach.
  bool isFlat(const Arc& arc) const {
    const Vec2 a = arc.start - arc.control1 * 2 + arc.control2;
    const Vec2 b = arc.control1 - arc.control2 * 2 + arc.end;
    const double limit = reach_ / 64;
    return std::max(dot(a, a), dot(b, b)) <= limit * limit;
  }

  Vec2 point_;
  double reach_;
  bool touches_ = false;
  int count_ = 0;
};

}  // namespace

Where locate(const Region& region, Vec2 p, double distance) {
  Winding winding(p, distance);
  for (const Loop& loop : region.loops) {
    for (const Arc& arc : loop) {
      winding.add(arc);
      if (winding.touchesBorder()) return Where::OnBorder;
    }
  }
  return winding.count() == 0 ? Where::Outside : Where::Inside;
}

}  // namespace kiri
