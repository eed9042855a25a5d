// SPDX-License-Identifier: MIT
#include "core/flatfold/flat_closing.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

#include "core/linkage/loops.h"

namespace kiri {
namespace {

using Complex = std::complex<double>;

Complex asComplex(Vec2 v) { return {v.x, v.y}; }

/// z -> turn * z + shift, or of the conjugate of z.
struct PlaneMotion {
  Complex turn{1, 0};
  Complex shift{0, 0};
  bool isMirrored = false;
};

/// First `second`, then `first`.
PlaneMotion after(const PlaneMotion& first, const PlaneMotion& second) {
  if (!first.isMirrored)
    return {first.turn * second.turn, first.turn * second.shift + first.shift, second.isMirrored};
  return {first.turn * std::conj(second.turn), first.turn * std::conj(second.shift) + first.shift,
          !second.isMirrored};
}

PlaneMotion reflectionAt(Complex a, Complex b) {
  const Complex way = b - a;
  const Complex turn = way / std::conj(way);
  return {turn, a - turn * std::conj(a), true};
}

/// How a reflection changes when the two points of its line move by `da` and `db`: a motion without
/// the identity.
PlaneMotion reflectionSlope(Complex a, Complex b, Complex da, Complex db) {
  const Complex way = b - a;
  const Complex dway = db - da;
  const Complex turn = way / std::conj(way);
  const Complex dturn = (dway - turn * std::conj(dway)) / std::conj(way);
  return {dturn, da - dturn * std::conj(a) - turn * std::conj(da), true};
}

/// What becomes of a slope of a motion when motions are made before and after: `left` after the
/// changed motion after `right`.
PlaneMotion carried(const PlaneMotion& left, const PlaneMotion& slope, const PlaneMotion& right) {
  PlaneMotion result = after({slope.turn, slope.shift, slope.isMirrored}, right);
  // A slope has no constant part of its own: the shift of `left` does not come in.
  if (!left.isMirrored) return {left.turn * result.turn, left.turn * result.shift, false};
  return {left.turn * std::conj(result.turn), left.turn * std::conj(result.shift), false};
}

VertexId middleOf(const CreasePattern& pattern, const HingeLoop& loop) {
  const Edge& edge = pattern[loop.crossings.front().hinge];
  return pattern[edge.from] == loop.centre ? edge.from : edge.to;
}

VertexId otherEnd(const Edge& edge, VertexId v) { return edge.from == v ? edge.to : edge.from; }

}  // namespace

FlatClosing::FlatClosing(const AssignedPattern& creases) : pattern_(creases.pattern) {
  for (const HingeLoop& loop : loopsOf(pattern_)) {
    std::vector<EdgeId> folded;
    for (const Crossing& crossing : loop.crossings) {
      if (creases.isFolded(crossing.hinge)) folded.push_back(crossing.hinge);
    }
    if (folded.empty()) continue;
    if (!loop.isVertex) {
      Ring ring;
      ring.centre = loop.centre;
      for (const EdgeId hinge : folded) {
        const Edge& edge = pattern_[hinge];
        ring.hinges.emplace_back(edge.from, edge.to);
        ring.arm = std::max(ring.arm, distance(pattern_[edge.from], loop.centre));
        ring.arm = std::max(ring.arm, distance(pattern_[edge.to], loop.centre));
      }
      if (folded.size() % 2 == 1) odd_.push_back(ring.hinges.front().first);
      rings_.push_back(std::move(ring));
      continue;
    }
    Star star;
    star.middle = middleOf(pattern_, loop);
    for (const EdgeId hinge : folded) {
      star.ends.push_back(otherEnd(pattern_[hinge], star.middle));
      const double arm = distance(pattern_[star.ends.back()], loop.centre);
      star.arm = star.arm == 0 ? arm : std::min(star.arm, arm);
    }
    if (folded.size() % 2 == 1) odd_.push_back(star.middle);
    stars_.push_back(std::move(star));
  }
}

ClosingRow FlatClosing::starRow(const Star& star, const std::vector<Vec2>& places) const {
  const Vec2 middle = places[star.middle.index];
  ClosingRow row;
  double sum = 0;
  Vec2 middleSlope;
  double sign = star.arm;
  for (const VertexId end : star.ends) {
    const Vec2 way = places[end.index] - middle;
    sum += sign / star.arm * std::atan2(way.y, way.x);
    const Vec2 slope = perpendicular(way) * (sign / dot(way, way));
    row.slopes.emplace_back(end, slope);
    middleSlope = middleSlope - slope;
    sign = -sign;
  }
  row.slopes.emplace_back(star.middle, middleSlope);
  row.miss = star.arm * std::remainder(sum - std::numbers::pi, 2 * std::numbers::pi);
  return row;
}

void FlatClosing::addRingRows(const Ring& ring, const std::vector<Vec2>& places,
                              std::vector<ClosingRow>& rows) const {
  const std::size_t n = ring.hinges.size();
  const Complex centre = asComplex(ring.centre);
  const auto end = [&](VertexId v) { return asComplex(places[v.index]) - centre; };
  std::vector<PlaneMotion> before(n + 1);  // the first i reflections
  std::vector<PlaneMotion> behind(n + 1);  // all but the first i
  for (std::size_t i = 0; i < n; ++i) {
    const auto& [a, b] = ring.hinges[i];
    before[i + 1] = after(before[i], reflectionAt(end(a), end(b)));
  }
  for (std::size_t i = n; i-- > 0;) {
    const auto& [a, b] = ring.hinges[i];
    behind[i] = after(reflectionAt(end(a), end(b)), behind[i + 1]);
  }
  const PlaneMotion whole = before[n];
  ClosingRow turn;
  ClosingRow shiftX;
  ClosingRow shiftY;
  turn.miss = ring.arm * std::arg(whole.turn);
  shiftX.miss = whole.shift.real();
  shiftY.miss = whole.shift.imag();
  for (std::size_t i = 0; i < n; ++i) {
    const auto& [a, b] = ring.hinges[i];
    for (const bool isFirst : {true, false}) {
      Vec2 slopes[3];
      for (const bool isX : {true, false}) {
        const Complex step = isX ? Complex(1, 0) : Complex(0, 1);
        const Complex none(0, 0);
        const PlaneMotion slope =
            carried(before[i],
                    reflectionSlope(end(a), end(b), isFirst ? step : none, isFirst ? none : step),
                    behind[i + 1]);
        (isX ? slopes[0].x : slopes[0].y) = ring.arm * (slope.turn / whole.turn).imag();
        (isX ? slopes[1].x : slopes[1].y) = slope.shift.real();
        (isX ? slopes[2].x : slopes[2].y) = slope.shift.imag();
      }
      turn.slopes.emplace_back(isFirst ? a : b, slopes[0]);
      shiftX.slopes.emplace_back(isFirst ? a : b, slopes[1]);
      shiftY.slopes.emplace_back(isFirst ? a : b, slopes[2]);
    }
  }
  rows.push_back(std::move(turn));
  rows.push_back(std::move(shiftX));
  rows.push_back(std::move(shiftY));
}

std::vector<ClosingRow> FlatClosing::rowsAt(const std::vector<Vec2>& places) const {
  std::vector<ClosingRow> rows;
  rows.reserve(stars_.size() + 3 * rings_.size());
  for (const Star& star : stars_) rows.push_back(starRow(star, places));
  for (const Ring& ring : rings_) addRingRows(ring, places, rows);
  return rows;
}

std::vector<Vec2> FlatClosing::placesOfRows(const std::vector<Vec2>& places) const {
  std::vector<Vec2> result;
  for (const Star& star : stars_) result.push_back(places[star.middle.index]);
  for (const Ring& ring : rings_) result.insert(result.end(), 3, ring.centre);
  return result;
}

std::vector<double> FlatClosing::arms() const {
  std::vector<double> result;
  for (const Star& star : stars_) result.push_back(star.arm);
  for (const Ring& ring : rings_) result.insert(result.end(), 3, ring.arm);
  return result;
}

std::vector<FlatClosing::Straight> FlatClosing::straightOnes() const {
  std::vector<Straight> result;
  const double near = pattern_.tolerance.length();
  for (const Star& star : stars_) {
    if (star.ends.size() == 2) continue;
    const Vec2 middle = pattern_[star.middle];
    for (std::size_t i = 0; i < star.ends.size(); ++i) {
      for (std::size_t j = i + 1; j < star.ends.size(); ++j) {
        const Vec2 from = pattern_[star.ends[i]];
        const Vec2 to = pattern_[star.ends[j]];
        if (dot(from - middle, to - middle) >= 0) continue;
        if (std::abs(cross(to - from, middle - from)) > near * distance(from, to)) continue;
        result.push_back({star.middle, star.ends[i], star.ends[j]});
      }
    }
  }
  return result;
}

ClosingRow straightRow(const FlatClosing::Straight& straight, const std::vector<Vec2>& places) {
  const Vec2 from = places[straight.from.index];
  const Vec2 to = places[straight.to.index];
  const Vec2 middle = places[straight.middle.index];
  const double reach = distance(from, to);
  const Vec2 across = perpendicular(to - from) / reach;
  const double part = dot(middle - from, to - from) / (reach * reach);
  ClosingRow row;
  row.miss = dot(across, middle - from);
  row.slopes = {{straight.middle, across},
                {straight.from, across * (part - 1)},
                {straight.to, across * -part}};
  return row;
}

}  // namespace kiri
