// A crease pattern with its faults and repairs marked, for kiri check and the window.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "core/creases/assigned_pattern.h"
#include "core/creases/repair.h"
#include "core/flatfold/flat_map.h"
#include "core/flatfold/layer_states.h"
#include "core/flatfold/local_conditions.h"
#include "render/scene/appearance.h"
#include "render/scene/scene.h"

namespace kiri {

struct PatternCheckOptions {
  double size = 180;    ///< mm on the page, larger side of the pattern, whatever its own size
  double margin = 8;    ///< mm around
  std::string title;    ///< written above the pattern
  std::string verdict;  ///< written below it, before the legend; wrapped
};

/// "Kawasaki 0.42°", "Maekawa 4-4" (mountains-valleys, and "+1" for one not assigned), "odd degree
/// 5", "big-little-big", "self-crossing": the label of a fault.
std::string labelOf(const AssignedPattern& creases, const VertexFault& fault);

/// The pattern front up, a ring around each vertex for each of its faults with their labels beside
/// it, small squares where repairs were made (as far as these say where), and a legend that counts
/// both. Where more faults than can be read are marked, the rings stay and the legend says that
/// labels are missing. Groups: those of assignedGroups, then repairs, faults, labels, legend. Items
/// of `faults` have the data rule, amount, and vertex. Line styles and colours of the paper are
/// those of `appearance`, the paper paled. Nothing lies outside the page.
Scene patternCheckScene(const AssignedPattern& creases, const std::vector<VertexFault>& faults,
                        const std::vector<Repair>& repairs, const Appearance& appearance,
                        const PatternCheckOptions& options = {});

/// Why there is no folded state: the pattern with the facets of the conflict filled and numbered,
/// beside it the folded outline with the same facets, translucent, where `map` lays them; the
/// message below. Groups: those of assignedGroups, then facets, numbers, folded, folded-facets,
/// folded-numbers, legend. Sizes are for the pattern; the page is about twice as wide.
Scene orderConflictScene(const AssignedPattern& creases, const FlatMap& map,
                         const OrderConflict& conflict, const Appearance& appearance,
                         const PatternCheckOptions& options = {});

}  // namespace kiri
