// Which faces of a line map are paper.
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "core/creases/crease_drawing.h"
#include "core/creases/map_faces.h"

namespace kiri {

/// Paper within lines of one assignment, by face: what an odd number of them separates from the
/// outside at least. A region inside a border inside paper is a hole; two regions side by side with
/// a border between them are both paper.
std::vector<bool> paperWithin(const LineMap& map, const MapFaces& faces, Assignment rim);

/// Paper where the drawing's own faces are. `misfits` names the faces (by position in the drawing)
/// that do not lie in one face of the map each, or would make a crease end the paper: where there
/// are any, `isPaper` is not to be relied upon.
struct PaperOfFaces {
  std::vector<bool> isPaper;  ///< by face of the map
  std::vector<std::uint32_t> misfits;
};
PaperOfFaces paperOfFaces(const LineMap& map, const MapFaces& faces,
                          const std::vector<std::vector<Vec2>>& drawn, double within);

}  // namespace kiri
