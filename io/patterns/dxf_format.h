// Reading and writing DXF (docs/formats/dxf.md).
// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

#include "core/base/result.h"
#include "io/patterns/pattern_file.h"

namespace kiri {

/// The lines of an ASCII DXF file of any version, blocks inserted, curves as polylines; what a line
/// means follows from the name of its layer, else from its colour. y points up in DXF, nothing is
/// mirrored. Errors: BadFile - binary DXF, no lines, broken pairs, too many lines.
Result<PatternFile> readDxfPattern(std::string_view text, std::string_view fileName);

/// LINE entities of DXF R12 on the layers that ORIPA and Oriedita know, and on three of our own.
WrittenPattern writeDxfPattern(const PatternFile& file);

}  // namespace kiri
