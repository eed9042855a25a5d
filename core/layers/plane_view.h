// The facets of one plane, drawn in that plane.
// SPDX-License-Identifier: MIT
#pragma once

#include <unordered_map>
#include <vector>

#include "core/geometry/rigid.h"
#include "core/paper/crease_pattern.h"

namespace kiri {

/// One convex part of the ground a facet covers, counter-clockwise, in plane coordinates.
struct FootprintPart {
  std::vector<Vec2> points;
  Box box;
};

/// The ground a facet covers: parts sorted by the left sides of their boxes, and the box of all.
struct Footprint {
  std::vector<FootprintPart> parts;
  Box box;
};

/// Draws facets of one plane in the paper frame of a reference facet, so that flat models keep
/// exact coordinates. Footprints are made when first asked for. The pattern and poses must outlive
/// the view.
class PlaneView {
 public:
  PlaneView(const CreasePattern& pattern, const std::vector<Rigid>& poses, const Rigid& reference)
      : pattern_(pattern), poses_(poses), reference_(reference) {}

  const Footprint& footprint(FacetId facet);
  Vec2 toPlane(Vec3 model) const { return reference_.pullBack(model); }
  const Tolerance& tolerance() const { return pattern_.tolerance; }

  /// True when the two facets overlap in more than a seam.
  bool doOverlap(FacetId a, FacetId b);
  /// The same, of what lies on the left of the line from `a` along `direction` only.
  bool doOverlapLeftOf(FacetId f, FacetId g, Vec2 a, Vec2 direction);

 private:
  const CreasePattern& pattern_;
  const std::vector<Rigid>& poses_;
  Rigid reference_;
  std::unordered_map<std::uint32_t, Footprint> footprints_;
};

}  // namespace kiri
