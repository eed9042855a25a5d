// A crease pattern as a model: what every command that takes MODEL does with a pattern.
// SPDX-License-Identifier: MIT
#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "apps/cli/console.h"
#include "apps/cli/input_text.h"
#include "apps/cli/model_input.h"
#include "apps/cli/pattern_input.h"
#include "core/flatfold/flat_folding.h"

namespace kiri::cli {

struct ImportOptions {
  double size = 0;      ///< mm of the longest side; 0: see scaleOf in io/patterns
  bool isFlat = false;  ///< creases are drawn, nothing is folded
  std::string state;    ///< which state, decimal, from 0; empty: the first that is found

  bool isDefault() const { return size == 0 && !isFlat && state.empty(); }
};

/// Declares --size, --flat and --state.
void addImportOptions(CLI::App& command, ImportOptions& options);

/// Mistakes that can be told before any work is done.
Status checkImport(const ImportOptions& options);

/// The model that a pattern means: its sheet, and one step with its creases, folded in the chosen
/// state. Notes say what was guessed, repaired, scaled, and whether it could be folded. Errors:
/// BadFile; Cancelled; NotFound - there is no such state; those of patternOf and modelOf.
Result<ModelInput> modelFromPattern(Console& console, const InputText& text,
                                    const ImportOptions& options = {});

/// The model of a pattern folded in one of its states; notes as above. `values` are of `problem`,
/// found for the creases of `input` and their `map`. Errors: those of polished and modelOf.
Result<Model> modelInState(Console& console, const PatternInput& input, const FlatMap& map,
                           const OrderProblem& problem, const LayerValues& values,
                           const Progress& progress);

}  // namespace kiri::cli
