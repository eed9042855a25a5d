// The way of a tear along edges, as the hand leads it.
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "editor/tools/edge_walk.h"
#include "editor/tools/scope.h"

namespace kiri {

/// A path along hinges: the shortest through the vertices that the hand came to (its anchors), to
/// the point of an edge that is nearest to the pointer. Where the hand goes back, so does the path.
/// All places are in the paper frame.
class TearPath {
 public:
  void begin(Vec2 vertex);
  /// Leads the path to the pointer. `isDragging`: vertices that it comes to become anchors. False:
  /// the paper of the path is gone.
  bool follow(const PointerEvent& event, const Scope& scope, bool isDragging);
  /// Makes the vertex at the end an anchor. False: it was one, or the path ends inside an edge.
  bool anchorEnd(const FoldedState& state);
  /// Forgets the last anchor but the first, and what leads to it. False: there is none.
  bool dropAnchor();

  bool isThere() const { return points_.size() > 1; }
  const std::vector<Vec2>& points() const { return points_; }
  /// Well inside a facet beside each piece between two points.
  const std::vector<Vec2>& besides() const { return besides_; }
  /// What the end of the path was caught by when it was last led.
  const Marks& caught() const { return caught_; }

  double length() const;
  /// To the end of the edge that the path ends on.
  double mostLength() const;
  void setLength(double length, double resolution);

 private:
  void take(const FoldedState& state, const HingeGraph& graph, std::vector<VertexId> way,
            const EdgeHit& hit, bool isAtVertex);
  void keepAnchorsOnPath();

  std::vector<Vec2> anchors_;
  std::vector<Vec2> points_;
  std::vector<Vec2> besides_;
  Vec2 farEnd_;  ///< of the edge in which the path ends
  Marks caught_;
};

}  // namespace kiri
