// A picture of the folded model.
// SPDX-License-Identifier: MIT
#include "render/scene/model_scene.h"

#include <utility>

#include "render/scene/page.h"
#include "render/scene/paper_items.h"
#include "render/visibility/visible_regions.h"

namespace kiri {

Scene modelScene(const FoldedState& state, const Appearance& appearance, const ViewFrame& view,
                 const ModelSceneOptions& options) {
  const VisibleRegions regions = visibleRegions(state, view);
  const Box box = boundsOf(regions);
  const Vec2 size = (box.high - box.low) * options.scale;
  const Vec2 margin{options.margin, options.margin};
  const Affine viewToScene = placed(box, options.scale, margin);

  Scene scene;
  scene.width = size.x + 2 * options.margin;
  scene.height = size.y + 2 * options.margin;
  scene.title = options.title;
  const Vec2 around = margin / options.scale;
  Group grid =
      gridGroup({box.low - around, box.high + around}, appearance.gridSpacing, viewToScene);
  if (!grid.items.empty()) scene.groups.push_back(std::move(grid));
  for (Group& group : paperGroups(state, regions, view, viewToScene, appearance, "")) {
    scene.groups.push_back(std::move(group));
  }
  return scene;
}

}  // namespace kiri
