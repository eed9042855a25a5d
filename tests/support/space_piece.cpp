// SPDX-License-Identifier: MIT
#include "tests/support/space_piece.h"

#include <algorithm>
#include <cmath>
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

SpacePiece spacePieceOf(const FoldedState& state, FacetId facet, const std::vector<bool>& moves) {
  constexpr int kPieces = 32;
  const CreasePattern& pattern = state.pattern;
  const Rigid& pose = state.poseOf(facet);
  SpacePiece piece;
  piece.facet = facet;
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
                        (moves.empty() || moves[edge.left.index] == moves[edge.right.index]);
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

double borderDistance(const SpacePiece& piece, Vec3 p) {
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

bool holds(const SpacePiece& piece, Vec3 p) {
  const PlaneFrame frame = frameOf(piece.normal, piece.loops[0][0]);
  Loops flat;
  for (const std::vector<Vec3>& loop : piece.loops) {
    flat.emplace_back();
    for (const Vec3 q : loop) flat.back().push_back(frame.flatten(q));
  }
  return contains(flat, frame.flatten(p));
}

double depthOf(const SpacePiece& a, const SpacePiece& b) {
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

}  // namespace kiri::test
