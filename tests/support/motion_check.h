// Whether paper passes through paper during a motion, by brute force: many moments, every pair.
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "core/paper/folded_state.h"
#include "tests/support/line_motion.h"
#include "tests/support/space_piece.h"

namespace kiri::test {

/// A moving and a resting facet, one through the other.
struct Crossing {
  double degrees = 0;  ///< turned since the start, without sign
  double depth = 0;    ///< mm from the place to the nearest border of the paper, of either facet
  FacetId moving;
  FacetId resting;
};

/// Looks at moments of a motion. Knows nothing of the kernel's sweep: facets are cut by the planes
/// of others (see SpacePiece), and points inside a facet are followed from moment to moment to see
/// them pass a plane. Cost: facets squared times moments.
class MotionCheck {
 public:
  MotionCheck(const FoldedState& state, const LineMotion& how);

  /// How deep the two facets stand in each other at a moment; 0 when they do not, or lie in one
  /// plane.
  double depthAt(FacetId moving, FacetId resting, double degrees) const;
  /// The same of the pair that stands deepest in each other.
  double deepestAt(double degrees) const;
  /// How fat the overlap of the two is at a moment when they lie in one plane, as area / perimeter;
  /// 0 when they do not.
  double overlapAt(FacetId moving, FacetId resting, double degrees) const;
  /// The first crossing deeper than `depth` at `moments` equally spaced moments strictly inside the
  /// motion, or between two of them.
  std::optional<Crossing> firstCrossing(int moments, double depth) const;

 private:
  using Piece = SpacePiece;
  Vec3 turned(Vec3 p, double degrees) const;
  Piece turned(const Piece& piece, double degrees) const;
  std::optional<Crossing> passing(const Piece& m, const Piece& f, double from, double to,
                                  double depth) const;
  const Piece& pieceNamed(FacetId facet) const { return pieces_[facet.index]; }

  Motion motion_;
  double size_;
  std::vector<Piece> pieces_;
  std::vector<bool> moves_;
  std::vector<std::vector<bool>> areJoined_;
};

}  // namespace kiri::test
