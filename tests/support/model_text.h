// A few words of text for a model, so that tests stay short and readable.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/model/model.h"
#include "core/model/step.h"
#include "core/paper/folded_state.h"

namespace kiri::test {

/// Statements are parted by ';' or by new lines; places are "x,y" in mm, "m:x,y" in the model
/// frame, "p:x,y" on the paper; a place without a letter is on the paper, or in the model frame
/// when the statement holds "@model".
///
///   square 100 | rectangle 80 60 | disc 100 | polygon 0,0 10,0 0,10 [hole 1,1 2,1 1,2]...
///   fold [NAME] valley|mountain [ANGLE] P Q left|right|to PLACE|moving PLACE... [LAYERS] [in P]
///   angle NAME|PLACE DEGREES
///   unfold|refold all|NAME|PLACE... [together]
///   tear P P... [LAYERS]            mend [P P...] [LAYERS]
///   edge P Q [LAYERS] [in P]        cut P Q [LAYERS] [in P] [keep PLACE...]
///   curve P P P P... [closed] [free] [LAYERS] [in P] [keep PLACE...]
///   turn [vertical|horizontal]      rotate DEGREES [P]      move P
///   LAYERS: top N | facets PLACE... | through | layers all
///
/// Throws std::invalid_argument on text that it does not know: a mistake in the test.
Model modelOf(std::string_view text);

/// The steps of a text without a sheet.
std::vector<Step> stepsOf(std::string_view text);
Step stepOf(std::string_view text);

/// The sheet of a model before its first step.
FoldedState startOf(const Model& model);

/// The state after all steps of the text. Throws std::runtime_error with the error's sentence when
/// one fails.
FoldedState run(std::string_view text);
/// The same, going on from a state.
FoldedState after(const FoldedState& state, std::string_view text);

/// What the last step of the text makes of the state that the others lead to. Throws when one
/// before it fails.
Result<FoldedState> tryRun(std::string_view text);
Result<FoldedState> tryAfter(const FoldedState& state, std::string_view text);

}  // namespace kiri::test
