// What the gallery shows of leaves beside other models: their measures.
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "apps/cli/gallery_entry.h"
#include "core/leaf/leaf_measures.h"
#include "core/model/model.h"
#include "core/paper/folded_state.h"
#include "render/scene/appearance.h"
#include "render/scene/scene.h"

namespace kiri::cli {

/// The measures of a finished model that is a palmate leaf: one piece of paper that lies unfolded,
/// with a margin cut along a curve, and at least three creases that meet in one place of the
/// margin, the petiole. None for everything else.
std::optional<LeafMeasures> galleryLeafOf(const Model& model, const FoldedState& finished,
                                          bool isOpen);

/// The rows of the tables: the measures that are one number, and the lobes and sinuses.
std::vector<GalleryMeasure> galleryMeasuresOf(const LeafMeasures& measures);
std::vector<GalleryMeasure> galleryMarginOf(const LeafMeasures& measures);

/// The leaf with its measures drawn in, on a page of kGalleryPage.
Scene galleryMeasureScene(const FoldedState& finished, const LeafMeasures& measures,
                          const Appearance& appearance);

}  // namespace kiri::cli
