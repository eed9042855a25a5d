// A folder of its own for folds through all layers along endless lines: a list of polygons from
// bottom to top. SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "core/base/vec.h"
#include "core/paper/folded_state.h"

namespace kiri::test {

/// A flat facet: its corners as folded, and how the plane of the model goes back to the paper: a
/// mirror image or not.
struct ReferenceFacet {
  std::vector<Vec2> folded;
  Vec2 x{1, 0};  ///< image in the paper frame of the model's x direction
  Vec2 y{0, 1};
  Vec2 origin;
  bool isFlipped = false;

  Vec2 toPaper(Vec2 p) const { return x * p.x + y * p.y + origin; }
};

/// Bottom to top. The paper left of the line from `a` to `b` is turned over it, on top (valley) or
/// below (mountain).
using ReferenceStack = std::vector<ReferenceFacet>;
ReferenceStack unfolded(std::vector<Vec2> sheet);
ReferenceStack folded(const ReferenceStack& stack, Vec2 a, Vec2 b, bool isValley);

std::pair<Vec2, Vec2> boxOf(const ReferenceStack& stack);
double areaOf(const ReferenceStack& stack);

/// Where the kernel's state differs: number of facets, place of every facet, layer relation of
/// every pair that overlaps.
std::vector<std::string> differences(const ReferenceStack& stack, const FoldedState& state);

/// A sequence of folds through all layers, each line found from the box of the stack before it.
enum class FoldSequence { Half, Spiral, Offset };
/// The line of fold `number` (from 0), long enough to cross the whole stack; the left side moves.
std::pair<Vec2, Vec2> lineOf(FoldSequence sequence, const ReferenceStack& stack, int number);

}  // namespace kiri::test
