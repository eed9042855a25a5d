// Where folded hinges are divided, so that the paper on both sides of them shares its points.
// SPDX-License-Identifier: MIT
#include "render/mesh/hinge_breaks.h"

#include <algorithm>
#include <cmath>

namespace kiri {

bool isFoldedHinge(const Edge& edge) {
  return edge.kind == EdgeKind::Hinge && std::abs(edge.angle) > kSameAngle;
}

HingeBreaks::HingeBreaks(const FoldedState& state, const std::vector<PlaneRegions>& planes)
    : tolerance_(kParallel) {
  for (const PlaneRegions& plane : planes) {
    collect(state.pattern, plane.fromAbove);
    collect(state.pattern, plane.fromBelow);
  }
  for (std::uint32_t e = 0; e < state.pattern.edges.size(); ++e) {
    if (isFoldedHinge(state.pattern.edges[e])) breaks_.emplace_back(e, 0);
  }
  std::sort(breaks_.begin(), breaks_.end());
  const auto isSame = [&](const auto& a, const auto& b) {
    return a.first == b.first && b.second - a.second <= tolerance_;
  };
  breaks_.erase(std::unique(breaks_.begin(), breaks_.end(), isSame), breaks_.end());
}

void HingeBreaks::collect(const CreasePattern& pattern, const VisibleRegions& regions) {
  for (const VisibleFacet& part : regions.facets) {
    for (const auto& loop : part.loops) {
      for (const BoundaryPiece& piece : loop) {
        if (!piece.edge.isValid() || !isFoldedHinge(pattern[piece.edge])) continue;
        for (const double t : {piece.from, piece.to}) {
          if (t > tolerance_ && t < 1 - tolerance_) breaks_.emplace_back(piece.edge.index, t);
        }
      }
    }
  }
}

std::vector<double> HingeBreaks::within(EdgeId hinge, double from, double to) const {
  const double low = std::min(from, to);
  const double high = std::max(from, to);
  std::vector<double> out;
  auto it =
      std::upper_bound(breaks_.begin(), breaks_.end(), std::pair{hinge.index, low + tolerance_});
  for (; it != breaks_.end() && it->first == hinge.index && it->second < high - tolerance_; ++it) {
    out.push_back((it->second - from) / (to - from));
  }
  if (to < from) std::reverse(out.begin(), out.end());
  return out;
}

std::size_t HingeBreaks::intervalAt(EdgeId hinge, double t) const {
  const auto it = std::upper_bound(breaks_.begin(), breaks_.end(), std::pair{hinge.index, t});
  return static_cast<std::size_t>(it - breaks_.begin()) - 1;
}

}  // namespace kiri
