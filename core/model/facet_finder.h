// Many places on the paper, each to its facet.
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "core/paper/crease_pattern.h"

namespace kiri {

/// Finds facets by points inside them as facetAt does, in about constant time each: the paper's box
/// is divided into as many cells as there are facets.
class FacetFinder {
 public:
  explicit FacetFinder(const CreasePattern& pattern);

  /// The facet that holds the point or, where it lies on a border, the lowest that does; none where
  /// there is no paper.
  std::optional<FacetId> at(Vec2 paper) const;

 private:
  std::size_t cellOf(double value, double low, double high) const;

  double nearness_;
  Box box_;
  std::size_t columns_ = 1;  ///< and rows
  std::vector<Region> regions_;
  std::vector<Box> boxes_;
  std::vector<std::vector<FacetId>> cells_;
};

/// A point well inside the facet with no more digits than it needs: for names of facets in files.
Vec2 namingPointOf(const CreasePattern& pattern, FacetId facet);

}  // namespace kiri
