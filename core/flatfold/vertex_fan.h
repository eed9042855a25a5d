// The folded creases around a vertex, and the angles between them.
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "core/creases/assigned_pattern.h"

namespace kiri {

/// Creases that fold at a vertex inside the paper, counter-clockwise. Sector i, in degrees, lies
/// between crease i and the next; a single crease has one sector of 360.
struct VertexFan {
  VertexId vertex;
  std::vector<EdgeId> creases;
  std::vector<double> sectors;
  double slack = 0;  ///< degrees by which the sectors may change in all when ends move by 1 mm

  /// Degrees by which alternate sectors miss 180. Requires an even number of creases.
  double kawasakiMiss() const;
  /// Degrees by which sectors may be off when the ends of creases were drawn within `precision` mm.
  double explainedBy(double precision) const;
};

/// The fans of all vertices at which creases fold and no border, cut or tear ends, by vertex.
std::vector<VertexFan> fansInside(const AssignedPattern& creases);

}  // namespace kiri
