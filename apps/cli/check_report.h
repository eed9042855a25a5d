// What is known about a crease pattern before any search: faults, and whether its facets close.
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "apps/cli/pattern_input.h"
#include "core/flatfold/flat_map.h"
#include "core/flatfold/local_conditions.h"

namespace kiri::cli {

struct PatternReport {
  std::vector<VertexFault> faults;
  std::optional<FlatMap> map;  ///< none where the facets do not close
  std::string whyOpen;         ///< the sentence of flatMapOf then
  Witness openAt;              ///< and where

  /// How many vertices have faults.
  std::size_t faultyVertices() const;
  bool isLocallyFlat() const { return faults.empty(); }
  bool foldsFlat() const { return faults.empty() && map.has_value(); }
};

PatternReport reportOf(const AssignedPattern& creases);

/// "folds flat around every vertex", "12 vertices do not fold flat".
std::string verdictOf(const PatternReport& report);
/// "closes as a whole to 1.2e-13 mm", or why it does not.
std::string closingOf(const PatternReport& report, const std::string& unit);

/// The name of a rule in JSON: "big_little_big".
const char* nameOf(VertexRule rule);
/// A list of {rule, place, amount, message}.
JsonValue faultsJson(const PatternReport& report, const CreasePattern& pattern);

}  // namespace kiri::cli
