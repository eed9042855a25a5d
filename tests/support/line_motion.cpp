// SPDX-License-Identifier: MIT
#include "tests/support/line_motion.h"

#include <cmath>
#include <stdexcept>

namespace kiri::test {
namespace {

double offAxis(const Motion& motion, Vec3 p) {
  return length(cross(motion.axis, p - motion.point));
}

bool isOnAxis(const FoldedState& state, const Edge& edge, const Motion& motion) {
  const double tol = 1e-8 * state.tolerance().sheetSize();
  const Rigid& pose = state.poseOf(edge.left);
  return offAxis(motion, pose.apply(state.pattern[edge.from])) < tol &&
         offAxis(motion, pose.apply(state.pattern[edge.to])) < tol;
}

}  // namespace

LineMotion motionTo(const FoldedState& state, const std::string& line, double amount) {
  LineMotion result;
  result.moves.assign(state.pattern.facets.size(), false);
  std::vector<FacetId> queue;
  bool hasAxis = false;
  for (const Edge& edge : state.pattern.edges) {
    if (edge.kind != EdgeKind::Hinge || !edge.line.isValid()) continue;
    if (state.lines[edge.line.index].name != line) continue;
    if (!hasAxis) {
      const Rigid& pose = state.poseOf(edge.left);
      const Vec3 from = pose.apply(state.pattern[edge.from]);
      const Vec3 to = pose.apply(state.pattern[edge.to]);
      // Turning the right facet towards the front of the left one is a turn against from-to.
      const double degrees = edge.sign * amount - edge.angle;
      result.motion = {from, normalized(to - from), edge.leftMoves ? degrees : -degrees};
      hasAxis = true;
    }
    if (!isOnAxis(state, edge, result.motion)) throw std::runtime_error(line + " is out of line");
    queue.push_back(edge.leftMoves ? edge.left : edge.right);
  }
  if (!hasAxis) throw std::runtime_error("no hinges of " + line);
  for (const FacetId f : queue) result.moves[f.index] = true;
  for (std::size_t i = 0; i < queue.size(); ++i) {
    for (const EdgeUse use : state.pattern[queue[i]].border) {
      const Edge& edge = state.pattern[use.edge];
      if (edge.kind != EdgeKind::Hinge || isOnAxis(state, edge, result.motion)) continue;
      const FacetId next = across(edge, queue[i]);
      if (!result.moves[next.index]) queue.push_back(next);
      result.moves[next.index] = true;
    }
  }
  for (const Edge& edge : state.pattern.edges) {
    if (edge.kind != EdgeKind::Hinge || !edge.line.isValid()) continue;
    if (state.lines[edge.line.index].name == line &&
        result.moves[(edge.leftMoves ? edge.right : edge.left).index])
      throw std::runtime_error(line + " does not part the paper");
  }
  return result;
}

}  // namespace kiri::test
