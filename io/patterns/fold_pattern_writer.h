// Writing crease patterns as FOLD 1.2 (docs/formats/fold.md).
// SPDX-License-Identifier: MIT
#pragma once

#include "io/patterns/pattern_file.h"

namespace kiri {

/// One frame of class creasePattern. Ends that are equal to the last bit become one vertex. Faces
/// are those of the drawing, or are found where the drawing is a planar map without any repair;
/// layer orders become faceOrders; the keys of others are put back.
WrittenPattern writeFoldPattern(const PatternFile& file);

}  // namespace kiri
