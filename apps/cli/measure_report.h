// The measures of an outline as text, JSON and CSV, each with its convention.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "core/leaf/leaf_measures.h"

namespace kiri::cli {

/// What the measures are of.
struct MeasuredThing {
  std::string name;         ///< of the file
  std::string petioleFrom;  ///< how the petiole was found
  double prominence = 0;    ///< of tips, part of the longest radius
};

/// One JSON object; "conventions" says of each measure what it is.
std::string measuresJson(const MeasuredThing& thing, const LeafMeasures& measures);
/// Tidy: one measure a row, with its convention in the last column.
std::string measuresCsv(const MeasuredThing& thing, const LeafMeasures& measures);
/// For people: one measure a line.
std::string measuresText(const MeasuredThing& thing, const LeafMeasures& measures);

}  // namespace kiri::cli
