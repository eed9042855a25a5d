// Where arcs meet lines and each other. Ends come first: what lies within reach of an end is the
// end. SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>

#include "core/base/check.h"
#include "core/geometry/bernstein.h"
#include "core/geometry/cubic.h"
#include "core/geometry/curve_meetings.h"
#include "core/geometry/orientation.h"

namespace kiri {
namespace {

bool isEnd(double t) { return t == 0 || t == 1; }
bool isEnd(const Meeting& m) { return isEnd(m.t) || isEnd(m.u); }

bool boxHolds(const Box& box, Vec2 p, double reach) {
  return p.x >= box.low.x - reach && p.x <= box.high.x + reach && p.y >= box.low.y - reach &&
         p.y <= box.high.y + reach;
}

/// False when `p` is certainly farther than `reach` from the arc: spares most searches for the
/// nearest point.
bool mayReach(const Arc& arc, Vec2 p, double reach, int depth = 8) {
  if (!boxHolds(boundsOf(arc), p, reach)) return false;
  if (!arc.isCurved || depth == 0) return true;
  return mayReach(part(arc, 0, 0.5), p, reach, depth - 1) ||
         mayReach(part(arc, 0.5, 1), p, reach, depth - 1);
}

/// Two arcs and what is needed again and again in finding where they meet.
class Pair {
 public:
  Pair(const Arc& a, const Arc& b, const Tolerance& tolerance)
      : a_(a), b_(b), tolerance_(tolerance), reach_(tolerance.length()) {}

  std::vector<Meeting> find() {
    if (!areNear(boundsOf(a_), boundsOf(b_), reach_)) return {};
    addEnds();
    if (!a_.isCurved && !b_.isCurved) {
      // Two lines with an end of one on the other meet nowhere else, or coincide between two ends.
      if (found_.empty()) addLineCrossing();
    } else if (!a_.isCurved || !b_.isCurved) {
      addLineAndCurve();
    } else {
      addCurves();
    }
    tidy();
    return std::move(found_);
  }

 private:
  void addEnds() {
    std::array<bool, 2> bIsDone{};
    const std::array<Vec2, 2> endsA{a_.start, a_.end};
    const std::array<Vec2, 2> endsB{b_.start, b_.end};
    for (std::size_t i = 0; i < 2; ++i) {
      bool isDone = false;
      for (std::size_t j = 0; j < 2; ++j) {
        if (distance(endsA[i], endsB[j]) > reach_) continue;
        found_.push_back({static_cast<double>(i), static_cast<double>(j)});
        isDone = bIsDone[j] = true;
      }
      if (isDone || !mayReach(b_, endsA[i], reach_)) continue;
      const Nearest nearest = nearestOn(b_, endsA[i]);
      if (nearest.distance <= reach_) found_.push_back({static_cast<double>(i), nearest.t});
    }
    for (std::size_t j = 0; j < 2; ++j) {
      if (bIsDone[j] || !mayReach(a_, endsB[j], reach_)) continue;
      const Nearest nearest = nearestOn(a_, endsB[j]);
      if (nearest.distance <= reach_) found_.push_back({nearest.t, static_cast<double>(j)});
    }
  }

  void addLineCrossing() {
    const int start = orientation(b_.start, b_.end, a_.start);
    const int end = orientation(b_.start, b_.end, a_.end);
    if (start * end >= 0) return;
    if (orientation(a_.start, a_.end, b_.start) * orientation(a_.start, a_.end, b_.end) >= 0)
      return;
    const Vec2 along = a_.end - a_.start;
    const Vec2 other = b_.end - b_.start;
    const double det = cross(along, other);
    if (det == 0) return;
    const double t = std::clamp(cross(b_.start - a_.start, other) / det, 0.0, 1.0);
    // The nearest point of b, so that lines which are almost parallel agree about the place.
    found_.push_back({t, nearestOn(b_, pointAt(a_, t)).t});
  }

  void addLineAndCurve() {
    const Arc& line = a_.isCurved ? b_ : a_;
    const Arc& curve = a_.isCurved ? a_ : b_;
    const Vec2 along = line.end - line.start;
    const double size = length(along);
    if (size <= reach_) return;
    for (const double u : lineMeetings(curve, line.start, along, tolerance_)) {
      const double onLine = dot(pointAt(curve, u) - line.start, along) / size;
      if (onLine < -reach_ || onLine > size + reach_) continue;
      const double t = onLine <= reach_ ? 0 : (onLine >= size - reach_ ? 1 : onLine / size);
      found_.push_back(a_.isCurved ? Meeting{u, t} : Meeting{t, u});
    }
  }

  /// Two cubics are the same polynomial curve or meet in nine points at most. So where they
  /// coincide, they do so from one of the four ends to another.
  void addCurves() {
    std::sort(found_.begin(), found_.end(), isBefore);
    std::vector<Meeting> inner;
    const auto search = [&](Span s, Span r) {
      if (s.high - s.low <= kParallel || r.high - r.low <= kParallel) return;
      const std::vector<Meeting> more = curveMeetings(a_, s, b_, r, tolerance_);
      inner.insert(inner.end(), more.begin(), more.end());
    };
    const std::optional<std::pair<Meeting, Meeting>> same = commonStretch();
    if (!same) {
      search({}, {});
    } else {
      const Span s{same->first.t, same->second.t};
      const Span r{std::min(same->first.u, same->second.u),
                   std::max(same->first.u, same->second.u)};
      search({0, s.low}, {});
      search({s.high, 1}, {});
      search(s, {0, r.low});
      search(s, {r.high, 1});
    }
    found_.insert(found_.end(), inner.begin(), inner.end());
  }

