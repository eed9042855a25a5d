// Reading and writing .opx files of ORIPA (docs/formats/opx.md).
// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

#include "core/base/result.h"
#include "io/patterns/pattern_file.h"

namespace kiri {

/// The lines of an .opx file, in either dialect of Java's bean encoding, y turned up. Lines that
/// make no sense are left out and counted in notes; a file that ends too early is read as far as it
/// goes. Errors: BadFile.
Result<PatternFile> readOpxPattern(std::string_view text, std::string_view fileName);

/// The newer dialect, which all versions of ORIPA since 1.0 read, y turned down.
WrittenPattern writeOpxPattern(const PatternFile& file);

}  // namespace kiri
