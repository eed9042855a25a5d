// What the vertices of a pattern must fulfil for it to fold flat, as equations with derivatives.
// SPDX-License-Identifier: MIT
#pragma once

#include <utility>
#include <vector>

#include "core/creases/assigned_pattern.h"

namespace kiri {

/// One equation: how much it misses, mm, and how that changes with the places of vertices.
struct ClosingRow {
  double miss = 0;
  std::vector<std::pair<VertexId, Vec2>> slopes;  ///< a vertex may occur more than once
};

/// The loops of folded creases of a pattern. Around a vertex the directions of its creases,
/// subtracted and added by turns, make half a turn (Kawasaki); around a hole the reflections at all
/// creases that are crossed make nothing. Source: guide to algorithms 4.1 and 4.2.
class FlatClosing {
 public:
  explicit FlatClosing(const AssignedPattern& creases);

  /// Vertices at which an odd number of folded creases meet: nothing closes there.
  const std::vector<VertexId>& oddVertices() const { return odd_; }
  /// The equations for vertices at `places`: one for each vertex inside, three for each hole.
  std::vector<ClosingRow> rowsAt(const std::vector<Vec2>& places) const;
  /// A place near each of the rows.
  std::vector<Vec2> placesOfRows(const std::vector<Vec2>& places) const;
  /// Lengths that turn the misses of rows into radians.
  std::vector<double> arms() const;

  /// A vertex through which a crease runs straight, and the ends of its two parts.
  struct Straight {
    VertexId middle;
    VertexId from;
    VertexId to;
  };
  /// Those inside the paper that are straight to the kernel's precision and are not held so by
  /// their own equation.
  std::vector<Straight> straightOnes() const;

 private:
  struct Star {
    VertexId middle;
    std::vector<VertexId> ends;  ///< of its folded creases, in order around it
    double arm = 0;              ///< the shortest of them, mm
  };
  struct Ring {
    std::vector<std::pair<VertexId, VertexId>> hinges;  ///< folded, in the order of crossing
    Vec2 centre;
    double arm = 0;  ///< how far its creases lie from the centre, mm
  };

  ClosingRow starRow(const Star& star, const std::vector<Vec2>& places) const;
  void addRingRows(const Ring& ring, const std::vector<Vec2>& places,
                   std::vector<ClosingRow>& rows) const;

  const CreasePattern& pattern_;
  std::vector<Star> stars_;
  std::vector<Ring> rings_;
  std::vector<VertexId> odd_;
};

/// How far the middle of a straight crease lies beside the line through its ends.
ClosingRow straightRow(const FlatClosing::Straight& straight, const std::vector<Vec2>& places);

}  // namespace kiri
