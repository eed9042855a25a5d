// SPDX-License-Identifier: MIT
#include "core/flatfold/polish.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "core/base/text.h"
#include "core/flatfold/flat_closing.h"
#include "core/flatfold/least_change.h"
#include "core/paper/folded_state.h"

namespace kiri {
namespace {

/// A vertex that moves farther than this part of the sheet is no drawing's imprecision.
constexpr double kFarthestOfSheet = 1.0 / 200;
/// Nor one that moves farther than this part of its shortest edge.
constexpr double kFarthestOfEdge = 1.0 / 3;
/// Borders that turn by less, radians, and lie no farther beside a line than this part of the
/// sheet, are one side.
constexpr double kSideTurn = 1.0 / 16;
constexpr double kSideBeside = 1.0 / 2000;
/// What a pattern may stretch of the kernel's tolerance before it is polished: steps to come have
/// the rest.
constexpr double kExactPart = 1.0 / 8;

double degreesOf(double radians) { return radians * 180 / std::numbers::pi; }

/// The stretch of the pattern folded flat, as the kernel's poses have it.
double flatStretch(const CreasePattern& pattern) {
  FoldedState state(pattern);
  const std::vector<std::uint32_t> piece = piecesOf(pattern);
  std::vector<double> largest;
  for (std::size_t f = 0; f < piece.size(); ++f) {
    double area = 0;
    for (const EdgeUse use : pattern.facets[f].border) area += doubleArea(arcOf(pattern, use));
    if (piece[f] == largest.size()) {
      largest.push_back(0);
      state.rests.push_back({FacetId(f), Rigid{}});
    }
    if (area <= largest[piece[f]]) continue;
    largest[piece[f]] = area;
    state.rests[piece[f]].facet = FacetId(f);
  }
  state.poses = derivePoses(state.pattern, state.rests);
  return stretchOf(state);
}

std::vector<VertexFreedom> freedomsOf(const CreasePattern& pattern) {
  std::vector<std::vector<VertexId>> rims(pattern.vertices.size());
  for (const Edge& edge : pattern.edges) {
    if (edge.kind == EdgeKind::Hinge) continue;
    rims[edge.from.index].push_back(edge.isCurved() ? edge.from : edge.to);
    rims[edge.to.index].push_back(edge.isCurved() ? edge.to : edge.from);
  }
  std::vector<VertexFreedom> freedoms(rims.size());
  for (std::size_t v = 0; v < rims.size(); ++v) {
    VertexFreedom& freedom = freedoms[v];
    if (rims[v].empty()) freedom.directions = 2;
    if (rims[v].size() != 2) continue;
    const Vec2 middle = pattern.vertices[v];
    const Vec2 back = pattern[rims[v][0]] - middle;
    const Vec2 ahead = pattern[rims[v][1]] - middle;
    const double turn = std::atan2(std::abs(cross(back, ahead)), -dot(back, ahead));
    if (!(turn < kSideTurn)) continue;
    const Vec2 side = normalized(ahead - back);
    if (std::abs(cross(side, back)) > kSideBeside * pattern.tolerance.sheetSize()) continue;
    freedom = {1, side};
  }
  return freedoms;
}

Error oddError(const CreasePattern& pattern, const std::vector<VertexId>& odd) {
  Error error{ErrorCode::WouldStretch, {}, {}};
  for (const VertexId v : odd) error.witness.points.push_back(pattern[v]);
  error.message = "an odd number of folded creases meet at " + text(error.witness.points.front()) +
                  " mm, which never folds flat; add or take away a crease there";
  return error;
}

/// The vertex that misses most in the drawing.
Error stretchError(const FlatClosing& closing, const CreasePattern& pattern) {
  const std::vector<ClosingRow> rows = closing.rowsAt(pattern.vertices);
  const std::vector<double> arms = closing.arms();
  std::size_t worst = 0;
  double most = -1;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const double miss = std::abs(rows[i].miss) / arms[i];
    if (miss <= most) continue;
    most = miss;
    worst = i;
  }
  Error error{ErrorCode::WouldStretch, "the crease pattern does not fold flat", {}};
  if (most < 0) return error;
  const Vec2 place = closing.placesOfRows(pattern.vertices)[worst];
  error.witness.points = {place};
  error.message += ", and no small move of its vertices makes it: the creases around " +
                   text(place) + " mm miss by " + text(degreesOf(most)) +
                   " degrees; draw them again there";
  return error;
}

/// The first facet that has turned over or has no area left.
const Facet* turnedOver(const CreasePattern& pattern) {
  for (const Facet& facet : pattern.facets) {
    double twice = 0;
    const Vec2 base = pattern[startOf(pattern, facet.border.front())];
    for (const EdgeUse use : facet.border)
      twice += cross(pattern[startOf(pattern, use)] - base, pattern[endOf(pattern, use)] - base);
    const bool isCurved = std::any_of(facet.border.begin(), facet.border.end(),
                                      [&](EdgeUse use) { return pattern[use.edge].isCurved(); });
    if (!isCurved && !(twice > 0)) return &facet;
  }
  return nullptr;
}

std::vector<double> shortestEdges(const CreasePattern& pattern) {
  std::vector<double> shortest(pattern.vertices.size(), std::numeric_limits<double>::max());
  for (const Edge& edge : pattern.edges) {
    const double reach = distance(pattern[edge.from], pattern[edge.to]);
    for (const VertexId v : {edge.from, edge.to})
      shortest[v.index] = std::min(shortest[v.index], reach);
  }
  return shortest;
}

class Polisher {
 public:
  explicit Polisher(const AssignedPattern& creases)
      : creases_(creases),
        pattern_(creases.pattern),
        closing_(creases),
        freedoms_(freedomsOf(creases.pattern)),
        shortest_(shortestEdges(creases.pattern)) {}

