// The equations of all closed loops of a crease pattern, and their solution nearest to a guess.
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <vector>

#include "core/linkage/loops.h"

namespace kiri {

/// Loops in which one of the `changing` hinges takes part, and which hinges may be solved for.
class Closure {
 public:
  Closure(const CreasePattern& pattern, const std::vector<EdgeId>& changing,
          const std::vector<EdgeId>& free);

  bool hasLoops() const { return !loops_.empty(); }
  /// The largest amount by which a loop misses its start: an entry of its rotation matrix, a shift
  /// as part of the sheet.
  double error(const FoldAngles& angles) const;
  /// Changes the free angles as little as closes all loops (Gauss-Newton, least squares), so what
  /// is symmetric stays so. False when that does not succeed; `angles` then are where it ended.
  bool close(FoldAngles& angles) const;
  /// The same, but every free hinge keeps the sign of its difference from `origin`, and one that
  /// does not differ stays: the differences are multiplied, not shifted.
  bool closeKeepingSigns(FoldAngles& angles, const FoldAngles& origin) const;
  /// Changes the free entries of `rates` (degrees per unit of time) as little as keeps the loops
  /// closed, to first order, on a motion that passes `angles`.
  void project(const FoldAngles& angles, FoldAngles& rates) const;
  /// The changing hinges of the loop that misses its start most.
  std::vector<EdgeId> worstLoop(const FoldAngles& angles) const;

 private:
  struct Solver;
  bool solve(FoldAngles& angles, const FoldAngles* origin) const;
  /// One round of Newton's method, on the angles or on the logarithms of their differences from
  /// `origin`. False when there is nothing to do or it fails.
  bool shift(FoldAngles& angles, const FoldAngles& guess, int round) const;
  bool multiply(FoldAngles& angles, const FoldAngles& origin) const;

  double size_;  ///< of the sheet, mm
  std::vector<HingeLoop> loops_;
  std::vector<bool> isChanging_;  ///< by edge
  std::vector<int> column_;       ///< of the free hinges, by edge; -1: not free
  std::vector<EdgeId> free_;
};

}  // namespace kiri
