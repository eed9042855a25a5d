// What of a step can be set: the fields that show it, and how they change it.
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <vector>

#include "core/model/step.h"
#include "editor/base/field.h"

namespace kiri {

/// A field of a step with its present value. `set` takes values that the field allows.
struct StepSlot {
  Field field;
  std::function<void(Step&, const FieldValue&)> set;
};

/// In the order in which they are shown.
std::vector<StepSlot> slotsOf(const Step& step);

}  // namespace kiri
