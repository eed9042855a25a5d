// Steps as they stand in a .kiri file, and how sentences name them.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/model/step.h"
#include "io/json_fields.h"
#include "io/json_tree.h"

namespace kiri {

/// The words that "do" may hold, in the order of the alternatives of Action.
const std::vector<std::string>& stepKinds();

/// The word for what a step does ("fold", "curve cut").
const std::string& kindOf(const Step& step);

/// The letters of a pattern's creases (as in FOLD), and what each of them means.
const std::vector<std::string>& creaseLetters();
inline constexpr Assignment kCreaseAssignments[] = {Assignment::Mountain, Assignment::Valley,
                                                    Assignment::Flat,     Assignment::Unassigned,
                                                    Assignment::Cut,      Assignment::Join};
/// The angle of a crease that is written without one.
double usualAngle(Assignment assignment);

/// `step 3 (fold "mid-vein")`: how messages name a step; `number` counts from 1.
std::string describeStep(const Step& step, std::size_t number);

Step readStep(const Field& field, std::size_t number);
JsonValue writeStep(const Step& step);

}  // namespace kiri
