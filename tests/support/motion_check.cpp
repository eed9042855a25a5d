// SPDX-License-Identifier: MIT
#include "tests/support/motion_check.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "tests/support/plane_overlap.h"

namespace kiri::test {
MotionCheck::MotionCheck(const FoldedState& state, const LineMotion& how)
    : motion_(how.motion), size_(state.tolerance().sheetSize()), moves_(how.moves) {
  const std::size_t count = state.pattern.facets.size();
  for (std::size_t f = 0; f < count; ++f)
    pieces_.push_back(spacePieceOf(state, FacetId(f), how.moves));
  areJoined_.assign(count, std::vector<bool>(count, false));
  for (const Edge& edge : state.pattern.edges) {
    if (edge.kind != EdgeKind::Hinge) continue;
    areJoined_[edge.left.index][edge.right.index] = true;
    areJoined_[edge.right.index][edge.left.index] = true;
  }
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

double MotionCheck::depthAt(FacetId moving, FacetId resting, double degrees) const {
  return depthOf(turned(pieceNamed(moving), degrees), pieceNamed(resting));
}

double MotionCheck::deepestAt(double degrees) const {
  double depth = 0;
  for (const Piece& m : pieces_) {
    if (!moves_[m.facet.index]) continue;
    const Piece there = turned(m, degrees);
    for (const Piece& f : pieces_) {
      if (!moves_[f.facet.index]) depth = std::max(depth, depthOf(there, f));
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
    if (!moves_[m.facet.index]) continue;
    for (const Piece& f : pieces_) {
      if (moves_[f.facet.index] || areJoined_[m.facet.index][f.facet.index]) continue;
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
