// All borders of the facets in sight, cut where they meet: a planar map of the view.
// SPDX-License-Identifier: MIT
#include "render/visibility/arrangement.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "render/visibility/grid.h"
#include "render/visibility/passing.h"
#include "render/visibility/point_index.h"

namespace kiri {
namespace {

constexpr std::uint32_t kEnd = SideUse::kEnd;

struct Split {
  double t = 0;
  std::uint32_t vertex = 0;
  bool operator<(const Split& o) const { return t != o.t ? t < o.t : vertex < o.vertex; }
};

/// A border arc before it is cut; facets whose borders run along the same arc share it.
struct Carrier {
  struct User {
    std::uint32_t facet;
    std::uint32_t arc;
    bool isSame;  ///< the facet runs along it in the direction of the carrier
  };
  Arc arc;
  std::uint32_t from = 0;
  std::uint32_t to = 0;
  std::vector<User> users;
  std::vector<Split> splits;
};

/// Finds things by the two vertices they end at, in either order, through a list for each vertex.
/// Lists hang on the later vertex: the earlier one may be the middle of a large fan.
class EndsIndex {
 public:
  /// Calls `matches(thing)` for those that end at both vertices until it says true; gives that
  /// thing, or kEnd.
  template <class Ends, class Matches>
  std::uint32_t find(std::uint32_t a, std::uint32_t b, const Ends& ends,
                     const Matches& matches) const {
    const std::uint32_t at = std::max(a, b);
    std::uint32_t i = at < first_.size() ? first_[at] : kEnd;
    for (; i != kEnd; i = next_[i]) {
      const auto [from, to] = ends(i);
      if (((from == a && to == b) || (from == b && to == a)) && matches(i)) return i;
    }
    return kEnd;
  }

  /// Adds the next thing; things are numbered as they come.
  void add(std::uint32_t a, std::uint32_t b) {
    const std::uint32_t at = std::max(a, b);
    if (at >= first_.size()) first_.resize(std::size_t{at} + 1, kEnd);
    next_.push_back(first_[at]);
    first_[at] = static_cast<std::uint32_t>(next_.size() - 1);
  }

 private:
  std::vector<std::uint32_t> first_;  ///< for each vertex
  std::vector<std::uint32_t> next_;   ///< for each thing
};

class Builder {
 public:
  Builder(const FacetViews& views, const std::vector<std::uint32_t>& inSight)
      : views_(views),
        inSight_(inSight),
        eps_(views.tolerance().match()),
        // Meetings are asked for with this wider idea of a point, for poses carry rounding.
        wide_(views.tolerance().sheetSize() * (eps_ / views.tolerance().length())),
        points_(eps_) {}

  Arrangement run() {
    addBorders();
    for (const PassingLine& line : passingLines(views_, inSight_)) {
      const std::uint32_t from = points_.insert(line.from);
      const std::uint32_t to = points_.insert(line.to);
      if (from != to) addCarrier(Arc::line(line.from, line.to), from, to);
    }
    meetAll();
    makeSides();
    out_.vertices = points_.take();
    return std::move(out_);
  }

 private:
  void addBorders() {
    std::size_t count = 0;
    for (const std::uint32_t f : inSight_) count += views_.all()[f].arcs.size();
    points_.reserve(count);
    carriers_.reserve(count);
    for (const std::uint32_t f : inSight_) {
      const FacetView& view = views_.all()[f];
      for (std::uint32_t a = 0; a < view.arcs.size(); ++a) {
        const Arc& arc = view.arcs[a];
        const std::uint32_t from = points_.insert(arc.start);
        const std::uint32_t to = points_.insert(arc.end);
        if (from == to && !arc.isCurved) continue;
        Carrier& carrier = addCarrier(arc, from, to);
        const bool isSame = carrier.from == from && (from != to || isNear(carrier.arc, arc));
        carrier.users.push_back({f, a, isSame});
      }
    }
  }

  bool isNear(const Arc& a, const Arc& b) const {
    if (a.isCurved != b.isCurved) return false;
    return !a.isCurved ||
           (distance(a.control1, b.control1) <= eps_ && distance(a.control2, b.control2) <= eps_);
  }

