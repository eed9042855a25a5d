// Whether paper stands in other paper.
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "core/paper/folded_state.h"

namespace kiri {

/// Two facets of different planes whose insides pass through each other.
struct Pierced {
  FacetId first;
  FacetId second;
  Vec3 place;             ///< model frame, mm
  bool isCertain = true;  ///< false: hardly deeper than mere touching
};

/// The first such pair of a state, by its poses and angles; a certain one where there is one. What
/// lies in one plane is the matter of layer order. Depth counts as in sweep().
std::optional<Pierced> firstPierced(const FoldedState& state);

}  // namespace kiri
