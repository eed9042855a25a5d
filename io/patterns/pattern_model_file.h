// Pattern files as models, and states of models as pattern files.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/creases/repair.h"
#include "core/model/model.h"
#include "core/model/pattern_model.h"
#include "core/paper/folded_state.h"
#include "io/patterns/pattern_file.h"

namespace kiri {

/// mm that a unit of the file is: what the file says; else 1, or where that would give a sheet that
/// nobody folds (below 10 mm or above 2,000 mm), what makes its longest side 150 mm.
struct PatternScale {
  double mmPerUnit = 1;
  std::string note;  ///< a sentence where it was guessed; else empty
};
PatternScale scaleOf(const PatternFile& file);

/// The pattern of a file in mm, every repair counted, and its face orders in mm.
struct PatternOfFile {
  RepairedPattern repaired;
  std::vector<DrawnOrder> orders;
  std::vector<std::string> notes;  ///< what the reader, the scale and the repairs have to say
};
Result<PatternOfFile> patternOfFile(const PatternFile& file, const Progress& progress = {});

/// The model that a pattern file means, with its title, author and description. `options`: title
/// and orders are those of the file where they are empty. Errors: those of patternOf and modelOf.
Result<PatternModel> modelOfFile(const PatternFile& file, PatternModelOptions options = {},
                                 const Progress& progress = {});

/// A state as a pattern file in mm: its creases with their angles (asFolded, where `isAsFolded`),
/// and its layer order. Curves are polylines; a note says so.
PatternFile patternFileOf(const FoldedState& state, const Model& model, bool isAsFolded = false);

}  // namespace kiri