  /// The carrier that runs along `arc` in either direction; a new one when there is none.
  Carrier& addCarrier(const Arc& arc, std::uint32_t from, std::uint32_t to) {
    const auto ends = [&](std::uint32_t c) {
      return std::pair{carriers_[c].from, carriers_[c].to};
    };
    const auto matches = [&](std::uint32_t c) {
      return isNear(carriers_[c].arc, carriers_[c].from == from ? arc : reversed(arc));
    };
    const std::uint32_t known = carriersByEnds_.find(from, to, ends, matches);
    if (known != kEnd) return carriers_[known];
    carriersByEnds_.add(from, to);
    Carrier& made = carriers_.emplace_back();
    made.arc = arc;
    made.arc.start = points_.points()[from];
    made.arc.end = points_.points()[to];
    made.from = from;
    made.to = to;
    return made;
  }

  /// Finds where carriers meet, with a grid for candidates.
  void meetAll() {
    if (carriers_.empty()) return;
    std::vector<Box> boxes;
    Box all = boundsOf(carriers_.front().arc);
    Vec2 sum;
    for (const Carrier& c : carriers_) {
      boxes.push_back(grown(boundsOf(c.arc), eps_));
      all = joined(all, boxes.back());
      sum = sum + (boxes.back().high - boxes.back().low);
    }
    Grid grid(all, sum / static_cast<double>(carriers_.size()), carriers_.size());
    for (std::uint32_t i = 0; i < carriers_.size(); ++i) {
      const Arc& arc = carriers_[i].arc;
      if (arc.isCurved) {
        grid.addBox(boxes[i], i);
      } else {
        grid.addSegment(arc.start, arc.end, 2 * eps_, i);
      }
    }
    std::vector<std::uint32_t> met(carriers_.size(), kEnd);
    for (std::uint32_t i = 0; i < carriers_.size(); ++i) {
      const auto look = [&](std::uint32_t j) {
        if (j >= i || met[j] == i || !boxesMeet(boxes[i], boxes[j], 0)) return;
        met[j] = i;
        meet(carriers_[i], carriers_[j]);
      };
      grid.visit(boxes[i], look);
    }
  }

  void meet(Carrier& a, Carrier& b) {
    if (a.arc.isCurved || b.arc.isCurved) {
      for (const Meeting& m : meetings(a.arc, b.arc, wide_)) {
        const std::uint32_t vertex = points_.insert(pointAt(a.arc, m.t));
        split(a, m.t, vertex);
        split(b, m.u, vertex);
      }
      return;
    }
    meetStraight(a, b);
  }

  void meetStraight(Carrier& a, Carrier& b) {
    const double a0 = heightOver(b.arc, a.arc.start);
    const double a1 = heightOver(b.arc, a.arc.end);
    if ((a0 > eps_ && a1 > eps_) || (a0 < -eps_ && a1 < -eps_)) return;
    const double b0 = heightOver(a.arc, b.arc.start);
    const double b1 = heightOver(a.arc, b.arc.end);
    if ((b0 > eps_ && b1 > eps_) || (b0 < -eps_ && b1 < -eps_)) return;
    touch(a, b.from, b0);
    touch(a, b.to, b1);
    touch(b, a.from, a0);
    touch(b, a.to, a1);
    const bool isCrossing = ((a0 < 0) != (a1 < 0)) && ((b0 < 0) != (b1 < 0));
    if (!isCrossing || a.from == b.from || a.from == b.to || a.to == b.from || a.to == b.to) return;
    if (std::max(std::abs(a0), std::abs(a1)) <= eps_ ||
        std::max(std::abs(b0), std::abs(b1)) <= eps_)
      return;
    const double t = a0 / (a0 - a1);
    const std::uint32_t vertex = points_.insert(pointAt(a.arc, t));
    split(a, t, vertex);
    split(b, b0 / (b0 - b1), vertex);
  }

  /// Signed distance from the line of a straight arc, positive on its left.
  static double heightOver(const Arc& line, Vec2 p) {
    const Vec2 d = line.end - line.start;
    return cross(d, p - line.start) / length(d);
  }

