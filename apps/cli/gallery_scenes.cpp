// What the gallery's pictures of a model show.
// SPDX-License-Identifier: MIT
#include "apps/cli/gallery_scenes.h"

#include <algorithm>
#include <utility>
#include <variant>

#include "render/scene/model_scene.h"
#include "render/scene/pattern_scene.h"
#include "render/visibility/visible_regions.h"

namespace kiri::cli {

namespace {

/// Areas that differ by less are one: rounding shall not choose the view.
constexpr double kSameArea = 0.01;

/// From where a model that is half open may be looked at; from nearer the front rather than from
/// behind.
struct AslantView {
  double azimuth = 0;
  double elevation = 0;
  double preference = 1;
};
constexpr AslantView kAslantViews[] = {
    {20, 40, 1},     {-20, 40, 1},    {60, 40, 0.95},   {-60, 40, 0.95}, {100, 40, 0.9},
    {-100, 40, 0.9}, {150, 40, 0.85}, {-150, 40, 0.85}, {20, -40, 0.8},  {-20, -40, 0.8},
};

/// The view that shows the most paper.
Result<ViewSpec> aslantSpec(const FoldedState& state) {
  ViewSpec best;
  double most = -1;
  const Sphere sphere = sphereOf(state);
  for (const AslantView& aslant : kAslantViews) {
    ViewSpec spec{aslant.azimuth, aslant.elevation};
    spec.isShaded = true;
    const Result<ViewFrame> frame = frameOf(spec, sphere);
    if (!frame) return frame.error();
    double seen = 0;
    for (const VisibleFacet& facet : visibleRegions(state, *frame).facets) seen += areaOf(facet);
    if (seen * aslant.preference <= most * (1 + kSameArea)) continue;
    most = seen * aslant.preference;
    best = spec;
  }
  return best;
}

/// The model so large that it fills the page.
Result<Scene> pageOf(const FoldedState& state, const Appearance& appearance, const ViewSpec& spec,
                     const Progress& progress) {
  ModelSceneOptions options;
  options.progress = progress;
  const Result<Box> box = pictureBox(state, spec, options);
  if (!box) return box.error();
  const Vec2 size = box->high - box->low;
  const double larger = std::max(size.x, size.y);
  if (larger > 0) options.scale = (kGalleryPage - 2 * options.margin) / larger;
  return modelScene(state, appearance, spec, options);
}

Scene patternPage(const FoldedState& state, const Appearance& appearance) {
  PatternSceneOptions options;
  options.fill = PatternFill::None;
  options.margin = 0;
  const Scene plain = patternScene(state, appearance, options);
  options.margin = PatternSceneOptions{}.margin;
  const double larger = std::max(plain.width, plain.height);
  if (larger > 0) options.scale = (kGalleryPage - 2 * options.margin) / larger;
  return patternScene(state, appearance, options);
}

class GalleryScenes {
 public:
  GalleryScenes(const Appearance& appearance, const Progress& progress)
      : appearance_(appearance), progress_(progress) {}

  void add(const std::string& label, const std::string& file, const FoldedState& state,
           const ViewSpec& spec) {
    if (error_.isOk()) add(label, file, pageOf(state, appearance_, spec, progress_));
  }

  void add(const std::string& label, const std::string& file, Result<Scene> scene) {
    if (!scene) {
      error_ = scene.error();
    } else {
      scenes_.push_back({label, file, std::move(*scene)});
    }
  }

  Result<std::vector<GalleryScene>> take() {
    if (!error_) return error_.error();
    return std::move(scenes_);
  }

 private:
  const Appearance& appearance_;
  const Progress& progress_;
  std::vector<GalleryScene> scenes_;
  Status error_ = std::monostate{};
};

}  // namespace

Result<std::vector<GalleryScene>> galleryScenesOf(const Timeline& timeline, std::size_t steps,
                                                  const Moments& moments,
                                                  const Appearance& appearance,
                                                  const Progress& progress) {
  const FoldedState& finished = timeline.stateAfter(steps);
  const FoldedState& folded = timeline.stateAfter(moments.folded);
  const bool isFoldedAtTheEnd = moments.folded == steps;
  const std::string how = isFoldedAtTheEnd         ? "finished and folded"
                          : moments.isOpenAtTheEnd ? "finished and unfolded"
                                                   : "finished";
  GalleryScenes scenes(appearance, progress);
  scenes.add(how + ", front", "finished", finished, frontSpec());
  scenes.add(how + ", back", "back", finished, backSpec());
  if (!isFoldedAtTheEnd) scenes.add("folded", "folded", folded, frontSpec());
  if (moments.half) {
    const bool isUnfolding = moments.halfWay == HalfWay::Unfolding;
    const Result<ViewSpec> aslant = aslantSpec(*moments.half);
    if (!aslant) return aslant.error();
    scenes.add(isUnfolding ? "half unfolded" : "the last fold, half done", "half", *moments.half,
               *aslant);
  }
  if (!moments.isOpenAtTheEnd) {
    scenes.add("unfolded, front", "unfolded", moments.unfolded, frontSpec());
  }
  scenes.add("crease pattern", "pattern", patternPage(folded, appearance));
  return scenes.take();
}

std::size_t galleryEmblemOf(const std::vector<GalleryScene>& scenes, const Model& model,
                            const Moments& moments) {
  const bool isCut = std::any_of(model.steps.begin(), model.steps.end(), [](const Step& step) {
    return std::holds_alternative<CurveCutStep>(step.action) ||
           std::holds_alternative<StraightCutStep>(step.action);
  });
  if (isCut || !moments.isOpenAtTheEnd) return 0;
  const auto half = std::find_if(scenes.begin(), scenes.end(),
                                 [](const GalleryScene& scene) { return scene.file == "half"; });
  return half == scenes.end() ? 0 : static_cast<std::size_t>(half - scenes.begin());
}

std::string halfWayRemark(HalfWay halfWay) {
  switch (halfWay) {
    case HalfWay::Unfolding:
      return "";
    case HalfWay::LastFold:
      return "To open it all at once, or crease by crease, the paper would have to bend; so the "
             "last fold is shown half done.";
    case HalfWay::None:
      return "It is not shown half unfolded: on the way the paper would have to bend.";
  }
  return "";
}

Scene galleryPattern(const FoldedState& folded, const Appearance& appearance) {
  PatternSceneOptions lines;
  lines.fill = PatternFill::None;
  return patternScene(folded, appearance, lines);
}

}  // namespace kiri::cli