  /// The ends of a stretch along which the arcs coincide.
  std::optional<std::pair<Meeting, Meeting>> commonStretch() const {
    for (std::size_t i = 0; i < found_.size(); ++i) {
      for (std::size_t j = found_.size(); j-- > i + 1;) {
        if (!isSamePlace(found_[i], found_[j]) && coincideBetween(found_[i], found_[j])) {
          return std::pair{found_[i], found_[j]};
        }
      }
    }
    return std::nullopt;
  }

  bool coincideBetween(const Meeting& m, const Meeting& n) const {
    if (m.t == n.t || m.u == n.u) return false;
    for (const double s : {0.5, 0.25, 0.75, 0.1, 0.9}) {
      const double t = m.t + (n.t - m.t) * s;
      const Vec2 p = pointAt(a_, t);
      if (!mayReach(b_, p, 2 * reach_)) return false;
      const Nearest nearest = nearestOn(b_, p);
      if (nearest.distance > 2 * reach_) return false;
      if ((nearest.t - m.u) * (nearest.t - n.u) > kParallel) return false;
    }
    return true;
  }

  /// Nearer than a vertex is to another, on both arcs.
  bool isSamePlace(const Meeting& m, const Meeting& n) const {
    if (std::abs(m.t - n.t) <= kParallel && std::abs(m.u - n.u) <= kParallel) return true;
    return isShort(a_, m.t, n.t) && isShort(b_, m.u, n.u);
  }
  bool isShort(const Arc& arc, double t0, double t1) const {
    const Vec2 p = pointAt(arc, t0);
    return distance(p, pointAt(arc, t1)) <= 2 * reach_ &&
           distance(p, pointAt(arc, 0.5 * (t0 + t1))) <= 4 * reach_;
  }

  static bool isBefore(const Meeting& m, const Meeting& n) {
    return m.t < n.t || (m.t == n.t && m.u < n.u);
  }

  double gapOf(const Meeting& m) const { return distance(pointAt(a_, m.t), pointAt(b_, m.u)); }

  /// One meeting for two that are one place: ends win, then the smaller gap.
  Meeting joined(const Meeting& m, const Meeting& n) const {
    if (isEnd(m) && isEnd(n)) return {isEnd(n.t) ? n.t : m.t, isEnd(n.u) ? n.u : m.u};
    if (isEnd(m) != isEnd(n)) return isEnd(m) ? m : n;
    return gapOf(n) < gapOf(m) ? n : m;
  }

  /// Sorts, and leaves each place once.
  void tidy() {
    std::vector<Meeting> kept;
    for (const Meeting& m : found_) {
      const auto same = std::find_if(kept.begin(), kept.end(),
                                     [&](const Meeting& k) { return isSamePlace(k, m); });
      if (same == kept.end()) {
        kept.push_back(m);
      } else {
        *same = joined(*same, m);
      }
    }
    std::sort(kept.begin(), kept.end(), isBefore);
    found_.clear();
    for (const Meeting& m : kept) {
      // A graze: the arcs stay within reach from one meeting to the next, where neither arc need
      // have an end.
      if (!found_.empty() && !(isEnd(found_.back()) && isEnd(m)) && (a_.isCurved || b_.isCurved) &&
          coincideBetween(found_.back(), m)) {
        found_.back() = joined(found_.back(), m);
      } else {
        found_.push_back(m);
      }
    }
  }

  const Arc& a_;
  const Arc& b_;
  const Tolerance& tolerance_;
  double reach_;
  std::vector<Meeting> found_ = {};
};

}  // namespace

std::vector<Meeting> meetings(const Arc& a, const Arc& b, const Tolerance& tolerance) {
  return Pair(a, b, tolerance).find();
}

std::vector<double> lineMeetings(const Arc& arc, Vec2 point, Vec2 direction,
                                 const Tolerance& tolerance) {
  const double size = length(direction);
  KIRI_CHECK(size > 0, "a line has a direction");
  const Vec2 normal = perpendicular(direction) / size;
  const auto height = [&](Vec2 p) { return dot(normal, p - point); };
  if (arc.isCurved) {
    const std::array<double, 4> heights{height(arc.start), height(arc.control1),
                                        height(arc.control2), height(arc.end)};
    return bernstein::contacts(heights, tolerance.length());
  }
  const double start = height(arc.start);
  const double end = height(arc.end);
  const bool isStartNear = std::abs(start) <= tolerance.length();
  const bool isEndNear = std::abs(end) <= tolerance.length();
  if (isStartNear && isEndNear) return {};
  if (isStartNear) return {0};
  if (isEndNear) return {1};
  if ((start < 0) == (end < 0)) return {};
  return {start / (start - end)};
}

}  // namespace kiri
