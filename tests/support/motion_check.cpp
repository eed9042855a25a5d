// SPDX-License-Identifier: MIT
#include "tests/support/motion_check.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "tests/support/plane_overlap.h"

namespace kiri::test {
namespace {

constexpr double kSeam = 1e-9;  // mm: shorter spans are rounding where two meet end to end

using Spans = std::vector<std::pair<double, double>>;

Vec3 middleOf(const std::vector<Vec3>& points) {
  Vec3 sum;
  for (const Vec3 p : points) sum = sum + p / static_cast<double>(points.size());
  return sum;
}

double segmentDistance(Vec3 a, Vec3 b, Vec3 p) {
  const Vec3 d = b - a;
  const double t = std::clamp(dot(p - a, d) / dot(d, d), 0.0, 1.0);
  return distance(a + d * t, p);
}

/// Where a line, the cut of the piece with the plane through `point`, runs inside the loops.
Spans spansAlong(const std::vector<std::vector<Vec3>>& loops, Vec3 normal, Vec3 point, Vec3 along) {
  std::vector<double> at;
  for (const std::vector<Vec3>& loop : loops) {
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const Vec3 a = loop[i];
      const Vec3 b = loop[(i + 1) % loop.size()];
      const double ha = dot(normal, a - point);
      const double hb = dot(normal, b - point);
      if ((ha < 0) != (hb < 0)) at.push_back(dot(along, a + (b - a) * (ha / (ha - hb)) - point));
    }
  }
  std::sort(at.begin(), at.end());
  Spans spans;
  for (std::size_t i = 0; i + 1 < at.size(); i += 2) spans.emplace_back(at[i], at[i + 1]);
  return spans;
}

}  // namespace

MotionCheck::MotionCheck(const FoldedState& state, const LineMotion& how)
    : motion_(how.motion), size_(state.tolerance().sheetSize()) {
  const std::size_t count = state.pattern.facets.size();
  for (std::size_t f = 0; f < count; ++f) pieces_.push_back(pieceOf(state, FacetId(f), how));
  areJoined_.assign(count, std::vector<bool>(count, false));
  for (const Edge& edge : state.pattern.edges) {
    if (edge.kind != EdgeKind::Hinge) continue;
    areJoined_[edge.left.index][edge.right.index] = true;
    areJoined_[edge.right.index][edge.left.index] = true;
  }
}

MotionCheck::Piece MotionCheck::pieceOf(const FoldedState& state, FacetId facet,
                                        const LineMotion& how) const {
  constexpr int kPieces = 32;
  const CreasePattern& pattern = state.pattern;
  const Rigid& pose = state.poseOf(facet);
  Piece piece;
  piece.facet = facet;
  piece.moves = how.moves[facet.index];
  piece.normal = pose.normal();
  const Loops flat = flatLoopsOf(pattern, facet, kPieces);
  for (const std::vector<Vec2>& loop : flat) {
    piece.loops.emplace_back();
    for (const Vec2 p : loop) piece.loops.back().push_back(pose.apply(p));
  }
  const Facet& f = pattern[facet];
  for (std::size_t i = 0; i < f.border.size(); ++i) {
    if (i == 0 || std::find(f.holeStarts.begin(), f.holeStarts.end(), i) != f.holeStarts.end())
      piece.isBorder.emplace_back();
    const Edge& edge = pattern[f.border[i].edge];
    const bool goesOn = edge.kind == EdgeKind::Hinge && edge.angle == 0 &&
                        how.moves[edge.left.index] == how.moves[edge.right.index];
    const int count = edge.isCurved() ? kPieces : 1;
    for (int k = 0; k < count; ++k) piece.isBorder.back().push_back(!goesOn);
  }
  Vec2 low = flat[0][0];
  Vec2 high = low;
  for (const Vec2 p : flat[0]) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
  constexpr int kGrid = 7;
  for (int i = 0; i < kGrid; ++i) {
    for (int j = 0; j < kGrid; ++j) {
      const Vec2 p{low.x + (high.x - low.x) * (i + 0.37) / kGrid,
                   low.y + (high.y - low.y) * (j + 0.61) / kGrid};
      if (contains(flat, p)) piece.inner.push_back(pose.apply(p));
    }
  }
  return piece;
}

Vec3 MotionCheck::turned(Vec3 p, double degrees) const {
  const double radians = degrees * std::numbers::pi / 180 * (motion_.degrees < 0 ? -1 : 1);
  const Vec3 r = p - motion_.point;
  return motion_.point + r * std::cos(radians) + cross(motion_.axis, r) * std::sin(radians) +
         motion_.axis * (dot(motion_.axis, r) * (1 - std::cos(radians)));
}

MotionCheck::Piece MotionCheck::turned(const Piece& piece, double degrees) const {
  Piece result = piece;
  for (std::vector<Vec3>& loop : result.loops) {
    for (Vec3& p : loop) p = turned(p, degrees);
  }
  result.normal = turned(piece.normal + motion_.point, degrees) - motion_.point;
  return result;
}

double MotionCheck::borderDistance(const Piece& piece, Vec3 p) {
  double nearest = HUGE_VAL;
  for (std::size_t l = 0; l < piece.loops.size(); ++l) {
    const std::vector<Vec3>& loop = piece.loops[l];
    for (std::size_t i = 0; i < loop.size(); ++i) {
      if (piece.isBorder[l][i])
        nearest = std::min(nearest, segmentDistance(loop[i], loop[(i + 1) % loop.size()], p));
    }
  }
  return nearest;
}

