// The paper of a picture: fills without cracks between them, and their borders.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "core/paper/folded_state.h"
#include "render/scene/appearance.h"
#include "render/scene/scene.h"
#include "render/visibility/view_frame.h"
#include "render/visibility/visible_regions.h"

namespace kiri {

/// How a facet is filled that lies in the scene as `paperToScene` says.
Fill fillOf(const Appearance& appearance, bool showsFront, const Affine& paperToScene);

/// The paper frame of a facet in the coordinates of an orthographic view.
Affine paperToView(const Rigid& pose, const ViewFrame& view);

/// The visible parts of a model as groups `prefix` + "seams", "paper", "shades", "creases" and
/// "edges". The
/// seams are drawn below the fills, in the fill of one neighbour and wide enough that no renderer
/// lets the ground shine through where two fills meet; they are clipped to the silhouette. Lines in
/// true width whatever the map's scale.
std::vector<Group> paperGroups(const FoldedState& state, const VisibleRegions& regions,
                               const ViewFrame& view, const Affine& viewToScene,
                               const Appearance& appearance, const std::string& prefix);

/// mm that the underlay of a seam is wide: more than two pixels of a coarse screen.
inline constexpr double kSeamWidth = 1;

}  // namespace kiri
