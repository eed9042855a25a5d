// The distance within which folded points are one is found by trying.
// SPDX-License-Identifier: MIT
#include "core/flatfold/folded_ground.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

#include "core/base/text.h"
#include "core/flatfold/ground_stacks.h"
#include "core/flatfold/order_rules.h"

namespace kiri {
namespace {

/// Distances tried: from the shortest line / 8 by halves.
constexpr double kFirstPart = 8;
constexpr int kTrials = 40;
/// Trials one after the other that must give the same map.
constexpr int kStable = 3;

/// The ground as one distance divides it.
struct Trial {
  double within = 0;
  Arrangement arrangement;
  PlanarCells cells;
  LinesAlong along;
  CellFacets facets;

  bool isLike(const Trial& other) const {
    return arrangement.points.size() == other.arrangement.points.size() &&
           arrangement.pieces.size() == other.arrangement.pieces.size();
  }
};

double shortestLine(const FoldedLines& lines) {
  double shortest = 0;
  for (const std::array<std::uint32_t, 2>& ends : lines.ends) {
    const double length = distance(lines.points[ends[0]], lines.points[ends[1]]);
    if (length > 0 && (shortest == 0 || length < shortest)) shortest = length;
  }
  return shortest;
}

std::optional<Trial> tryWithin(const FoldedLines& lines, double within) {
  std::optional<Arrangement> arrangement = arrange(lines.points, lines.ends, within);
  if (!arrangement) return std::nullopt;
  std::optional<PlanarCells> cells = cellsOf(*arrangement);
  if (!cells) return std::nullopt;
  Trial trial{within, std::move(*arrangement), std::move(*cells), {}, {}};
  trial.along = linesAlong(trial.arrangement);
  trial.facets = facetsOfCells(trial.arrangement, trial.cells, lines, trial.along);
  if (trial.facets.wrongAt) return std::nullopt;
  return trial;
}

std::optional<Trial> stableTrial(const FoldedLines& lines, const Progress& progress,
                                 bool& wasCancelled) {
  double within = shortestLine(lines) / kFirstPart;
  std::optional<Trial> best;
  int stable = 0;
  for (int i = 0; i < kTrials; ++i, within /= 2) {
    if (!goesOn(progress, 0.5 * i / kTrials)) {
      wasCancelled = true;
      return std::nullopt;
    }
    std::optional<Trial> trial = tryWithin(lines, within);
    if (!trial) {
      stable = 0;
      best.reset();
      continue;
    }
    stable = best && trial->isLike(*best) ? stable + 1 : 1;
    best = std::move(trial);
    if (stable == kStable) return best;
  }
  return best;
}

FoldedGround groundOf(Trial& trial) {
  FoldedGround ground;
  ground.within = trial.within;
  for (std::size_t c = 1; c < trial.cells.corners.size(); ++c) {
    if (trial.facets.of[c].empty()) continue;
    ground.cells.push_back({std::move(trial.cells.corners[c]), std::move(trial.facets.of[c])});
  }
  ground.points = std::move(trial.arrangement.points);
  return ground;
}

}  // namespace

Result<GroundAndOrders> overlapsOf(const AssignedPattern& creases, const FlatMap& map,
                                   const Progress& progress) {
  const Error cancelled{ErrorCode::Cancelled, "dividing the folded ground was stopped", {}};
  const FoldedLines lines = foldedLinesOf(creases, map);
  bool wasCancelled = false;
  std::optional<Trial> trial = stableTrial(lines, progress, wasCancelled);
  if (wasCancelled) return cancelled;
  if (!trial) return Error{ErrorCode::BadValue, "the folded creases give no consistent map", {}};
  GroundAndOrders made;
  OrderProblem& problem = made.problem;
  problem.facetCount = creases.pattern.facets.size();
  problem.stacks = stacksOf(trial->cells, trial->facets);
  problem.pairs = pairsOf(problem.stacks, problem.facetCount);
  problem.indexPairs();
  const GroundLines ground{trial->arrangement, trial->cells, trial->facets, lines, trial->along};
  const Progress later = [&](double part) { return goesOn(progress, 0.5 + 0.5 * part); };
  if (!addRules(ground, problem, later)) return cancelled;
  addKnown(creases, map, problem);
  made.ground = groundOf(*trial);
  return made;
}

}  // namespace kiri