bool MotionCheck::holds(const Piece& piece, Vec3 p) {
  const PlaneFrame frame = frameOf(piece.normal, piece.loops[0][0]);
  Loops flat;
  for (const std::vector<Vec3>& loop : piece.loops) {
    flat.emplace_back();
    for (const Vec3 q : loop) flat.back().push_back(frame.flatten(q));
  }
  return contains(flat, frame.flatten(p));
}

double MotionCheck::depthOf(const Piece& a, const Piece& b) {
  const Vec3 line = cross(a.normal, b.normal);
  if (length(line) < 1e-7) return 0;
  const Vec3 along = normalized(line);
  // A point of both planes near the middle of one of the facets.
  const Vec3 middle = middleOf(b.loops[0]);
  const Vec3 inB = normalized(cross(b.normal, along));
  const double rise = dot(a.normal, inB);
  const Vec3 point = middle + inB * (dot(a.normal, a.loops[0][0] - middle) / rise);
  double depth = 0;
  const Spans other = spansAlong(b.loops, a.normal, point, along);
  for (const auto& [low, high] : spansAlong(a.loops, b.normal, point, along)) {
    for (const auto& [from, to] : other) {
      const double start = std::max(low, from);
      const double end = std::min(high, to);
      for (int k = 1; k < 8 && end - start > kSeam; ++k) {
        const Vec3 p = point + along * (start + (end - start) * k / 8.0);
        const double here = std::min(borderDistance(a, p), borderDistance(b, p));
        // Where corners lie on the cut, rounding may take outside for inside.
        if (here > depth && holds(a, p) && holds(b, p)) depth = here;
      }
    }
  }
  return depth;
}

double MotionCheck::depthAt(FacetId moving, FacetId resting, double degrees) const {
  return depthOf(turned(pieceNamed(moving), degrees), pieceNamed(resting));
}

double MotionCheck::deepestAt(double degrees) const {
  double depth = 0;
  for (const Piece& m : pieces_) {
    if (!m.moves) continue;
    const Piece there = turned(m, degrees);
    for (const Piece& f : pieces_) {
      if (!f.moves) depth = std::max(depth, depthOf(there, f));
    }
  }
  return depth;
}

double MotionCheck::overlapAt(FacetId moving, FacetId resting, double degrees) const {
  const Piece m = turned(pieceNamed(moving), degrees);
  const Piece& f = pieceNamed(resting);
  if (length(cross(m.normal, f.normal)) > 1e-5) return 0;
  if (std::abs(dot(f.normal, m.loops[0][0] - f.loops[0][0])) > 1e-5 * size_) return 0;
  const PlaneFrame frame = frameOf(f.normal, f.loops[0][0]);
  std::vector<Loops> both(2);
  for (std::size_t k = 0; k < 2; ++k) {
    for (const std::vector<Vec3>& loop : (k == 0 ? m : f).loops) {
      both[k].emplace_back();
      for (const Vec3 p : loop) both[k].back().push_back(frame.flatten(p));
    }
  }
  return commonOf({&both[0], &both[1]}).fatness();
}

std::optional<Crossing> MotionCheck::passing(const Piece& m, const Piece& f, double from, double to,
                                             double depth) const {
  for (const bool isOfMoving : {true, false}) {
    for (const Vec3 p : (isOfMoving ? m : f).inner) {
      // Height of the point over the plane of the other facet, in the frame of that facet.
      const Piece& ground = isOfMoving ? f : m;
      const auto there = [&](double degrees) { return turned(p, isOfMoving ? degrees : -degrees); };
      const auto height = [&](double degrees) {
        return dot(ground.normal, there(degrees) - ground.loops[0][0]);
      };
      double low = from;
      double high = to;
      const double start = height(low);
      if ((start < 0) == (height(high) < 0)) continue;
      for (int k = 0; k < 50; ++k) {
        const double middle = (low + high) / 2;
        ((height(middle) < 0) == (start < 0) ? low : high) = middle;
      }
      const Vec3 place = there(low);
      if (!holds(ground, place)) continue;
      const double deep =
          std::min(borderDistance(ground, place), borderDistance(isOfMoving ? m : f, p));
      if (deep > depth) return Crossing{low, deep, m.facet, f.facet};
    }
  }
  return std::nullopt;
}

std::optional<Crossing> MotionCheck::firstCrossing(int moments, double depth) const {
  const double whole = std::abs(motion_.degrees);
  std::optional<Crossing> first;
  for (const Piece& m : pieces_) {
    if (!m.moves) continue;
    for (const Piece& f : pieces_) {
      if (f.moves || areJoined_[m.facet.index][f.facet.index]) continue;
      for (int k = 1; k <= moments; ++k) {
        const double degrees = whole * k / (moments + 1);
        if (first && first->degrees <= degrees) break;
        const double deep = depthOf(turned(m, degrees), f);
        std::optional<Crossing> here;
        if (deep > depth) here = Crossing{degrees, deep, m.facet, f.facet};
        if (k > 1 && !here) here = passing(m, f, whole * (k - 1) / (moments + 1), degrees, depth);
        if (!here) continue;
        if (!first || here->degrees < first->degrees) first = here;
        break;
      }
    }
  }
  return first;
}

}  // namespace kiri::test
