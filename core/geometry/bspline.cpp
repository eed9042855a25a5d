// Bezier pieces of uniform cubic B-splines, by blossoming.
// SPDX-License-Identifier: MIT
#include "core/geometry/bspline.h"

#include <algorithm>
#include <array>
#include <cstddef>

#include "core/base/check.h"

namespace kiri {
namespace {

/// The piece of uniform knots that four control points make.
Arc uniformPiece(Vec2 a, Vec2 b, Vec2 c, Vec2 d) {
  const auto joint = [](Vec2 p, Vec2 q, Vec2 r) { return (p + q * 4 + r) / 6; };
  return Arc::cubic(joint(a, b, c), (b * 2 + c) / 3, (b + c * 2) / 3, joint(b, c, d));
}

/// Open spline with end knots of multiplicity four and unit steps between.
class ClampedSpline {
 public:
  explicit ClampedSpline(const std::vector<Vec2>& controls)
      : controls_(controls), last_(controls.size() - 3) {}

  /// Piece between knots k and k + 1: the blossom at (k, k, k), (k, k, k + 1), ...
  Arc piece(std::size_t k) const {
    const auto a = static_cast<double>(k);
    const double b = a + 1;
    return Arc::cubic(blossom(k, {a, a, a}), blossom(k, {a, a, b}), blossom(k, {a, b, b}),
                      blossom(k, {b, b, b}));
  }

 private:
  /// Knot i of the full vector 0 0 0 0 1 2 ... last last last last.
  double knot(std::size_t i) const {
    return i < 3 ? 0.0 : std::min(static_cast<double>(i - 3), static_cast<double>(last_));
  }

  Vec2 blossom(std::size_t k, std::array<double, 3> at) const {
    std::array<Vec2, 4> p{controls_[k], controls_[k + 1], controls_[k + 2], controls_[k + 3]};
    for (std::size_t level = 1; level <= 3; ++level) {
      for (std::size_t i = 0; i + level <= 3; ++i) {
        const double low = knot(k + i + level);
        const double high = knot(k + i + 4);
        p[i] = lerp(p[i], p[i + 1], (at[level - 1] - low) / (high - low));
      }
    }
    return p[0];
  }

  const std::vector<Vec2>& controls_;
  std::size_t last_;
};

/// Removes rounding from the joints: each piece starts where the last ended.
void joinPieces(std::vector<Arc>& pieces) {
  for (std::size_t i = 1; i < pieces.size(); ++i) pieces[i].start = pieces[i - 1].end;
}

}  // namespace

std::vector<Arc> openSpline(const std::vector<Vec2>& controls, SplineEnds ends) {
  KIRI_CHECK(controls.size() >= 4, "an open cubic spline has at least four control points");
  std::vector<Arc> pieces;
  pieces.reserve(controls.size() - 3);
  const ClampedSpline clamped(controls);
  for (std::size_t i = 0; i + 3 < controls.size(); ++i) {
    pieces.push_back(ends == SplineEnds::Clamped ? clamped.piece(i)
                                                 : uniformPiece(controls[i], controls[i + 1],
                                                                controls[i + 2], controls[i + 3]));
  }
  joinPieces(pieces);
  return pieces;
}

std::vector<Arc> closedSpline(const std::vector<Vec2>& controls) {
  const std::size_t n = controls.size();
  KIRI_CHECK(n >= 3, "a closed cubic spline has at least three control points");
  std::vector<Arc> pieces;
  pieces.reserve(n);
  for (std::size_t i = 0; i < n; ++i) {
    pieces.push_back(uniformPiece(controls[i], controls[(i + 1) % n], controls[(i + 2) % n],
                                  controls[(i + 3) % n]));
  }
  joinPieces(pieces);
  pieces.front().start = pieces.back().end;
  return pieces;
}

}  // namespace kiri