  const FlatClosing& closing() const { return closing_; }

  /// With straight creases kept straight, or without.
  Result<Polished> polish(bool keepStraight, const Progress& progress) const {
    const std::vector<FlatClosing::Straight> straight =
        keepStraight ? closing_.straightOnes() : std::vector<FlatClosing::Straight>{};
    const RowsAt rowsAt = [&](const std::vector<Vec2>& places) {
      std::vector<ClosingRow> rows = closing_.rowsAt(places);
      for (const FlatClosing::Straight& s : straight) rows.push_back(straightRow(s, places));
      return rows;
    };
    const double mostMove = kFarthestOfSheet * pattern_.tolerance.sheetSize();
    Result<std::vector<Vec2>> places =
        leastChange(pattern_.vertices, freedoms_, rowsAt, mostMove, progress);
    if (!places) return places.error();
    Polished result{creases_, 0};
    result.creases.pattern.vertices = std::move(*places);
    return judged(std::move(result));
  }

 private:
  /// The polished pattern if it folds flat, near to the drawing.
  Result<Polished> judged(Polished result) const {
    const CreasePattern& now = result.creases.pattern;
    bool isNear = true;
    for (std::size_t v = 0; v < shortest_.size(); ++v) {
      const double move = distance(now.vertices[v], pattern_.vertices[v]);
      result.farthest = std::max(result.farthest, move);
      isNear = isNear && move <= kFarthestOfEdge * shortest_[v];
    }
    isNear = isNear && result.farthest <= kFarthestOfSheet * pattern_.tolerance.sheetSize();
    if (!isNear || flatStretch(now) > now.tolerance.length())
      return stretchError(closing_, pattern_);
    if (const Facet* facet = turnedOver(now)) {
      const Vec2 place = pattern_[startOf(pattern_, facet->border.front())];
      return Error{ErrorCode::TooThin,
                   "a facet at " + text(place) +
                       " mm is so thin that it turns over when the pattern is made to fold flat; "
                       "draw its creases farther apart",
                   {{place}, {}, {}}};
    }
    return result;
  }

  const AssignedPattern& creases_;
  const CreasePattern& pattern_;
  FlatClosing closing_;
  std::vector<VertexFreedom> freedoms_;
  std::vector<double> shortest_;
};

}  // namespace

Result<Polished> polished(const AssignedPattern& creases, const Progress& progress) {
  if (!isMeantFlat(creases))
    return Error{ErrorCode::BadValue,
                 "the crease pattern has target angles other than 0 and 180 degrees: it is not "
                 "meant to fold flat"};
  const Polisher polisher(creases);
  if (!polisher.closing().oddVertices().empty())
    return oddError(creases.pattern, polisher.closing().oddVertices());
  if (flatStretch(creases.pattern) <= kExactPart * creases.pattern.tolerance.length())
    return Polished{creases, 0};
  Result<Polished> straight = polisher.polish(true, progress);
  if (straight || straight.error().code == ErrorCode::Cancelled) return straight;
  return polisher.polish(false, progress);
}

}  // namespace kiri
