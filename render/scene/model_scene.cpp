// A picture of the folded model.
// SPDX-License-Identifier: MIT
#include "render/scene/model_scene.h"

#include <utility>

#include "render/scene/edge_on.h"
#include "render/scene/page.h"
#include "render/scene/paper_items.h"
#include "render/scene/shadow.h"
#include "render/visibility/grid.h"
#include "render/visibility/visible_regions.h"

namespace kiri {
namespace {

/// The box of what is drawn.
Box boxOfPicture(const FoldedState& state, const ViewFrame& view, const VisibleRegions& regions) {
  Box box = boundsOf(regions);
  bool isEmpty = regions.facets.empty();
  for (const SeenArc& line : edgeOnBorders(state, view)) {
    box = isEmpty ? boundsOf(line.arc) : joined(box, boundsOf(line.arc));
    isEmpty = false;
  }
  return box;
}

/// With the shadow, when there is one.
Box boxWithShadow(const FoldedState& state, const ViewFrame& view, const VisibleRegions& regions,
                  bool hasShadow) {
  Box box = boxOfPicture(state, view, regions);
  if (!hasShadow || view.toEye.z <= 0) return box;
  for (const Vec3 p : shadowPoints(state)) {
    const Vec2 at = view.project(p);
    box = joined(box, {at, at});
  }
  return box;
}

/// The frame for a picture of the state; `options.sphere` may be that of other states too.
Result<ViewFrame> frameFor(const FoldedState& state, const ViewSpec& spec,
                           const ModelSceneOptions& options) {
  const Sphere own = sphereOf(state, spec);
  const Sphere sphere = options.sphere.value_or(own);
  Result<ViewFrame> view = frameOf(spec, sphere);
  if (!view || !view->isPerspective()) return view;
  Result<ViewFrame> isOutside = withEye(*view, own, distance(view->eye(), own.centre));
  return isOutside ? view : isOutside;
}

Result<Scene> drawn(const FoldedState& state, const Appearance& appearance, const ViewFrame& view,
                    bool hasShadow, const ModelSceneOptions& options) {
  const VisibleRegions regions = visibleRegions(state, view);
  const Box box = options.box.value_or(boxWithShadow(state, view, regions, hasShadow));
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
  if (hasShadow) {
    Result<Group> shadow = shadowGroup(state, view, viewToScene, options.progress);
    if (!shadow) return shadow.error();
    if (!shadow->items.empty()) scene.groups.push_back(std::move(*shadow));
  }
  for (Group& group : paperGroups(state, regions, view, viewToScene, appearance, "")) {
    scene.groups.push_back(std::move(group));
  }
  return scene;
}

/// The state as the spec shows it, and what is left to do then.
struct Shown {
  Shown(const FoldedState& paper, const ViewSpec& wanted)
      : copy(spreadFor(paper, wanted)), state(copy ? *copy : paper), spec(wanted) {
    spec.explode = spec.thickness = 0;
  }
  Shown(const Shown&) = delete;
  Shown& operator=(const Shown&) = delete;

  std::optional<FoldedState> copy;
  const FoldedState& state;
  ViewSpec spec;
};

}  // namespace

Scene modelScene(const FoldedState& state, const Appearance& appearance, const ViewFrame& view,
                 const ModelSceneOptions& options) {
  return drawn(state, appearance, view, false, options).value();
}

Result<Scene> modelScene(const FoldedState& state, const Appearance& appearance,
                         const ViewSpec& spec, const ModelSceneOptions& options) {
  const Status status = checkViewSpec(spec);
  if (!status) return status.error();
  if (!goesOn(options.progress, 0)) return Error{ErrorCode::Cancelled, "", {}};
  const Shown shown(state, spec);
  const Result<ViewFrame> view = frameFor(shown.state, shown.spec, options);
  if (!view) return view.error();
  Appearance looks = appearance;
  looks.isShaded = looks.isShaded || spec.isShaded;
  return drawn(shown.state, looks, *view, spec.hasShadow, options);
}

Result<Box> pictureBox(const FoldedState& state, const ViewSpec& spec,
                       const ModelSceneOptions& options) {
  const Status status = checkViewSpec(spec);
  if (!status) return status.error();
  const Shown shown(state, spec);
  const Result<ViewFrame> view = frameFor(shown.state, shown.spec, options);
  if (!view) return view.error();
  return boxWithShadow(shown.state, *view, visibleRegions(shown.state, *view), spec.hasShadow);
}

}  // namespace kiri
