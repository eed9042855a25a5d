// Textures in perspective.
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>

#include "core/geometry/cubic.h"
#include "core/geometry/rigid.h"
#include "render/scene/image.h"
#include "render/scene/scene.h"
#include "render/visibility/view_frame.h"

namespace kiri {

/// The texture of a facet as it appears within `box` (view coordinates): a fill image is laid out
/// evenly, perspective is not, so it is sampled anew, finely enough that no pixel of the texture is
/// lost. The unit square of the result is the box. `imageToPaper` takes the unit square of the
/// texture to the paper frame; beyond its rim the rim goes on.
std::shared_ptr<const Image> seenTexture(const Image& texture, const Affine& imageToPaper,
                                         const Rigid& pose, const ViewFrame& view, const Box& box);

}  // namespace kiri
