// Walking along edges of one kind: which lies under the pointer, and the way from one to another.
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "core/paper/folded_state.h"
#include "editor/view/pane_map.h"

namespace kiri {

/// A point of an edge under the pointer.
struct EdgeHit {
  EdgeId edge;
  double t = 0;       ///< from the edge's `from` to its `to`
  Vec2 paper;         ///< paper frame, mm
  double pixels = 0;  ///< from the pointer
};

/// The points of straight edges that are seen, nearest to the pointer: the nearest, and those that
/// lie where it lies to the eye, in other layers or at its end. Only edges that `isMeant` says are
/// looked at; edges under other paper are left out, unless `hiddenToo`. `reach`: pixels.
std::vector<EdgeHit> edgesUnder(const FoldedState& state, const PaneMap& map, Vec2 pixels,
                                double reach, const std::function<bool(EdgeId)>& isMeant,
                                bool hiddenToo = false);

/// The hinges of a state as a graph of its vertices; distances are lengths on the paper.
class HingeGraph {
 public:
  explicit HingeGraph(const FoldedState& state);

  const std::vector<EdgeId>& at(VertexId vertex) const { return edges_[vertex.index]; }
  VertexId otherEnd(EdgeId edge, VertexId vertex) const;

  /// The shortest ways from one vertex to all others.
  struct Ways {
    std::vector<double> far;                          ///< mm; infinite where there is no way
    std::vector<VertexId> previous;                   ///< the vertex before, on the way
    std::vector<VertexId> to(VertexId vertex) const;  ///< after the start, to the vertex
  };
  Ways from(VertexId start) const;

 private:
  const CreasePattern& pattern_;
  std::vector<std::vector<EdgeId>> edges_;  ///< of each vertex
};

/// The vertex at a place of the sheet, within tolerance.pick().
std::optional<VertexId> vertexAt(const CreasePattern& pattern, Vec2 paper);

/// True when the two sides of a torn edge lie together, so that it can be mended.
bool canBeMended(const FoldedState& state, EdgeId edge);

/// The torn edges that hang on each other end to end, with no third at a vertex, all of which can
/// be mended: the places along them, and the edges in that order.
struct TornRun {
  std::vector<Vec2> points;
  std::vector<EdgeId> edges;
};
TornRun tornRunThrough(const FoldedState& state, EdgeId edge);

}  // namespace kiri
