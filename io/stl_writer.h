// Binary STL files of the folded model (docs/formats/stl.md).
// SPDX-License-Identifier: MIT
#pragma once

#include "core/paper/folded_state.h"
#include "io/fold_writer.h"

namespace kiri {

struct StlOptions {
  double thickness = 0.3;  ///< mm of a facet, which lies in the middle; 0: a surface without body
  double layerGap = 0;     ///< mm between a layer of a plane and the one below it
  bool isPattern = false;  ///< the sheet at rest instead of the folded model
};

/// Triangles in mm, z towards the viewer of the front. With a thickness each facet is a closed
/// plate, and the layers of a plane are spread so that plates touch at the most; where the paper is
/// folded, plates of different planes do overlap near the hinge. Curves become polylines.
/// Coordinates are floats, as STL has them.
Exported writeStl(const FoldedState& state, const StlOptions& options);

}  // namespace kiri
