// Folded states as files: FOLD, models, pictures.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "apps/cli/states_search.h"

namespace kiri::cli {

/// A state that was chosen, and what it is called.
struct ChosenState {
  std::string number;  ///< of all, from 0
  LayerValues values;
};

struct StatesFile {
  std::string path;    ///< "-": standard output; with a place for a number where there are several
  std::string format;  ///< one of stateFormats()
  double dpi = 200;
};

/// What states are written as.
std::vector<std::string> stateFormats();

bool isPicture(const std::string& format);

/// Mistakes about the file that can be told before any work is done. `isSeveral`: more states than
/// one may have to be written.
Status checkStatesFile(const StatesFile& file, bool isSeveral);

/// Writes the states: FOLD takes all into one file, pictures take one each. Notes about what the
/// format cannot hold come first.
int writeStatesFile(Console& console, const PatternInput& input, const StatesAnswer& answer,
                    const std::vector<ChosenState>& states, const StatesFile& file,
                    SearchWatch& watch);

/// Why there is no state, drawn: the facets that cannot be ordered, or where the pattern does not
/// fold. Requires a format that is a picture.
int writeConflictPicture(Console& console, const PatternInput& input, const StatesAnswer& answer,
                         const StatesFile& file);

}  // namespace kiri::cli
