// SPDX-License-Identifier: MIT
#include "editor/tools/open_flap.h"

#include "editor/snap/constructions.h"

namespace kiri {

std::optional<FlapOpening> openingUnder(const Scope& scope, const Spot& held, Vec2 pixels) {
  if (!scope.snaps.isOn) return std::nullopt;
  const FoldedState& state = *scope.state;
  std::optional<FlapOpening> best;
  double nearest = scope.snaps.radius;
  for (const EdgeUse use : state.pattern[held.facet].border) {
    const Edge& edge = state.pattern[use.edge];
    const bool isFolded = edge.kind == EdgeKind::Hinge && edge.line.isValid() &&
                          (edge.angle == 180 || edge.angle == -180);
    if (!isFolded || (edge.left == held.facet) != edge.leftMoves) continue;
    const Line2 crease{state.pattern[edge.from], state.pattern[edge.to]};
    const Vec2 place = mirrored(held.paper, crease);
    const double away = distance(scope.model.toPixels(state, {held.facet, place}), pixels);
    if (!(away < nearest)) continue;
    nearest = away;
    best = FlapOpening{state.lines[edge.line.index].name, place, crease.from, crease.to};
  }
  return best;
}

}  // namespace kiri
