// From a crease pattern to its folded states, part by part, as far as the limits allow.
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "apps/cli/check_report.h"
#include "apps/cli/pattern_input.h"
#include "apps/cli/search_watch.h"
#include "core/flatfold/flat_folding.h"

namespace kiri::cli {

/// What is known of the states of a pattern.
struct StatesAnswer {
  PatternReport report;
  std::optional<FoldedGround> ground;  ///< none where the facets do not close
  std::optional<LayerStates> states;   ///< none where there is no ground, or a limit was met
  std::optional<StateCount> total;     ///< once it was counted; 0 where no state exists
  std::string stopped;                 ///< why the search ended before its time; else empty

  bool exist() const { return states && states->exist(); }
};

struct SearchRequest {
  SearchLimits limits;
  bool counts = true;
};

/// Folds, finds what overlaps, searches, counts. What a limit ended is left open in the answer,
/// with the reason. Errors: Cancelled - by the user; those of overlapsOf.
Result<StatesAnswer> searchStates(const PatternInput& input, const SearchRequest& request,
                                  SearchWatch& watch);

}  // namespace kiri::cli
