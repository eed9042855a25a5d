// Reading and writing .cp files (docs/formats/cp.md).
// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

#include "core/base/result.h"
#include "io/patterns/pattern_file.h"

namespace kiri {

/// The lines of a .cp file, y turned up. Lines that make no sense are left out and counted in
/// notes. Errors: BadFile - no line makes sense.
Result<PatternFile> readCpPattern(std::string_view text, std::string_view fileName);

/// One line of text for each crease, y turned down.
WrittenPattern writeCpPattern(const PatternFile& file);

/// True when one of the first lines of the text is that of a .cp file.
bool looksLikeCp(std::string_view text);

}  // namespace kiri
