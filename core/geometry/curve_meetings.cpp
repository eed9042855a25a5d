// Two cubics are halved until a pair of pieces lies apart, crosses once for certain, or is as good
// as straight. SPDX-License-Identifier: MIT
#include "core/geometry/curve_meetings.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>

namespace kiri {
namespace {

struct Piece {
  std::array<Vec2, 4> points;
  Span span;

  double size() const {
    return std::max({std::abs(points[3].x - points[0].x), std::abs(points[3].y - points[0].y),
                     std::abs(points[1].x - points[0].x), std::abs(points[1].y - points[0].y),
                     std::abs(points[2].x - points[0].x), std::abs(points[2].y - points[0].y)});
  }
  /// Largest second difference: the piece strays at most 3/4 of it from its chord.
  double bend() const {
    return std::max(length(points[0] - points[1] * 2 + points[2]),
                    length(points[1] - points[2] * 2 + points[3]));
  }
};

Piece pieceOf(const Arc& arc, Span span) {
  const Arc p = part(arc, span.low, span.high);
  return {{p.start, p.control1, p.control2, p.end}, span};
}

std::array<Piece, 2> halves(const Piece& p) {
  const auto middle = [](Vec2 a, Vec2 b) { return (a + b) * 0.5; };
  const Vec2 a = middle(p.points[0], p.points[1]);
  const Vec2 b = middle(p.points[1], p.points[2]);
  const Vec2 c = middle(p.points[2], p.points[3]);
  const Vec2 ab = middle(a, b);
  const Vec2 bc = middle(b, c);
  const Vec2 m = middle(ab, bc);
  const double t = 0.5 * (p.span.low + p.span.high);
  return {
      {{{p.points[0], a, ab, m}, {p.span.low, t}}, {{m, bc, c, p.points[3]}, {t, p.span.high}}}};
}

/// The extent of points along a direction.
Span extent(const std::array<Vec2, 4>& points, Vec2 direction) {
  Span s{dot(points[0], direction), dot(points[0], direction)};
  for (const Vec2 p : points) {
    s.low = std::min(s.low, dot(p, direction));
    s.high = std::max(s.high, dot(p, direction));
  }
  return s;
}

bool areApartAlong(const Piece& a, const Piece& b, Vec2 direction, double nearness) {
  const Span p = extent(a.points, direction);
  const Span q = extent(b.points, direction);
  return p.low > q.high + nearness || q.low > p.high + nearness;
}

bool areApart(const Piece& a, const Piece& b, double nearness) {
  if (areApartAlong(a, b, {1, 0}, nearness) || areApartAlong(a, b, {0, 1}, nearness)) return true;
  for (const Piece* piece : {&a, &b}) {
    const Vec2 chord = piece->points[3] - piece->points[0];
    const double size = length(chord);
    if (size == 0) continue;
    if (areApartAlong(a, b, perpendicular(chord) / size, nearness)) return true;
    if (areApartAlong(a, b, chord / size, nearness)) return true;
  }
  return false;
}

/// True when every direction of one piece lies to the same side of every direction of the other:
/// then they cross once at most.
bool crossesOnceAtMost(const Piece& a, const Piece& b) {
  int sign = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec2 da = a.points[i + 1] - a.points[i];
    for (std::size_t j = 0; j < 3; ++j) {
      const double c = cross(da, b.points[j + 1] - b.points[j]);
      const int s = c > 0 ? 1 : (c < 0 ? -1 : 0);
      if (s == 0 || (sign != 0 && s != sign)) return false;
      sign = s;
    }
  }
  return true;
}

Vec2 secondDerivative(const Arc& arc, double t) {
  return lerp(arc.start - arc.control1 * 2 + arc.control2,
              arc.control1 - arc.control2 * 2 + arc.end, t) *
         6;
}

class Search {
 public:
  Search(const Arc& a, const Arc& b, const Tolerance& tolerance)
      : a_(a), b_(b), nearness_(tolerance.length()) {}

  void run(const Piece& a, const Piece& b) {
    std::vector<std::pair<Piece, Piece>> open{{a, b}};
    // Far more than crossings and touches need; reached only by arcs that run side by side for a
    // long way, hardly more than `nearness` apart.
    constexpr int kMostPairs = 1 << 14;
    constexpr std::size_t kMostPlaces = 128;
    for (int i = 0; i < kMostPairs && !open.empty() && found_.size() < kMostPlaces; ++i) {
      const auto [p, q] = open.back();
      open.pop_back();
      if (areApart(p, q, nearness_) || isSettled(p, q)) continue;
      if (p.size() > q.size()) {
        for (const Piece& half : halves(p)) open.emplace_back(half, q);
      } else {
        for (const Piece& half : halves(q)) open.emplace_back(p, half);
      }
    }
  }

  std::vector<Meeting> take() { return std::move(found_); }

