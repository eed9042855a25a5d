// Crease patterns as files of other programs.
// SPDX-License-Identifier: MIT
#include "apps/cli/pattern_output.h"

#include <memory>
#include <utility>

#include "core/model/pattern_model.h"
#include "io/patterns/pattern_model_file.h"

namespace kiri::cli {

namespace {

/// True when a state is what its creases give when all are folded at once.
bool isFolded(const FoldedState& state, const FoldedState& folded) {
  for (std::size_t i = 0; i < state.pattern.edges.size(); ++i) {
    if (state.pattern.edges[i].angle != folded.pattern.edges[i].angle) return false;
  }
  return true;
}

}  // namespace

std::optional<PatternFormat> patternFormatNamed(const std::string& name) {
  return patternFormatOf("pattern." + name);
}

Exported patternOfState(const ModelInput& input, const FoldedState& state, PatternFormat format) {
  const FoldedState folded = asFolded(state);
  if (format == PatternFormat::Fold && isFolded(state, folded)) {
    const FoldOptions options{"KiriSim " KIRI_VERSION, titleOf(input), input.model.notes};
    return writeFold(state, {{std::make_shared<const FoldedState>(state), "folded", ""}}, options);
  }
  const PatternFile file = patternFileOf(state, input.model, true);
  WrittenPattern written = writePattern(file, format);
  return {std::move(written.text), std::move(written.losses)};
}

int writeWithNotes(Console& console, const std::string& path, const std::string& text,
                   const std::vector<std::string>& losses) {
  for (const std::string& loss : losses) console.err << "note: " << loss << '\n';
  return writeResult(console, path, text);
}

}  // namespace kiri::cli
