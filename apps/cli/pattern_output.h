// Crease patterns as files of other programs.
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

#include "apps/cli/console.h"
#include "apps/cli/model_input.h"
#include "io/fold_writer.h"
#include "io/patterns/pattern_file.h"

namespace kiri::cli {

/// The pattern format of a name like "cp"; none for others.
std::optional<PatternFormat> patternFormatNamed(const std::string& name);

/// The creases of a state as a pattern file: each folded as it last was. FOLD takes the folded form
/// with its face orders along, where the state is that pattern folded.
Exported patternOfState(const ModelInput& input, const FoldedState& state, PatternFormat format);

/// Prints what the format cannot hold, then writes.
int writeWithNotes(Console& console, const std::string& path, const std::string& text,
                   const std::vector<std::string>& losses);

}  // namespace kiri::cli
