// What the gallery's pictures of a model show.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/model/moments.h"
#include "core/model/timeline.h"
#include "render/scene/appearance.h"
#include "render/scene/scene.h"

namespace kiri::cli {

struct GalleryScene {
  std::string label;  ///< "half unfolded"
  std::string file;   ///< without ending
  Scene scene;
};

/// A page whose larger side is `size` mm long: lines are drawn for that, whatever the paper's size.
constexpr double kGalleryPage = 127;

/// The finished model from both sides, folded, half unfolded, unfolded, and its crease pattern;
/// what would show the same as another is left out. Errors: Cancelled.
Result<std::vector<GalleryScene>> galleryScenesOf(const Timeline& timeline, std::size_t steps,
                                                  const Moments& moments,
                                                  const Appearance& appearance,
                                                  const Progress& progress);

/// Which of the scenes stands for the model: the finished one; half unfolded where that is a whole
/// sheet with creases, which shows nothing of it.
std::size_t galleryEmblemOf(const std::vector<GalleryScene>& scenes, const Model& model,
                            const Moments& moments);

/// Why the half unfolded model is not shown as it should be; empty where it is.
std::string halfWayRemark(HalfWay halfWay);

/// Lines only, in true size.
Scene galleryPattern(const FoldedState& folded, const Appearance& appearance);

}  // namespace kiri::cli
