// The kirigami law: the leaf that one straight cut would give.
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "core/leaf/folded_half.h"

namespace kiri {

/// How far from the petiole, on the flat leaf and in lengths of the mid-vein, each crease would end
/// if the folded leaf were cut along one straight line: the line nearest to its tips and sinuses,
/// by least squares of their distances from it as parts of the petiole's. For two rays it is the
/// kirigami law of the thesis (3.4), Ra / Rc = sin(p + alpha - beta) / sin p. By crease; 0 where
/// the line does not meet it.
std::vector<double> straightLengths(const FoldedHalf& half);

}  // namespace kiri
