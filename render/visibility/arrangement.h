// All borders of the facets in sight, cut where they meet: a planar map of the view.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "core/geometry/cubic.h"
#include "render/visibility/facet_view.h"

namespace kiri {

/// That a side of the map is part of an arc of a facet's border. The side runs from t0 to t1 on the
/// arc as the facet runs along it (paper on the left); t0 > t1 when the side has the facet on its
/// right.
struct SideUse {
  static constexpr std::uint32_t kEnd = std::numeric_limits<std::uint32_t>::max();
  std::uint32_t facet = 0;  ///< place in FacetViews::all()
  std::uint32_t arc = 0;    ///< place in its arcs
  double t0 = 0;
  double t1 = 1;
  bool isForward = true;      ///< the facet is on the left of the side
  std::uint32_t next = kEnd;  ///< the next use of the same side
};

/// A side of the planar map. Sides meet at their ends only, and no two coincide.
struct Side {
  std::uint32_t from = 0;  ///< vertex
  std::uint32_t to = 0;
  Arc arc;  ///< its ends are the vertices
  std::uint32_t firstUse = SideUse::kEnd;
};

struct Arrangement {
  std::vector<Vec2> vertices;
  std::vector<Side> sides;
  std::vector<SideUse> uses;
};

/// The planar map of the borders of the facets `inSight`, and of the lines in which two of them
/// pass through each other. Points nearer than tolerance.match() are one vertex.
Arrangement arrange(const FacetViews& views, const std::vector<std::uint32_t>& inSight);

}  // namespace kiri
