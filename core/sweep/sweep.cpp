// SPDX-License-Identifier: MIT
#include "core/sweep/sweep.h"

#include <algorithm>

#include "core/sweep/facet_body.h"
#include "core/sweep/found.h"
#include "core/sweep/pages.h"
#include "core/sweep/pairs.h"
#include "core/sweep/slides.h"
#include "core/sweep/turn.h"

namespace kiri {
namespace {

/// Pages that lie on one side of the axis.
bool areAllPages(const std::vector<Body>& bodies) {
  return std::all_of(bodies.begin(), bodies.end(), [](const Body& body) {
    return body.stance == Stance::Page && body.width < kFullTurn;
  });
}

SweepReport reported(const Found& found, const AxisFrame& frame, const Motion& motion) {
  SweepReport report;
  report.verdict = found.isCertain ? SweepVerdict::Collides : SweepVerdict::Undecided;
  report.moving = found.moving;
  report.resting = found.resting;
  double degrees = angleDegrees(found.turn.cos, found.turn.sin);
  if (degrees < 0) degrees += 360;
  report.degrees = motion.degrees < 0 ? -degrees : degrees;
  report.place = frame.toModel(found.place);
  return report;
}

}  // namespace

SweepReport sweep(const FoldedState& state, const std::vector<bool>& moves, const Motion& motion) {
  if (motion.degrees == 0) return {};
  const AxisFrame frame(motion);
  std::vector<Body> moving;
  std::vector<Body> resting;
  for (std::size_t f = 0; f < state.pattern.facets.size(); ++f) {
    (moves[f] ? moving : resting).push_back(bodyOf(state, moves, frame, FacetId(f)));
  }
  if (moving.empty() || resting.empty()) return {};
  FirstFound found;
  meetPages(state, moving, resting, frame, found);
  if (!areAllPages(moving) || !areAllPages(resting)) {
    meetPairs(state, moves, moving, resting, frame, found);
    meetSlides(state, moves, moving, resting, frame, found);
  }
  return found.best() ? reported(*found.best(), frame, motion) : SweepReport{};
}

}  // namespace kiri
