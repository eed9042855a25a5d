// The unfolded margin of a leaf by reflecting the cutting curve through the folds.
// SPDX-License-Identifier: MIT
#include "tests/support/margin_reference.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace kiri::test {
namespace {

Vec2 mirrored(Vec2 p, const DrawnFold& fold) {
  const Vec2 u = normalized(fold.to - fold.from);
  const Vec2 r = p - fold.from;
  return fold.from + u * (2 * dot(r, u)) - r;
}

Vec2 at(const Piece& piece, double t) {
  const double s = 1 - t;
  return piece.p[0] * (s * s * s) + piece.p[1] * (3 * s * s * t) + piece.p[2] * (3 * s * t * t) +
         piece.p[3] * (t * t * t);
}

Vec2 slope(const Piece& piece, double t) {
  const double s = 1 - t;
  return (piece.p[1] - piece.p[0]) * (3 * s * s) + (piece.p[2] - piece.p[1]) * (6 * s * t) +
         (piece.p[3] - piece.p[2]) * (3 * t * t);
}

/// The polar form of the cubic: control points of any part are its values (the part a..b: aaa, aab,
/// abb, bbb).
Vec2 blossom(const Piece& piece, double a, double b, double c) {
  Vec2 q[3];
  for (int i = 0; i < 3; ++i) q[i] = lerp(piece.p[i], piece.p[i + 1], a);
  const Vec2 r0 = lerp(q[0], q[1], b);
  const Vec2 r1 = lerp(q[1], q[2], b);
  return lerp(r0, r1, c);
}

/// Parameter of the point nearest to p, possibly a little outside 0 to 1.
double nearest(const Piece& piece, Vec2 p) {
  double best = 0;
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i <= 200; ++i) {
    const double off = distance(at(piece, i / 200.0), p);
    if (off < least) {
      least = off;
      best = i / 200.0;
    }
  }
  for (int i = 0; i < 60; ++i) {
    const Vec2 d = slope(piece, best);
    const double step = dot(p - at(piece, best), d) / dot(d, d);
    if (!std::isfinite(step)) break;
    best += std::clamp(step, -0.05, 0.05);
  }
  return best;
}

double errorOf(const Piece& edge, const Piece& piece) {
  const double a = nearest(piece, edge.p[0]);
  const double b = nearest(piece, edge.p[3]);
  const Vec2 expected[4] = {blossom(piece, a, a, a), blossom(piece, a, a, b),
                            blossom(piece, a, b, b), blossom(piece, b, b, b)};
  double worst = 0;
  for (int i = 0; i < 4; ++i) worst = std::max(worst, distance(edge.p[i], expected[i]));
  return worst;
}

/// Bezier points of one span of a cubic B-spline with knots t[0..7], the span being t[3] to t[4]:
/// its polar form.
Piece spanPiece(const Vec2* c, const std::vector<double>& t, std::size_t first) {
  const auto polar = [c, &t, first](double u, double v, double w) {
    Vec2 d[4] = {c[0], c[1], c[2], c[3]};
    const double arguments[3] = {u, v, w};
    for (std::size_t level = 1; level <= 3; ++level) {
      for (std::size_t i = 3; i >= level; --i) {
        const double low = t[first + i];
        const double high = t[first + i + 4 - level];
        d[i] = lerp(d[i - 1], d[i], (arguments[level - 1] - low) / (high - low));
      }
    }
    return d[3];
  };
  const double a = t[first + 3];
  const double b = t[first + 4];
  return {{polar(a, a, a), polar(a, a, b), polar(a, b, b), polar(b, b, b)}};
}

}  // namespace

Carried::Carried(Vec2 paper, const std::vector<DrawnFold>& folds) {
  Vec2 image = paper;
  for (const DrawnFold& fold : folds) {
    const double side = fold.onSheet ? cross(fold.onSheet->second - fold.onSheet->first,
                                             paper - fold.onSheet->first)
                                     : cross(fold.to - fold.from, image - fold.from);
    if (side <= 0) continue;
    image = mirrored(image, fold);
    met_.push_back(fold);
  }
}

Vec2 Carried::toModel(Vec2 paper) const {
  for (const DrawnFold& fold : met_) paper = mirrored(paper, fold);
  return paper;
}

std::vector<Piece> splinePieces(const std::vector<Vec2>& controls, bool isClamped) {
  const std::size_t spans = controls.size() - 3;
  std::vector<double> knots;
  for (std::size_t i = 0; i < controls.size() + 4; ++i) {
    double knot = static_cast<double>(i) - 3;
    if (isClamped) knot = std::clamp(knot, 0.0, static_cast<double>(spans));
    knots.push_back(knot);
  }
  std::vector<Piece> pieces;
  for (std::size_t i = 0; i < spans; ++i) pieces.push_back(spanPiece(&controls[i], knots, i));
  return pieces;
}

std::vector<Piece> closedSplinePieces(const std::vector<Vec2>& controls) {
  std::vector<Vec2> around = controls;
  around.insert(around.end(), controls.begin(), controls.begin() + 3);
  return splinePieces(around, false);
}

double worstMarginError(const FoldedState& state, const std::vector<Piece>& curve,
                        const std::vector<DrawnFold>& folds) {
  double worst = 0;
  for (const Edge& edge : state.pattern.edges) {
    if (!edge.isCurved()) continue;
    const FacetId f = edge.left.isValid() ? edge.left : edge.right;
    const Carried carried(interiorPointOf(state.pattern, f), folds);
    const CurveControls& c = state.pattern.curves[edge.curve];
    const Piece mine{{carried.toModel(state.pattern[edge.from]), carried.toModel(c.control1),
                      carried.toModel(c.control2), carried.toModel(state.pattern[edge.to])}};
    double least = std::numeric_limits<double>::infinity();
    for (const Piece& piece : curve) least = std::min(least, errorOf(mine, piece));
    worst = std::max(worst, least);
  }
  return worst;
}

}  // namespace kiri::test
