// The measures of an outline by name.
// SPDX-License-Identifier: MIT
#include "apps/cli/measure_names.h"

namespace kiri::cli {

std::vector<NamedMeasure> namedMeasures(const LeafMeasures& m) {
  return {{"length", "mm", "length, petiole to apex", m.length},
          {"fullLength", "mm", "length of all of it", m.fullLength},
          {"width", "mm", "width", m.width},
          {"area", "mm2", "area", m.area},
          {"perimeter", "mm", "perimeter", m.perimeter},
          {"aspectRatio", "", "aspect ratio, length to width", m.aspectRatio},
          {"circularity", "", "circularity, 4π area / perimeter²", m.circularity},
          {"solidity", "", "solidity, area to area of the hull", m.solidity},
          {"perimeterRatio", "", "perimeter to perimeter of the hull", m.perimeterRatio},
          {"asymmetry", "mm", "greatest distance to the mirror image", m.asymmetry},
          {"leftArea", "mm2", "area left of the axis", m.leftArea},
          {"rightArea", "mm2", "area right of the axis", m.rightArea},
          {"lobes", "", "lobes", static_cast<double>(m.lobeCount)},
          {"sinuses", "", "sinuses", static_cast<double>(m.sinusCount)}};
}

}  // namespace kiri::cli
