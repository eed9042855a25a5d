// What a crease pattern in a model allows: its faults, and its folded states as choices of layers.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/creases/assigned_pattern.h"
#include "core/flatfold/flat_folding.h"
#include "core/flatfold/local_conditions.h"
#include "core/model/model.h"
#include "core/paper/folded_state.h"
#include "editor/tools/layer_wish.h"

namespace kiri {

/// The first of the first `count` steps that is a crease pattern.
std::optional<std::size_t> patternStepOf(const Model& model, std::size_t count);

/// True when both draw the same creases; layers may differ.
bool haveSameCreases(const PatternStep& a, const PatternStep& b);

/// The pattern as its step draws it on the sheet of `before`; its ids are those of the state after
/// the step. Errors: those of creasedSheet.
Result<AssignedPattern> creasesOf(const FoldedState& before, const PatternStep& step);

struct PatternAnalysis {
  AssignedPattern creases;
  std::vector<VertexFault> faults;
  std::optional<FlatFolding> folding;                 ///< none: see problem
  std::vector<std::vector<FacetId>> componentFacets;  ///< sorted, one entry a component
  std::optional<Error> problem;                       ///< why it does not fold flat
};

/// May take long. Errors: Cancelled.
Result<PatternAnalysis> analysisOf(AssignedPattern creases, const Progress& progress = {});

/// The layers of a state after the step as the search knows them; none when it is not this
/// pattern, folded flat.
std::optional<LayerValues> valuesOf(const FlatFolding& folding, const FoldedState& after);

/// The step with other layers, and folded. `after`: the state that it leads to as it is; may be
/// none.
PatternStep withLayers(PatternStep step, const FlatFolding& folding, const LayerValues& values,
                       const FoldedState* after);

/// What the wish means for the pairs that overlap. Errors: NotFound - no paper of the pattern
/// there, or none that the facet could lie on.
Result<std::vector<Literal>> wantedBy(const FlatFolding& folding, const LayerWish& wish);

}  // namespace kiri
