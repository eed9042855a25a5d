// A crease pattern of another program as a model, with what was repaired and left out on the way.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/creases/repair.h"
#include "core/model/model.h"

namespace kiri {

/// What a person should know of an imported pattern.
struct PatternReport {
  std::string source;               ///< name of the file; empty: pasted text
  std::vector<Repair> repairs;      ///< places in the paper frame of the model, mm
  std::vector<std::string> notes;   ///< sentences of the reader and of the making of the model
  std::vector<std::string> losses;  ///< what the file holds and a .kiri file of the model will not
};

struct PatternImport {
  Model model;
  PatternReport report;
};

/// The longest side, mm, of a sheet whose file gives no unit.
inline constexpr double kUnitlessSide = 150;

enum class PatternUse { Folded, Flat };

/// Reads, repairs, folds where that is wanted and can be. The pattern is the model's first step.
/// Errors: those of readPattern, patternOf and modelOf.
Result<PatternImport> importPattern(std::string_view text, const std::string& fileName,
                                    PatternUse use = PatternUse::Folded,
                                    const Progress& progress = {});

/// True when the name ends as those of crease patterns do.
bool isPatternName(std::string_view fileName);
/// True when a text that was pasted or dropped looks like a crease pattern.
bool isPatternText(std::string_view text);

}  // namespace kiri
