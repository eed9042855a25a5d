// The numbers of a step, before anything is done with them.
// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/result.h"
#include "core/model/step.h"

namespace kiri {

/// Errors: BadValue - an angle is not a finite number, or a coordinate is none or larger than any
/// model (files cannot hold such numbers, programs can).
Status checkNumbers(const Step& step);

}  // namespace kiri
