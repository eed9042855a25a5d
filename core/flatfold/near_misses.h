// How near points and lines come to each other: what tells a drawing's noise from what it means.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include "core/flatfold/folded_lines.h"

namespace kiri {

/// Counts of the distances between folded points and lines, by powers of two of a millimetre.
class NearMisses {
 public:
  /// Points within `same` are one; distances beyond `most` are not looked at.
  NearMisses(const FoldedLines& lines, double same, double most);

  /// Distances worth trying, the likely ones first: powers of two such that no point misses a line
  /// by between a `room`-th and `room` times of it (a power of two). `noise`: the least by which
  /// the drawing is off; gaps above it come before those below, near ones before far ones, and of
  /// each gap its middle first.
  std::vector<double> gaps(double noise, int room) const;

 private:
  void add(double distance);
  bool isFree(int power, int room) const;

  int lowest_ = 0;  ///< power of the first count
  std::vector<std::size_t> counts_;
};

}  // namespace kiri
