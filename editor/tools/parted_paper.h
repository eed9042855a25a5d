// The paper of one plane parted along a line: what would move, and what must come along.
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "core/model/locate.h"
#include "core/paper/facet_line.h"
#include "core/paper/folded_state.h"

namespace kiri {

/// A stretch of a line in units of it: 0 at its start, 1 at its end.
struct Stretch {
  double from = 0;
  double to = 0;
};

/// What turns when some paper on one side of a line turns.
struct Reach {
  std::vector<FacetId> layers;          ///< facets of the state to be creased, sorted
  std::vector<Stretch> creases;         ///< where, for each crease
  Stretch stretch;                      ///< that holds all of them
  std::vector<std::vector<Spot>> rims;  ///< corners of the moving parts of these layers
  Spot inside;          ///< well inside the largest of them: names the side that moves
  double area = 0;      ///< of all paper that moves, mm^2
  bool isFree = false;  ///< false: moving paper stays joined to paper that is meant to rest
};

/// A copy of the paper in which every facet of the line's plane is divided along the whole line.
/// From there on it is a matter of which pieces are joined by hinges that are not on the line:
/// exactly these must move together (core/fold/moving_facets.h), so the layers found are the fewest
/// that can be folded without stretching. Left is as in FoldRequest. Cost: about that of a fold
/// without the search for collisions.
class PartedPaper {
 public:
  PartedPaper(const FoldedState& state, const FacetLine& line);

  /// The pieces of some facets of the state that lie on one side and border the line somewhere in
  /// the stretch.
  std::vector<FacetId> piecesAlong(const std::vector<FacetId>& facets, bool onLeft,
                                   Stretch within) const;
  /// The piece that holds a place of the state's paper, one on the given side where there is a
  /// choice.
  std::vector<FacetId> pieceAt(const Spot& spot, bool onLeft) const;
  /// What moves when these pieces do.
  Reach reachOf(const std::vector<FacetId>& pieces, bool leftMoves) const;
  /// On which side a place of the state's paper lies; 0: on the line.
  int sideOf(const Spot& spot) const;

 private:
  void part();
  bool isFlatOnLine(const Edge& edge) const;
  Stretch stretchOf(const Edge& edge) const;
  int sideOfPiece(FacetId piece) const;
  double heightOf(FacetId piece, Vec2 paper) const;
  bool isFree(const std::vector<FacetId>& pieces, const std::vector<bool>& moves,
              bool leftMoves) const;

  FoldedState state_;  ///< layers are those of the undivided state
  FacetLine line_;
  Vec3 origin_;                               ///< of the line
  Vec3 along_;                                ///< unit
  Vec3 left_;                                 ///< unit, from the line to its left
  double span_ = 1;                           ///< mm
  std::vector<FacetId> originOf_;             ///< of each piece
  std::vector<std::vector<FacetId>> pieces_;  ///< of each facet
};

/// All facets of the plane that the line's stretch crosses or runs along, with their parts of it.
struct Crossed {
  FacetId facet;
  Stretch stretch;
};
std::vector<Crossed> crossedBy(const FoldedState& state, const FacetLine& line, Stretch within);

/// The segment of the line that is its stretch.
FacetLine partOf(const FacetLine& line, Stretch stretch);

}  // namespace kiri
