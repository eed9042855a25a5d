// The measures of an outline by name.
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/leaf/leaf_measures.h"

namespace kiri::cli {

/// A measure that is one number.
struct NamedMeasure {
  std::string name;             ///< in files
  const char* unit;             ///< empty: a ratio or a count
  std::string words;            ///< for people
  std::optional<double> value;  ///< none where the outline has no such thing
  std::string convention;       ///< what it is, and whose definition that is
};

/// All of them. `prominence`: what tips were told apart by, as in MeasureOptions.
std::vector<NamedMeasure> namedMeasures(const LeafMeasures& m,
                                        double prominence = MeasureOptions{}.prominence);

}  // namespace kiri::cli
