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
  std::size_t standing = 0;    ///< vertices that were left out, see reportOf
  std::optional<FlatMap> map;  ///< none where the facets do not close
  std::string whyOpen;         ///< the sentence of flatMapOf then
  Witness openAt;              ///< and where

  /// How many vertices have faults.
  std::size_t faultyVertices() const;
  bool isLocallyFlat() const { return faults.empty() && standing == 0; }
  bool foldsFlat() const { return isLocallyFlat() && map.has_value(); }
};

/// What is known of the pattern with all creases folded by 180 degrees. `standing`: vertices whose
/// creases are meant for other angles: what breaks a rule there is no fault, but is not flat
/// either; such vertices are counted.
PatternReport reportOf(const AssignedPattern& creases, const std::vector<VertexId>& standing = {});

/// "folds flat around every vertex", "12 vertices do not fold flat", and how many stand in space.
std::string verdictOf(const PatternReport& report);
/// "closes as a whole to 1.2e-13 mm", or why it does not.
std::string closingOf(const PatternReport& report, const std::string& unit);

/// The name of a rule in JSON: "big_little_big".
const char* nameOf(VertexRule rule);
/// A list of {rule, place, amount, message}.
JsonValue faultsJson(const PatternReport& report, const CreasePattern& pattern);

}  // namespace kiri::cli
