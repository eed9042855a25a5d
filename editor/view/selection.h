// What the person has picked, by places on the paper, so that it outlives steps.
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "core/paper/folded_state.h"

namespace kiri {

/// What the select tool filters by (thesis 4.5, E).
enum class SelectedKind { Facet, Vertex, Point, Line, Inside };

/// One picked thing. Places are in the paper frame: a point well inside the facet, the vertex, the
/// point, or the middle of the edge (whose ends are `from` and `to`).
struct Selected {
  SelectedKind kind = SelectedKind::Facet;
  Vec2 place;
  Vec2 from;  ///< Line
  Vec2 to;    ///< Line
  bool operator==(const Selected&) const = default;
};

class Selection {
 public:
  const std::vector<Selected>& items() const { return items_; }
  bool isEmpty() const { return items_.empty(); }
  void clear() { items_.clear(); }
  /// Adds what is not there and takes away what is.
  void toggle(const Selected& item);
  void set(std::vector<Selected> items) { items_ = std::move(items); }
  /// Takes away all of one kind. True when there was any.
  bool drop(SelectedKind kind);
  /// Places of one kind.
  std::vector<Vec2> placesOf(SelectedKind kind) const;
  /// The last picked line, which mirrors mirror in.
  std::optional<Selected> lastLine() const;

 private:
  std::vector<Selected> items_;
};

/// What stands for a facet, a vertex or an edge of a state.
Selected selectedFacet(const FoldedState& state, FacetId facet);
Selected selectedVertex(const FoldedState& state, VertexId vertex);
Selected selectedLine(const FoldedState& state, EdgeId edge);

/// The facets of a state that hold selected facets' places.
std::vector<FacetId> facetsOf(const FoldedState& state, const Selection& selection);

}  // namespace kiri
