// SPDX-License-Identifier: MIT
#include "core/paper/facet_bounds.h"

namespace kiri {

Box boundsOf(const CreasePattern& pattern, const Facet& facet) {
  Box box = boundsOf(arcOf(pattern, facet.border.front()));
  for (const EdgeUse use : facet.border) box = joined(box, boundsOf(arcOf(pattern, use)));
  return box;
}

}  // namespace kiri
