// The measures of an outline by name.
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "core/leaf/leaf_measures.h"

namespace kiri::cli {

/// A measure that is one number.
struct NamedMeasure {
  const char* name;   ///< in files
  const char* unit;   ///< empty: a ratio or a count
  const char* words;  ///< for people
  double value;
};

std::vector<NamedMeasure> namedMeasures(const LeafMeasures& m);

}  // namespace kiri::cli
