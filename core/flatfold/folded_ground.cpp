// The distance within which folded points are one is found by trying.
// SPDX-License-Identifier: MIT
#include "core/flatfold/folded_ground.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <string>

#include "core/base/text.h"
#include "core/flatfold/ground_stacks.h"
#include "core/flatfold/order_rules.h"

namespace kiri {
namespace {

/// The shortest line may be divided, but not more coarsely than this part of it.
constexpr double kCoarsestPart = 4;
/// A distance is sure when nothing was moved by more than a part of it, and nothing that is apart
/// lies nearer than a multiple: any distance between would give the same map. Tried first with much
/// room, then with less, at steps that do not jump over such a gap.
struct Room {
  double factor = 1;
  double step = 2;
};
constexpr Room kRooms[] = {{4, 8}, {1.5, 2}, {1, 2}};

/// The ground as one distance divides it.
struct Trial {
  double within = 0;
  Arrangement arrangement;
  PlanarCells cells;
  LinesAlong along;
  CellFacets facets;
};

class Trials {
 public:
  Trials(const AssignedPattern& creases, const FlatMap& map, const FoldedLines& lines)
      : lines_(lines), error_(map.error), paper_(areaOf(creases.pattern)) {
    double shortest = creases.pattern.tolerance.sheetSize();
    for (const std::array<std::uint32_t, 2>& ends : lines.ends) {
      const double line = distance(lines.points[ends[0]], lines.points[ends[1]]);
      if (line > 0) shortest = std::min(shortest, line);
      total_ += line;
    }
    coarsest_ = shortest / kCoarsestPart;
    finest_ = kVanishing * creases.pattern.tolerance.sheetSize();
    // Between what ought to coincide but does not, and what ought not to.
    const double low = std::max(map.error, creases.pattern.tolerance.length());
    middle_ = std::min(coarsest_, std::sqrt(low * coarsest_));
  }

  /// The distances nearest to the likely one come first. None when all fail.
  std::optional<Trial> best(const Progress& progress, bool& wasCancelled) const {
    for (std::size_t r = 0; r < std::size(kRooms); ++r) {
      double up = middle_ * kRooms[r].step;
      double down = middle_;
      while (down >= finest_ || up <= coarsest_) {
        if (!goesOn(progress, static_cast<double>(r) / std::size(kRooms))) {
          wasCancelled = true;
          return std::nullopt;
        }
        for (const double within : {down, up}) {
          if (within < finest_ || within > coarsest_) continue;
          if (std::optional<Trial> trial = tryWithin(within, kRooms[r].factor)) return trial;
        }
        down /= kRooms[r].step;
        up *= kRooms[r].step;
      }
    }
    return std::nullopt;
  }

 private:
  std::optional<Trial> tryWithin(double within, double room) const {
    std::optional<Arrangement> arrangement = arrange(lines_.points, lines_.ends, within);
    if (!arrangement || arrangement->farthest * room > within) return std::nullopt;
    if (room > 1 && !isClear(*arrangement, room * within)) return std::nullopt;
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
  double middle_ = 0;
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
