// Curves of DXF entities as points.
// SPDX-License-Identifier: MIT
#include "io/patterns/dxf_curves.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "io/patterns/plain_number.h"

namespace kiri {

namespace {

/// How many chords keep an arc of that radius within the tolerance.
int chordsOf(double radius, double angle, double tolerance) {
  constexpr double kMostChords = 4096;
  if (!(radius > 0) || !(tolerance > 0)) return 1;
  const double step = 2 * std::acos(std::clamp(1 - tolerance / radius, -1.0, 1.0));
  const double count = step > 0 ? std::ceil(std::abs(angle) / step) : kMostChords;
  constexpr double kFewest = 2;
  return static_cast<int>(std::clamp(count, kFewest, kMostChords));
}

/// A B-spline with knots and weights, evaluated by de Boor's algorithm.
class Spline {
 public:
  explicit Spline(const DxfEntity& entity) {
    degree_ = static_cast<std::size_t>(std::clamp(entity.number(71, 3), 1.0, kHighestDegree));
    for (const DxfPair& pair : entity.pairs) {
      const double value = numberOf(pair.value).value_or(kLargestDrawn * 2);
      if (pair.code == 10) controls_.push_back({value, 0});
      if (pair.code == 20 && !controls_.empty()) controls_.back().y = value;
      if (pair.code == 11) fits_.push_back({value, 0});
      if (pair.code == 21 && !fits_.empty()) fits_.back().y = value;
      if (pair.code == 40) knots_.push_back(value);
      if (pair.code == 41) weights_.push_back(value);
      const bool isUsed = pair.code == 10 || pair.code == 20 || pair.code == 11 ||
                          pair.code == 21 || pair.code == 40 || pair.code == 41;
      isBad_ = isBad_ || (isUsed && !isDrawable(value));
    }
    weights_.resize(controls_.size(), 1);
  }

  std::vector<Vec2> points(double tolerance) const {
    if (isBad_) return {};
    if (controls_.empty()) return fits_;
    const bool isWhole =
        controls_.size() > degree_ && knots_.size() == controls_.size() + degree_ + 1 &&
        std::is_sorted(knots_.begin(), knots_.end()) &&
        std::all_of(weights_.begin(), weights_.end(), [](double weight) { return weight > 0; });
    if (!isWhole) return {};
    std::vector<Vec2> out = {at(knots_[degree_], degree_)};
    for (std::size_t span = degree_; span < controls_.size(); ++span) {
      if (knots_[span] < knots_[span + 1]) addSpan(span, tolerance, out);
    }
    return out;
  }

 private:
  static constexpr double kHighestDegree = 7;

  /// More points than this are not made finer.
  static constexpr std::size_t kManyPoints = 100'000;

  /// Halves the steps until the middle of each lies near its chord.
  void addSpan(std::size_t span, double tolerance, std::vector<Vec2>& out) const {
    constexpr int kMostSteps = 256;
    const double from = knots_[span];
    const double to = knots_[span + 1];
    int steps = 4;
    for (; steps < kMostSteps && degree_ > 1 && out.size() < kManyPoints; steps *= 2) {
      double farthest = 0;
      for (int i = 0; i < steps; ++i) {
        const auto part = [&](double k) { return from + (to - from) * k / steps; };
        const Vec2 a = at(part(i), span);
        const Vec2 b = at(part(i + 1), span);
        farthest = std::max(farthest, distance(at(part(i + 0.5), span), lerp(a, b, 0.5)));
      }
      if (farthest <= tolerance) break;
    }
    if (degree_ == 1) steps = 1;
    for (int i = 1; i <= steps; ++i) out.push_back(at(from + (to - from) * i / steps, span));
  }

  Vec2 at(double t, std::size_t span) const {
    std::array<double, 8> x{};
    std::array<double, 8> y{};
    std::array<double, 8> w{};
    for (std::size_t i = 0; i <= degree_; ++i) {
      const std::size_t c = span - degree_ + i;
      w[i] = weights_[c];
      x[i] = controls_[c].x * w[i];
      y[i] = controls_[c].y * w[i];
    }
    for (std::size_t level = 1; level <= degree_; ++level) {
      for (std::size_t i = degree_; i >= level; --i) {
        const double low = knots_[span - degree_ + i];
        const double high = knots_[span + 1 + i - level];
        const double part = high > low ? (t - low) / (high - low) : 0;
        x[i] = x[i - 1] * (1 - part) + x[i] * part;
        y[i] = y[i - 1] * (1 - part) + y[i] * part;
        w[i] = w[i - 1] * (1 - part) + w[i] * part;
      }
    }
    return Vec2{x[degree_], y[degree_]} / w[degree_];
  }

  std::size_t degree_ = 3;
  bool isBad_ = false;
  std::vector<Vec2> controls_;
  std::vector<Vec2> fits_;
  std::vector<double> knots_;
  std::vector<double> weights_;
};

}  // namespace

std::vector<Vec2> ellipsePoints(Vec2 centre, Vec2 major, Vec2 minor, double start, double end,
                                double tolerance) {
  constexpr double kTurn = 2 * std::numbers::pi;
  double sweep = std::fmod(end - start, kTurn);
  if (sweep <= 0) sweep += kTurn;
  const int chords = chordsOf(std::max(length(major), length(minor)), sweep, tolerance);
  std::vector<Vec2> out;
  for (int i = 0; i <= chords; ++i) {
    const double t = start + sweep * i / chords;
    out.push_back(centre + major * std::cos(t) + minor * std::sin(t));
  }
  return out;
}

std::vector<Vec2> bulgePoints(Vec2 from, Vec2 to, double bulge, double tolerance) {
  const double height = std::abs(bulge) * distance(from, to) / 2;
  if (!(height > tolerance)) return {from, to};
  const double angle = 4 * std::atan(bulge);
  const Vec2 chord = to - from;
  // The middle of the arc lies bulge * chord / 2 to the right of the chord's middle.
  const double radius = length(chord) * (1 + bulge * bulge) / (4 * std::abs(bulge));
  const Vec2 centre =
      lerp(from, to, 0.5) + perpendicular(chord) * ((1 - bulge * bulge) / (4 * bulge));
  const int chords = chordsOf(radius, angle, tolerance);
  std::vector<Vec2> out = {from};
  const Vec2 arm = from - centre;
  for (int i = 1; i < chords; ++i) {
    const double t = angle * i / chords;
    out.push_back(centre + arm * std::cos(t) + perpendicular(arm) * std::sin(t));
  }
  out.push_back(to);
  return out;
}

std::vector<Vec2> splinePoints(const DxfEntity& spline, double tolerance) {
  std::vector<Vec2> out = Spline(spline).points(tolerance);
  const auto isWild = [](Vec2 p) { return !isDrawable(p.x) || !isDrawable(p.y); };
  if (std::any_of(out.begin(), out.end(), isWild)) out.clear();
  return out;
}

}  // namespace kiri