  /// Cuts a straight carrier at a vertex that lies on it.
  void touch(Carrier& carrier, std::uint32_t vertex, double height) {
    if (std::abs(height) > eps_) return;
    const Vec2 d = carrier.arc.end - carrier.arc.start;
    const double t = dot(points_.points()[vertex] - carrier.arc.start, d) / dot(d, d);
    if (t > 0 && t < 1) split(carrier, t, vertex);
  }

  static void split(Carrier& carrier, double t, std::uint32_t vertex) {
    if (vertex == carrier.from && (t < 0.5 || !carrier.arc.isCurved)) return;
    if (vertex == carrier.to && (t >= 0.5 || !carrier.arc.isCurved)) return;
    carrier.splits.push_back({t, vertex});
  }

  void makeSides() {
    out_.sides.reserve(carriers_.size() * 2);
    for (Carrier& carrier : carriers_) {
      std::vector<Split>& splits = carrier.splits;
      splits.push_back({1, carrier.to});
      std::sort(splits.begin(), splits.end());
      Split last{0, carrier.from};
      for (const Split& s : splits) {
        if (s.vertex == last.vertex && !isLoop(carrier, last.t, s.t)) continue;
        addSide(carrier, last, s);
        last = s;
      }
    }
  }

  /// The stretch between the same vertex twice is real paper border, not a point.
  bool isLoop(const Carrier& carrier, double t0, double t1) const {
    if (!carrier.arc.isCurved) return false;
    return distance(pointAt(carrier.arc, (t0 + t1) / 2), pointAt(carrier.arc, t0)) > 4 * eps_;
  }

  void addSide(const Carrier& carrier, const Split& from, const Split& to) {
    Arc arc = carrier.arc.isCurved ? part(carrier.arc, from.t, to.t) : carrier.arc;
    arc.start = points_.points()[from.vertex];
    arc.end = points_.points()[to.vertex];
    const auto ends = [&](std::uint32_t i) {
      return std::pair{out_.sides[i].from, out_.sides[i].to};
    };
    const auto matches = [&](std::uint32_t i) { return coincide(out_.sides[i].arc, arc); };
    std::uint32_t same = sidesByEnds_.find(from.vertex, to.vertex, ends, matches);
    if (same == kEnd) {
      same = static_cast<std::uint32_t>(out_.sides.size());
      out_.sides.push_back({from.vertex, to.vertex, arc, kEnd});
      sidesByEnds_.add(from.vertex, to.vertex);
    }
    Side& side = out_.sides[same];
    const bool isForward =
        side.from == from.vertex && (from.vertex != to.vertex || isAlong(side.arc, arc));
    for (const Carrier::User& user : carrier.users) {
      double t0 = user.isSame ? from.t : 1 - from.t;
      double t1 = user.isSame ? to.t : 1 - to.t;
      if (!isForward) std::swap(t0, t1);
      out_.uses.push_back({user.facet, user.arc, t0, t1, user.isSame == isForward, side.firstUse});
      side.firstUse = static_cast<std::uint32_t>(out_.uses.size() - 1);
    }
  }

  static bool isAlong(const Arc& a, const Arc& b) {
    return dot(startDirection(a), startDirection(b)) > 0;
  }

  /// Two sides between the same vertices run along the same points.
  bool coincide(const Arc& a, const Arc& b) const {
    if (!a.isCurved && !b.isCurved) return true;
    return nearestOn(b, pointAt(a, 0.5)).distance <= 4 * eps_ &&
           nearestOn(a, pointAt(b, 0.5)).distance <= 4 * eps_;
  }

  const FacetViews& views_;
  const std::vector<std::uint32_t>& inSight_;
  double eps_;
  Tolerance wide_;
  PointIndex points_;
  std::vector<Carrier> carriers_;
  EndsIndex carriersByEnds_;
  EndsIndex sidesByEnds_;
  Arrangement out_;
};

}  // namespace

Arrangement arrange(const FacetViews& views, const std::vector<std::uint32_t>& inSight) {
  return Builder(views, inSight).run();
}

}  // namespace kiri
