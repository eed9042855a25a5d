// glTF 2.0 files (binary, GLB) of a model's whole process in motion (docs/formats/gltf.md).
// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/model/timeline.h"
#include "io/gltf_writer.h"

namespace kiri {

/// One animation over the time line, seconds as there. A node for each facet that the paper ever
/// has: facets stay rigid, key frames carry their places, as close as `options.motionError` asks,
/// and facets that are not there yet or any more are scaled to nothing. At rest, before a viewer
/// plays it, the file shows the end. `options.isPattern` is not looked at. Errors: Cancelled.
Result<Exported> writeAnimatedGlb(const Timeline& timeline, const GltfOptions& options,
                                  const Progress& progress = {});

}  // namespace kiri
