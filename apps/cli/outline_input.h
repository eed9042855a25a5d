// What kiri measure measures: a model, a crease pattern, or an outline of points.
// SPDX-License-Identifier: MIT
#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>

#include "apps/cli/console.h"
#include "apps/cli/model_input.h"

namespace kiri::cli {

struct OutlineOptions {
  double mmPerUnit = 1;
  bool isYDown = false;
};

/// Declares --mm-per-unit and --y-down.
void addOutlineOptions(CLI::App& command, OutlineOptions& options);

/// Errors: BadValue - a size that is none.
Status checkOutlineOptions(const OutlineOptions& options);

struct OutlineInput {
  ModelInput input;  ///< of points: a sheet without steps
  /// Of points: the origin of the file, where it lies at the outline, as programs for leaves have
  /// the petiole.
  std::optional<Vec2> origin;
};

/// Reads FILE ("-": standard input): a .kiri model, a crease pattern, or points. Errors: BadFile -
/// it is none of them, or cannot be read; BadValue - an outline that crosses itself.
Result<OutlineInput> loadOutline(Console& console, const std::string& path,
                                 const OutlineOptions& options);

}  // namespace kiri::cli
