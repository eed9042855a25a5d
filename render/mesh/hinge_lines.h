// The lines of folded hinges, each of which two planes show.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include "render/mesh/hinge_breaks.h"
#include "render/mesh/mesh_builder.h"

namespace kiri {

/// What two planes both show of a hinge becomes one line with paper on both of its sides.
class HingeLines {
 public:
  HingeLines(const FoldedState& state, const HingeBreaks& breaks);

  /// True when the piece runs along a folded hinge of the facet itself.
  bool isOwn(FacetId facet, const BoundaryPiece& piece) const;

  /// The visible part of the facet reaches the hinge along `piece`, but another line is drawn
  /// there.
  void notePaper(const MeshSide& side, const BoundaryPiece& piece);

  /// Draws the hinge along `piece`, whose points are `points`; or completes the line that the other
  /// plane has drawn.
  void add(const MeshSide& side, const BoundaryPiece& piece, const Points& points,
           const MeshSegment& segment, const MeshBuilder& builder, std::vector<MeshSegment>& lines);

  /// Once all planes are there: marks the lines whose other facet is covered.
  void settle(std::vector<MeshSegment>& lines) const;

 private:
  static constexpr std::size_t kNoLine = static_cast<std::size_t>(-1);
  /// An interval of a hinge on one side of the paper.
  struct Place {
    std::size_t line = kNoLine;
    bool hasOther = false;  ///< the visible part of the other facet reaches it, too
  };

  Place& placeAt(const MeshSide& side, const BoundaryPiece& piece, double part);

  const FoldedState& state_;
  const HingeBreaks& breaks_;
  std::vector<Place> places_;
};

}  // namespace kiri
