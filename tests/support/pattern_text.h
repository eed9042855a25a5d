// Crease patterns of known mechanisms, from their vertices and edges.
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "core/paper/folded_state.h"

namespace kiri::test {

/// An edge between two of the vertices, by position.
struct DrawnEdge {
  std::size_t from = 0;
  std::size_t to = 0;
  EdgeKind kind = EdgeKind::Hinge;  ///< that of an edge with paper on both sides
  double angle = 0;                 ///< of a hinge, degrees
};

/// The planar map whose faces are the facets; edges meet at vertices only, the drawing hangs
/// together. Faces that hold one of `holes` are no paper, nor is what lies outside. The first facet
/// rests as it lies on the paper; edge i of the state is edge i of the list.
FoldedState drawnState(const std::vector<Vec2>& vertices, const std::vector<DrawnEdge>& edges,
                       const std::vector<Vec2>& holes = {});

/// Creases from the middle of a polygon to its corners at `radius` mm, the first along +x, then
/// `sectors` radians apart. A last sector that is missing from a full turn is no paper: an open
/// fan. Edge i is crease i; a fan has one edge more than sectors, the first and last are borders.
FoldedState starOf(const std::vector<double>& sectors, double radius = 50);

/// A corrugated sheet of columns x rows parallelograms (Miura). Lines along x are straight,
/// mountain and valley by turns; the zigzags across them lean by `degrees` against the x axis, to
/// the right and to the left by turns.
struct Corrugation {
  FoldedState state;
  int columns = 0;
  int rows = 0;
  std::vector<std::size_t> straight;  ///< hinges on the lines: row by row from below, left to right
  std::vector<std::size_t> zigzag;    ///< row by row from below, left to right
  /// All hinges at 180 or -180 as the sheet folds flat, one zigzag a valley, the next a mountain.
  std::vector<double> folded;
};
Corrugation corrugationOf(int columns, int rows, double degrees, double width = 10,
                          double height = 10);

}  // namespace kiri::test
