// The parts of a formula that are chosen independently, with one way for each.
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "core/flatfold/order_formula.h"
#include "core/flatfold/work_meter.h"

namespace kiri {

/// Unknowns that hang together; every one of them is true in some way and false in another.
struct FreePart {
  OrderFormula formula;
  std::vector<std::uint32_t> origin;  ///< what unknown i is in the whole formula
  std::vector<std::uint8_t> first;    ///< the way that was found first
};

struct FreeParts {
  bool areThere = true;                ///< false: nothing makes the formula true
  std::vector<std::uint32_t> blocked;  ///< then: the unknowns of a part that cannot be true
  std::vector<std::uint8_t> fixed;     ///< by unknown: 0 or 1 where it has one choice only, else 2
  std::vector<FreePart> parts;         ///< ordered by their first unknown
};

/// Finds one way for every part. `isOneEnough`: only whether there is any way is asked; parts and
/// fixed values are then not to be used. Errors: those of the meter.
Result<FreeParts> freePartsOf(const OrderFormula& formula, bool isOneEnough, WorkMeter& meter);

}  // namespace kiri