 private:
  /// True when nothing more can be learnt by halving; notes the meeting, if there is one.
  bool isSettled(const Piece& p, const Piece& q) {
    const Meeting middle{0.5 * (p.span.low + p.span.high), 0.5 * (q.span.low + q.span.high)};
    if (crossesOnceAtMost(p, q)) {
      const std::optional<Meeting> m = crossingNear(middle);
      if (m && holds(p.span, m->t) && holds(q.span, m->u)) {
        note(*m);
        return true;
      }
    }
    if (std::max(p.bend(), q.bend()) > nearness_) return false;
    noteTouch(p, q, middle);
    return true;
  }

  static bool holds(Span s, double t) { return s.low <= t && t <= s.high; }

  void note(Meeting m) {
    if (distance(pointAt(a_, m.t), pointAt(b_, m.u)) > nearness_) return;
    const auto isSame = [&](const Meeting& other) {
      return std::abs(other.t - m.t) <= kParallel && std::abs(other.u - m.u) <= kParallel;
    };
    if (std::none_of(found_.begin(), found_.end(), isSame)) found_.push_back(m);
  }

  /// Newton's method for a(t) = b(u).
  std::optional<Meeting> crossingNear(Meeting m) const {
    constexpr int kMostSteps = 16;
    for (int i = 0; i < kMostSteps; ++i) {
      const Vec2 gap = pointAt(b_, m.u) - pointAt(a_, m.t);
      const Vec2 da = tangentAt(a_, m.t);
      const Vec2 db = tangentAt(b_, m.u);
      const double det = cross(da, db);
      if (det == 0) return std::nullopt;
      const Meeting next{std::clamp(m.t + cross(gap, db) / det, 0.0, 1.0),
                         std::clamp(m.u + cross(gap, da) / det, 0.0, 1.0)};
      const double step = std::max(std::abs(next.t - m.t), std::abs(next.u - m.u));
      m = next;
      if (step <= 2 * std::numeric_limits<double>::epsilon()) break;
    }
    if (distance(pointAt(a_, m.t), pointAt(b_, m.u)) > nearness_) return std::nullopt;
    return m;
  }

  /// Pieces that are straight but for `nearness` and run side by side: the place where the arcs are
  /// parallel.
  void noteTouch(const Piece& p, const Piece& q, Meeting m) {
    const Meeting start = m;
    constexpr int kMostSteps = 12;
    for (int i = 0; i < kMostSteps; ++i) {
      const Vec2 gap = pointAt(a_, m.t) - pointAt(b_, m.u);
      const Vec2 da = tangentAt(a_, m.t);
      const Vec2 db = tangentAt(b_, m.u);
      // cross(da, db) = 0 and dot(gap, da) = 0
      const double ft = cross(secondDerivative(a_, m.t), db);
      const double fu = cross(da, secondDerivative(b_, m.u));
      const double gt = dot(da, da);
      const double gu = -dot(db, da);
      const double f = cross(da, db);
      const double g = dot(gap, da);
      const double det = ft * gu - fu * gt;
      if (det == 0) break;
      m.t = std::clamp(m.t - (f * gu - fu * g) / det, 0.0, 1.0);
      m.u = std::clamp(m.u - (ft * g - f * gt) / det, 0.0, 1.0);
    }
    const double reach = 2 * std::max(p.size(), q.size());
    const bool stayed = distance(pointAt(a_, m.t), pointAt(a_, start.t)) <= reach;
    if (stayed && distance(pointAt(a_, m.t), pointAt(b_, m.u)) <= nearness_) {
      note(m);
    } else if (const std::optional<Meeting> crossing = crossingNear(start)) {
      const bool isHere = distance(pointAt(a_, crossing->t), pointAt(a_, start.t)) <= reach;
      if (isHere) note(*crossing);
    } else {
      noteNearest(p, q);
    }
  }

  /// The ends of straight pieces, each with the point of the other piece nearest to it.
  void noteNearest(const Piece& p, const Piece& q) {
    const auto along = [](const Piece& piece, Vec2 at) {
      const Vec2 chord = piece.points[3] - piece.points[0];
      const double square = dot(chord, chord);
      const double s =
          square > 0 ? std::clamp(dot(at - piece.points[0], chord) / square, 0.0, 1.0) : 0.0;
      return piece.span.low + s * (piece.span.high - piece.span.low);
    };
    note({p.span.low, along(q, p.points[0])});
    note({p.span.high, along(q, p.points[3])});
    note({along(p, q.points[0]), q.span.low});
    note({along(p, q.points[3]), q.span.high});
  }

  const Arc& a_;
  const Arc& b_;
  double nearness_;
  std::vector<Meeting> found_ = {};
};

}  // namespace

std::vector<Meeting> curveMeetings(const Arc& a, Span s, const Arc& b, Span r,
                                   const Tolerance& tolerance) {
  Search search(a, b, tolerance);
  search.run(pieceOf(a, s), pieceOf(b, r));
  return search.take();
}

}  // namespace kiri
