// Which facets lie over each cell of the folded ground.
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "core/flatfold/folded_lines.h"
#include "core/flatfold/planar_cells.h"

namespace kiri {

/// Which lines run along each piece.
struct LinesAlong {
  struct Use {
    std::uint32_t line = 0;
    bool isBack = false;  ///< the line runs against the piece
  };
  std::vector<std::uint32_t> starts;  ///< by piece; one more than there are pieces
  std::vector<Use> uses;

  const Use* begin(std::size_t piece) const { return uses.data() + starts[piece]; }
  const Use* end(std::size_t piece) const { return uses.data() + starts[piece + 1]; }
};
LinesAlong linesAlong(const Arrangement& arrangement);

/// The facets of every cell, sorted, found by walking from cell to cell: crossing a piece leaves
/// the facets that border it on one side and enters those on the other.
struct CellFacets {
  std::vector<std::vector<FacetId>> of;
  std::optional<Vec2> wrongAt;  ///< a piece where the facets of both sides do not fit its lines
};
CellFacets facetsOfCells(const Arrangement& arrangement, const PlanarCells& cells,
                         const FoldedLines& lines, const LinesAlong& along);

}  // namespace kiri
