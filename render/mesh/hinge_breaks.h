// Where folded hinges are divided, so that the paper on both sides of them shares its points.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "core/paper/folded_state.h"
#include "render/visibility/plane_regions.h"

namespace kiri {

/// A hinge whose two facets lie in different planes, or on each other.
bool isFoldedHinge(const Edge& edge);

/// A layer that ends on a hinge divides what is seen there in its own plane only. The plane on the
/// other side of the hinge must have the same point, or a gap of a fraction of a pixel opens (a
/// T-junction).
class HingeBreaks {
 public:
  HingeBreaks(const FoldedState& state, const std::vector<PlaneRegions>& planes);

  /// Parameters strictly between `from` and `to` at which the folded hinge is divided, as
  /// parameters of the piece from `from` (0) to `to` (1), rising.
  std::vector<double> within(EdgeId hinge, double from, double to) const;

  /// How many intervals all hinges have together.
  std::size_t intervals() const { return breaks_.size(); }
  /// The number of the interval of the folded hinge that holds the parameter.
  std::size_t intervalAt(EdgeId hinge, double t) const;

 private:
  void collect(const CreasePattern& pattern, const VisibleRegions& regions);

  std::vector<std::pair<std::uint32_t, double>> breaks_;  ///< hinge and parameter, sorted; 0 first
  double tolerance_ = 0;
};

}  // namespace kiri
