// Images without anything see-through, for formats whose paper has no colour below its image.
// SPDX-License-Identifier: MIT
#pragma once

#include "core/model/model.h"
#include "render/scene/image.h"

namespace kiri {

/// The image as it looks on paper of that colour: every pixel opaque.
Image overColor(Image image, Color paper);

}  // namespace kiri
