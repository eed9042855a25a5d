// SPDX-License-Identifier: MIT
#include "tests/support/crossing_check.h"

#include "tests/support/space_piece.h"

namespace kiri::test {
namespace {

bool isCurved(const FoldedState& state, FacetId facet) {
  for (const EdgeUse use : state.pattern[facet].border) {
    if (state.pattern[use.edge].isCurved()) return true;
  }
  return false;
}

}  // namespace

std::vector<std::string> crossingViolations(const FoldedState& state) {
  std::vector<SpacePiece> pieces;
  std::vector<double> shallow;
  const double size = state.tolerance().sheetSize();
  for (std::size_t f = 0; f < state.pattern.facets.size(); ++f) {
    pieces.push_back(spacePieceOf(state, FacetId(f), {}));
    shallow.push_back((isCurved(state, FacetId(f)) ? 2e-3 : 1e-6) * size);
  }
  std::vector<std::string> found;
  for (std::size_t f = 0; f < pieces.size(); ++f) {
    for (std::size_t g = f + 1; g < pieces.size() && found.size() < 20; ++g) {
      const double depth = depthOf(pieces[f], pieces[g]);
      if (depth <= shallow[f] || depth <= shallow[g]) continue;
      found.push_back("facets " + std::to_string(f) + " and " + std::to_string(g) +
                      " pass through each other, " + std::to_string(depth) + " mm deep");
    }
  }
  return found;
}

}  // namespace kiri::test
