// The distance within which folded points are one is found by trying.
// SPDX-License-Identifier: MIT
#include "core/flatfold/folded_ground.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

#include "core/base/text.h"
#include "core/flatfold/ground_stacks.h"
#include "core/flatfold/near_misses.h"
#include "core/flatfold/order_rules.h"
#include "core/paper/folded_state.h"

namespace kiri {
namespace {

/// Distances that are tried are not longer than this part of the shortest line.
constexpr double kCoarsestPart = 4;
/// A distance is taken when nothing was moved by more than this part of it, and nothing that is
/// apart lies nearer than this many times of it: any distance between would give the same map, so
/// it is no matter of chance. When there is none, less room must do.
constexpr int kRooms[] = {4, 2, 1};

/// Pieces that all trials together may make, and more for each line: drawings whose folds do not
/// close within their own precision crumble into ever more. Real ones need two for a line.
constexpr std::size_t kMostPieces = 400000;
constexpr std::size_t kMorePieces = 20;

/// The ground as one distance divides it.
struct Trial {
  double within = 0;
  Arrangement arrangement;
  PlanarCells cells;
  LinesAlong along;
  CellFacets facets;
};

/// True when hinges join facets that other hinges join already.
bool hasLoops(const CreasePattern& pattern) {
  const auto hinges = static_cast<std::size_t>(
      std::count_if(pattern.edges.begin(), pattern.edges.end(),
                    [](const Edge& e) { return e.kind == EdgeKind::Hinge; }));
  const std::vector<std::uint32_t> pieces = piecesOf(pattern);
  return hinges + *std::max_element(pieces.begin(), pieces.end()) + 1 > pieces.size();
}

class Trials {
 public:
  Trials(const AssignedPattern& creases, const FlatMap& map, const FoldedLines& lines)
      : lines_(lines), error_(map.error), paper_(areaOf(creases.pattern)) {
    const Tolerance& tolerance = creases.pattern.tolerance;
    double shortest = tolerance.sheetSize();
    for (const std::array<std::uint32_t, 2>& ends : lines.ends) {
      const double line = distance(lines.points[ends[0]], lines.points[ends[1]]);
      if (line > 0) shortest = std::min(shortest, line);
      total_ += line;
    }
    piecesLeft_ = kMostPieces + kMorePieces * lines.ends.size();
    coarsest_ = shortest / kCoarsestPart;
    finest_ = std::min(tolerance.length(), coarsest_ / kCoarsestPart);
    // Where no loop of hinges says how precise the drawing is, the usual precision is expected.
    noise_ = hasLoops(creases.pattern) ? std::max(map.error, finest_) : tolerance.thin();
  }

  /// None when all distances fail.
  std::optional<Trial> best(const Progress& progress, bool& wasCancelled) {
    const NearMisses misses(lines_, finest_, 2 * coarsest_);
    double part = 0;
    for (const int room : kRooms) {
      for (const double within : misses.gaps(noise_, room)) {
        // Of an unknown number of trials most are the first.
        part += (1 - part) / 2;
        if (!goesOn(progress, part)) {
          wasCancelled = true;
          return std::nullopt;
        }
        if (std::optional<Trial> trial = tryWithin(within, room)) return trial;
        if (piecesLeft_ == 0) return std::nullopt;
      }
    }
    return std::nullopt;
  }

 private:
  std::optional<Trial> tryWithin(double within, double room) {
    std::optional<Arrangement> arrangement =
        arrange(lines_.points, lines_.ends, within, piecesLeft_);
    if (!arrangement || arrangement->farthest * room > within) return std::nullopt;
    const double most = room * within;
    if (room > 1 && clearanceOf(*arrangement, most) < most) return std::nullopt;
    std::optional<PlanarCells> cells = cellsOf(*arrangement);
    if (!cells) return std::nullopt;
    Trial trial{within, std::move(*arrangement), std::move(*cells), {}, {}};
    trial.along = linesAlong(trial.arrangement);
    trial.facets = facetsOfCells(trial.arrangement, trial.cells, lines_, trial.along);
    if (trial.facets.wrongAt || !coversPaper(trial)) return std::nullopt;
    return trial;
  }

  /// The layers of all cells together are the paper, but for strips as wide as points were moved.
  bool coversPaper(const Trial& trial) const {
    double covered = 0;
    for (std::size_t c = 1; c < trial.cells.corners.size(); ++c)
      covered += areaOf(trial.arrangement, trial.cells.corners[c]) *
                 static_cast<double>(trial.facets.of[c].size());
    return std::abs(covered - paper_) <=
           2 * (trial.arrangement.farthest + error_) * total_ + kParallel * paper_;
  }

  const FoldedLines& lines_;
  double error_;
  double paper_;
  double total_ = 0;  ///< length of all lines
  double coarsest_ = 0;
  double finest_ = 0;
  double noise_ = 0;
  std::size_t piecesLeft_ = 0;
};

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

Error noMap(const AssignedPattern& creases, const FlatMap& map) {
  const CreasePattern& pattern = creases.pattern;
  EdgeId shortest(0);
  const auto lengthOf = [&](EdgeId e) {
    return distance(pattern[pattern[e].from], pattern[pattern[e].to]);
  };
  for (std::size_t e = 1; e < pattern.edges.size(); ++e) {
    if (lengthOf(EdgeId(e)) < lengthOf(shortest)) shortest = EdgeId(e);
  }
  const Vec2 from = pattern[pattern[shortest].from];
  const Vec2 to = pattern[pattern[shortest].to];
  return {ErrorCode::BadValue,
          "the folded creases lie so that it cannot be told which facets overlap: facets disagree "
          "by up to " +
              text(map.error) + " mm, and the shortest line, from " + text(from) + " to " +
              text(to) + ", is " + text(lengthOf(shortest)) +
              " mm long; draw the pattern more precisely",
          {{}, {{from, to}}, {}}};
}

}  // namespace

Result<GroundAndOrders> overlapsOf(const AssignedPattern& creases, const FlatMap& map,
                                   const Progress& progress) {
  const Error cancelled{ErrorCode::Cancelled, "dividing the folded ground was stopped", {}};
  const FoldedLines lines = foldedLinesOf(creases, map);
  bool wasCancelled = false;
  const Progress first = [&](double part) { return goesOn(progress, 0.5 * part); };
  std::optional<Trial> trial = Trials(creases, map, lines).best(first, wasCancelled);
  if (wasCancelled) return cancelled;
  if (!trial) return noMap(creases, map);
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
