// Scenes as SVG, PDF and PNG, in true size, without a screen.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "core/base/result.h"
#include "render/scene/scene.h"

namespace kiri {

/// SVG 1.1 in mm: one <g> for each group with its id, one element for each item. The same scene
/// gives the same bytes. Errors: BadValue - a scene without size.
Result<std::string> writeSvg(const Scene& scene);

/// One page of the scene's size. Errors: BadValue - a scene without size, or larger than PDF pages
/// may be (5 m).
Result<std::string> writePdf(const Scene& scene);

struct PngOptions {
  double dpi = 200;
};

/// Pixels at the given resolution, noted in the file, so that it prints in true size.
/// Errors: BadValue - a scene without size, or more than 30000 pixels wide or high; the message
/// says which dpi fits.
Result<std::string> writePng(const Scene& scene, const PngOptions& options = {});

}  // namespace kiri
