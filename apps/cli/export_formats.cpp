// What kiri export writes: one function for each group of formats.
// SPDX-License-Identifier: MIT
#include "apps/cli/export_formats.h"

#include <memory>
#include <utility>
#include <vector>

#include "apps/cli/picture_options.h"
#include "core/model/pattern_model.h"
#include "io/fold_history.h"
#include "io/gltf_animation.h"
#include "io/gltf_writer.h"
#include "io/obj_writer.h"
#include "io/stl_writer.h"
#include "io/svg_pattern_writer.h"
#include "render/canvas/png.h"
#include "render/scene/opaque_image.h"

namespace kiri::cli {

namespace {

bool isSolid(const std::string& format) {
  return format == "obj" || format == "stl" || format == "glb";
}

Status checkSolid(const ExportOptions& options, const std::string& format) {
  const auto isWrong = [](const std::optional<double>& mm) {
    constexpr double kWidest = 100;
    return mm && !(*mm >= 0 && *mm <= kWidest);
  };
  if (isWrong(options.layerGap)) {
    return Error{ErrorCode::BadValue, "--layer-gap must lie between 0 and 100 mm"};
  }
  if (isWrong(options.thickness)) {
    return Error{ErrorCode::BadValue, "--thickness must lie between 0 and 100 mm"};
  }
  if (format != "obj" && options.isTwoSided) {
    return Error{ErrorCode::BadValue, "--two-sided goes with obj"};
  }
  if (!isSolid(format) && (options.layerGap || options.thickness)) {
    return Error{ErrorCode::BadValue, "--layer-gap and --thickness go with obj, stl and glb"};
  }
  return std::monostate{};
}

std::vector<FoldFrame> historyOf(const ExportSource& source) {
  std::vector<std::shared_ptr<const FoldedState>> after;
  for (std::size_t i = 0; i < source.moment.done; ++i)
    after.push_back(source.replay.outcomes[i].state);
  return foldHistoryOf(
      source.input.model, after,
      source.moment.part > 0 ? std::make_shared<const FoldedState>(source.state) : nullptr);
}

Exported foldOf(const ExportSource& source, const ExportOptions& options) {
  const FoldOptions fold{"KiriSim " KIRI_VERSION, titleOf(source.input), source.input.model.notes};
  if (options.view != "pattern") return writeFold(source.state, historyOf(source), fold);
  return writeFold(options.isAsFolded ? asFolded(source.state) : source.state, {}, fold);
}

Exported svgOf(const ExportSource& source, const ExportOptions& options) {
  SvgPatternOptions svg;
  svg.title = titleOf(source.input);
  return {writeSvgPattern(options.isAsFolded ? asFolded(source.state) : source.state, svg), {}};
}

Exported objOf(const ExportSource& source, const ExportOptions& options) {
  ObjOptions obj;
  obj.title = titleOf(source.input);
  obj.sheet = appearanceOf(source.input.model).textureBox;
  obj.isTwoSided = options.isTwoSided;
  obj.layerGap = options.layerGap.value_or(obj.layerGap);
  obj.thickness = options.thickness.value_or(obj.thickness);
  obj.isPattern = options.view == "pattern";
  return writeObj(source.state, obj);
}

Exported stlOf(const ExportSource& source, const ExportOptions& options) {
  StlOptions stl;
  stl.layerGap = options.layerGap.value_or(stl.layerGap);
  stl.thickness = options.thickness.value_or(stl.thickness);
  stl.isPattern = options.view == "pattern";
  return writeStl(source.state, stl);
}

GltfSide gltfSide(const SideLook& look) {
  GltfSide side{look.color, ""};
  if (!look.texture) return side;
  const Result<std::string> png = encodePng(overColor(*look.texture, look.color), 0);
  if (png.isOk()) side.png = *png;
  return side;
}

GltfOptions gltfOptionsOf(Console& console, const ModelInput& input, const ExportOptions& options) {
  const Result<Appearance> appearance = appearanceFor(console, input, {});
  GltfOptions gltf = gltfLooksOf(input, appearance ? *appearance : appearanceOf(input.model));
  gltf.layerGap = options.layerGap.value_or(gltf.layerGap);
  gltf.thickness = options.thickness.value_or(gltf.thickness);
  gltf.isPattern = options.view == "pattern";
  return gltf;
}

/// Mistakes about time.
Status checkMotion(const ExportOptions& options, const std::string& format) {
  const TimeOptions& time = options.time;
  if (!options.isAnimated) {
    if (!time.speed && !time.hold && time.steps.empty()) return std::monostate{};
    return Error{ErrorCode::BadValue, "--speed, --ease, --hold and --steps go with --animate"};
  }
  if (format != "glb") return Error{ErrorCode::BadValue, "--animate goes with glb"};
  if (options.step) {
    return Error{ErrorCode::BadValue,
                 "--animate shows all steps, or those of --steps; leave --step out"};
  }
  if (options.view == "pattern") {
    return Error{ErrorCode::BadValue, "--animate shows the folded model, not the pattern"};
  }
  return checkTimeOptions(time);
}

}  // namespace

GltfOptions gltfLooksOf(const ModelInput& input, const Appearance& appearance) {
  GltfOptions gltf;
  gltf.generator = "KiriSim " KIRI_VERSION;
  gltf.title = titleOf(input);
  gltf.sheet = appearance.textureBox;
  gltf.front = gltfSide(appearance.front);
  gltf.back = gltfSide(appearance.back);
  return gltf;
}

Status checkExport(const ExportOptions& options, const std::string& format) {
  if (!options.view.empty() && options.view != "folded" && options.view != "pattern") {
    return Error{ErrorCode::BadValue,
                 "--view " + options.view + " is not known; it takes folded or pattern"};
  }
  if (format == "svg" && options.view == "folded") {
    return Error{ErrorCode::BadValue,
                 "export writes SVG of the crease pattern; for the folded model use kiri render"};
  }
  if (options.isAsFolded && isSolid(format)) {
    return Error{ErrorCode::BadValue, "--as-folded goes with fold and svg"};
  }
  if (options.isAsFolded && format == "fold" && options.view != "pattern") {
    return Error{ErrorCode::BadValue, "--as-folded goes with --view pattern"};
  }
  const Status motion = checkMotion(options, format);
  return motion.isOk() ? checkSolid(options, format) : motion;
}

Exported exportedAs(Console& console, const std::string& format, const ExportSource& source,
                    const ExportOptions& options) {
  if (format == "fold") return foldOf(source, options);
  if (format == "svg") return svgOf(source, options);
  if (format == "obj") return objOf(source, options);
  if (format == "stl") return stlOf(source, options);
  return writeGlb(source.state, gltfOptionsOf(console, source.input, options));
}

Result<Exported> exportedInMotion(Console& console, const ModelInput& input,
                                  const TimelineOptions& time, const ExportOptions& options) {
  const Result<Timeline> timeline = timelineOf(console, input, time);
  if (!timeline.isOk()) return timeline.error();
  const GltfOptions gltf = gltfOptionsOf(console, input, options);
  ProgressLine line(console, "writing");
  return writeAnimatedGlb(*timeline, gltf, line.progress());
}

}  // namespace kiri::cli
