// Layer order through a rotation: facets leave their layer-sets and land on others (thesis 5.4.1,
// phase A). SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "core/paper/folded_state.h"

namespace kiri {

/// A rigid rotation of some facets about a line of the model frame, counter-clockwise seen against
/// the axis.
struct Motion {
  Vec3 point;  ///< on the axis, mm
  Vec3 axis;   ///< unit direction
  double degrees = 0;
};

/// One moving facet and one fixed facet that get in each other's way.
struct Contact {
  CollisionMoment moment = CollisionMoment::Start;
  FacetId moving;
  FacetId fixed;
};

struct Relayered {
  LayerOrder order;
  std::vector<Contact> contacts;  ///< at most kMostContacts for each moment
};

inline constexpr std::size_t kMostContacts = 16;

/// The layer order after the facets for which `moves` is true have made the motion, and what
/// collides as it begins and as it ends (not in between). A moving facet comes to lie above what it
/// lands on from above, and below what it lands on from below; pairs that move together and pairs
/// that rest keep their order. Where a facet lands on both sides of another, that is a contact, and
/// the side with more overlap decides. `state` is before the motion; `after` holds the poses after
/// it. Source: thesis 5.4.1; a facet that straddles the axis is tested on either side, which the
/// thesis does not.
Relayered relayer(const FoldedState& state, const std::vector<bool>& moves, const Motion& motion,
                  const std::vector<Rigid>& after);

}  // namespace kiri
