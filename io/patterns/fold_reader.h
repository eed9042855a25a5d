// Reading crease patterns from FOLD files (docs/formats/fold.md).
// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

#include "core/base/result.h"
#include "io/patterns/pattern_file.h"

namespace kiri {

/// The crease pattern of a FOLD file, version 1.0 to 1.2: the first frame of class creasePattern,
/// else frame 0 when it lies flat, else a folded form, rolled out along its edges. Errors: BadFile.
Result<PatternFile> readFoldPattern(std::string_view text, std::string_view fileName);

}  // namespace kiri
