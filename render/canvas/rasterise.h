// A scene as pixels of a given count, for frames of films and for windows.
// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/result.h"
#include "render/scene/image.h"
#include "render/scene/scene.h"

namespace kiri {

/// The scene as large as fits into width x height pixels, in their middle, on its background (white
/// when it has none); every pixel opaque. Errors: BadValue - a scene without size, or less than 1
/// or more than 16384 pixels on a side.
Result<Image> rasterise(const Scene& scene, int width, int height);

/// The same without a background: what is not drawn on is transparent, pixels at its border in
/// part. For pictures that are laid on something.
Result<Image> rasteriseTransparent(const Scene& scene, int width, int height);

}  // namespace kiri
