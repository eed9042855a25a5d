// SPDX-License-Identifier: MIT
#include "editor/tools/parted_paper.h"

#include <algorithm>
#include <cmath>

#include "core/fold/fold.h"
#include "core/fold/moving_facets.h"
#include "core/paper/inscribe.h"

namespace kiri {
namespace {

void widen(Stretch& stretch, const Stretch& by, bool isFirst) {
  stretch.from = isFirst ? by.from : std::min(stretch.from, by.from);
  stretch.to = isFirst ? by.to : std::max(stretch.to, by.to);
}

/// The line, long enough to leave the paper on both sides.
FacetLine endless(const FoldedState& state, const FacetLine& line) {
  const Vec2 middle = lerp(line.from, line.to, 0.5);
  const double reach = 2 * state.tolerance().sheetSize() + distance(line.from, line.to);
  const Vec2 way = normalized(line.to - line.from) * reach;
  return {line.facet, middle - way, middle + way};
}

std::vector<Spot> rimOf(const CreasePattern& pattern, FacetId piece, FacetId facet) {
  std::vector<Spot> rim;
  const Facet& paper = pattern[piece];
  const std::size_t outer =
      paper.holeStarts.empty() ? paper.border.size() : paper.holeStarts.front();
  for (std::size_t i = 0; i < outer; ++i) {
    const Arc arc = arcOf(pattern, paper.border[i]);
    constexpr int kPieces = 6;
    const int pieces = arc.isCurved ? kPieces : 1;
    for (int p = 0; p < pieces; ++p)
      rim.push_back({facet, pointAt(arc, static_cast<double>(p) / pieces)});
  }
  return rim;
}

}  // namespace

PartedPaper::PartedPaper(const FoldedState& state, const FacetLine& line)
    : state_(state), line_(line) {
  const Rigid& pose = state.poseOf(line.facet);
  origin_ = pose.apply(line.from);
  along_ = normalized(pose.direction(line.to - line.from));
  left_ = cross(upOf(state, line.facet), along_);
  span_ = distance(line.from, line.to);
  part();
}

void PartedPaper::part() {
  const std::size_t count = state_.pattern.facets.size();
  pieces_.resize(count);
  for (std::size_t f = 0; f < count; ++f) {
    originOf_.push_back(FacetId(f));
    pieces_[f].push_back(FacetId(f));
  }
  const FacetLine whole = endless(state_, line_);
  const std::vector<FacetId> plane = state_.layers.sets()[state_.layers.setOf(line_.facet)].upward;
  for (const FacetId facet : plane) {
    const FacetLine here = lineOn(state_, whole, facet);
    const auto edges = inscribeChords(state_.pattern, facet, here.from, here.to, EdgeKind::Hinge);
    // A crease that would leave a sliver: the fold itself says so.
    if (!edges || edges->empty()) continue;
    for (const FacetId made : divideFacet(state_.pattern, facet, *edges)) {
      if (made == facet) continue;
      originOf_.push_back(facet);
      pieces_[facet.index].push_back(made);
      state_.poses.push_back(state_.poses[facet.index]);
    }
  }
}

double PartedPaper::heightOf(FacetId piece, Vec2 paper) const {
  return dot(left_, state_.poseOf(piece).apply(paper) - origin_);
}

int PartedPaper::sideOf(const Spot& spot) const {
  const double height = heightOf(spot.facet, spot.paper);
  if (std::abs(height) <= state_.tolerance().match()) return 0;
  return height > 0 ? 1 : -1;
}

int PartedPaper::sideOfPiece(FacetId piece) const {
  double farthest = 0;
  for (const EdgeUse use : state_.pattern[piece].border) {
    const Arc arc = arcOf(state_.pattern, use);
    for (const double t : {0.0, 0.5}) {
      const double height = heightOf(piece, pointAt(arc, t));
      if (std::abs(height) > std::abs(farthest)) farthest = height;
    }
  }
  return farthest > 0 ? 1 : -1;
}

bool PartedPaper::isFlatOnLine(const Edge& edge) const {
  if (edge.kind != EdgeKind::Hinge || edge.angle != 0) return false;
  const FacetId left = originOf_[edge.left.index];
  const FacetId right = originOf_[edge.right.index];
  return state_.layers.areCoplanar(left, line_.facet) &&
         state_.layers.areCoplanar(right, line_.facet) &&
         liesOnAxis(state_, edge, {origin_, along_, 0});
}

Stretch PartedPaper::stretchOf(const Edge& edge) const {
  const Rigid& pose = state_.poseOf(edge.left);
  const double a = dot(pose.apply(state_.pattern[edge.from]) - origin_, along_) / span_;
  const double b = dot(pose.apply(state_.pattern[edge.to]) - origin_, along_) / span_;
  return {std::min(a, b), std::max(a, b)};
}

std::vector<FacetId> PartedPaper::piecesAlong(const std::vector<FacetId>& facets, bool onLeft,
                                              Stretch within) const {
  std::vector<FacetId> result;
  const double least = state_.tolerance().match() / span_;
  for (const FacetId facet : facets) {
    for (const FacetId piece : pieces_[facet.index]) {
      bool isAlong = false;
      for (const EdgeUse use : state_.pattern[piece].border) {
        const Edge& edge = state_.pattern[use.edge];
        if (!isFlatOnLine(edge)) continue;
        const Stretch here = stretchOf(edge);
        isAlong |= std::min(here.to, within.to) - std::max(here.from, within.from) > least;
      }
      if (isAlong && (sideOfPiece(piece) > 0) == onLeft) result.push_back(piece);
    }
  }
  return result;
}

std::vector<FacetId> PartedPaper::pieceAt(const Spot& spot, bool onLeft) const {
  std::vector<FacetId> found;
  for (const FacetId piece : pieces_[spot.facet.index]) {
    const bool isOnSide =
        pieces_[spot.facet.index].size() == 1 || (sideOfPiece(piece) > 0) == onLeft;
    if (!isOnSide) continue;
    if (locate(regionOf(state_.pattern, piece), spot.paper, state_.tolerance().match()) !=
        Where::Outside)
      return {piece};
    found.push_back(piece);
  }
  return found;  // a place beside the paper: whatever of the facet is on that side
}

bool PartedPaper::isFree(const std::vector<FacetId>& pieces, const std::vector<bool>& moves,
                         bool leftMoves) const {
  for (const FacetId piece : pieces) {
    if ((sideOfPiece(piece) > 0) != leftMoves) return false;
    for (const EdgeUse use : state_.pattern[piece].border) {
      const Edge& edge = state_.pattern[use.edge];
      if (isFlatOnLine(edge) && moves[across(edge, piece).index]) return false;
    }
  }
  return true;
}

Reach PartedPaper::reachOf(const std::vector<FacetId>& pieces, bool leftMoves) const {
  Reach reach;
  if (pieces.empty()) return reach;
  const std::vector<bool> moves = movingFacets(state_, {origin_, along_, 0}, pieces, {}).moves;
  std::vector<FacetId> movers;
  std::vector<bool> isSeed(moves.size(), false);
  for (const FacetId piece : pieces) isSeed[piece.index] = true;
  const auto addCreases = [&](bool evenJoined) {
    for (const Edge& edge : state_.pattern.edges) {
      if (edge.kind != EdgeKind::Hinge || !(moves[edge.left.index] || moves[edge.right.index]))
        continue;
      const bool isJoined = moves[edge.left.index] && moves[edge.right.index];
      const bool isOfSeed = isSeed[edge.left.index] || isSeed[edge.right.index];
      if ((isJoined && !isOfSeed && !evenJoined) || !isFlatOnLine(edge)) continue;
      widen(reach.stretch, stretchOf(edge), reach.creases.empty());
      reach.creases.push_back(stretchOf(edge));
      reach.layers.push_back(originOf_[edge.left.index]);
      reach.layers.push_back(originOf_[edge.right.index]);
      const bool isLeft =
          isJoined ? (sideOfPiece(edge.left) > 0) == leftMoves : moves[edge.left.index];
      movers.push_back(isLeft ? edge.left : edge.right);
    }
  };
  addCreases(false);
  // Paper that hangs together round the line everywhere: the fold would stretch it, and says where.
  if (reach.layers.empty()) addCreases(true);
  std::sort(reach.layers.begin(), reach.layers.end());
  reach.layers.erase(std::unique(reach.layers.begin(), reach.layers.end()), reach.layers.end());
  std::sort(movers.begin(), movers.end());
  movers.erase(std::unique(movers.begin(), movers.end()), movers.end());
  double largest = 0;
  for (const FacetId piece : movers) {
    const FacetId facet = originOf_[piece.index];
    reach.rims.push_back(rimOf(state_.pattern, piece, facet));
    const double area = areaOf(regionOf(state_.pattern, piece));
    if (area <= largest) continue;
    largest = area;
    reach.inside = {facet, interiorPointOf(state_.pattern, piece)};
  }
  for (std::size_t f = 0; f < moves.size(); ++f) {
    if (moves[f]) reach.area += areaOf(regionOf(state_.pattern, FacetId(f)));
  }
  reach.isFree = !movers.empty() && isFree(movers, moves, leftMoves);
  return reach;
}

std::vector<Crossed> crossedBy(const FoldedState& state, const FacetLine& line, Stretch within) {
  std::vector<Crossed> found;
  const FacetLine part = partOf(line, within);
  const double scale = within.to - within.from;
  for (const FacetId f : state.layers.sets()[state.layers.setOf(line.facet)].upward) {
    const FacetLine here = lineOn(state, part, f);
    for (const Chord& chord : chordsOf(state.pattern, f, here.from, here.to)) {
      found.push_back({f, {within.from + chord.t0 * scale, within.from + chord.t1 * scale}});
    }
  }
  return found;
}

FacetLine partOf(const FacetLine& line, Stretch stretch) {
  return {line.facet, lerp(line.from, line.to, stretch.from), lerp(line.from, line.to, stretch.to)};
}

}  // namespace kiri
