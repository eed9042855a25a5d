// The numbers and choices of a step that is done, to be changed later.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/model/step.h"
#include "editor/base/field.h"

namespace kiri {

/// What a step is, in a few words: "fold 3: valley, 180°", "tear", "curve cut". `number` is the
/// step's place in the model, from 1.
Phrase summaryOf(const Step& step, std::size_t number);

/// Everything of the step that can be typed: title, name, type, angle, ends of the line, layers,
/// side, controls...
std::vector<Field> fieldsOf(const Step& step);

/// The step with one field changed. Errors: BadValue - with what the field takes; NotFound - no
/// such field.
Result<Step> withField(const Step& step, const std::string& id, const FieldValue& value);

}  // namespace kiri
