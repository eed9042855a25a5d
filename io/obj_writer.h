// Wavefront OBJ files of the folded model (docs/formats/obj.md).
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "core/geometry/cubic.h"
#include "core/paper/folded_state.h"
#include "io/fold_writer.h"

namespace kiri {

struct ObjOptions {
  std::string title;
  Box sheet{{0, 0}, {150, 150}};  ///< box of the uncut sheet: texture coordinates 0 to 1 span it
  bool isTwoSided = false;  ///< a second set of triangles for the back, with the other winding
  double layerGap = 0;      ///< mm between a layer of a plane and the one below it
  double thickness = 0;    ///< mm; above zero each facet is a closed plate, the facet in its middle
  bool isPattern = false;  ///< the sheet at rest instead of the folded model
};

/// Triangles in mm, z up towards the viewer of the front: a group for each facet, texture
/// coordinates, normals. Curves become polylines.
Exported writeObj(const FoldedState& state, const ObjOptions& options);

}  // namespace kiri
