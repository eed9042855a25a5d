// The open model as a file of another kind.
// SPDX-License-Identifier: MIT
#include "apps/desktop/services/exporter.h"

#include <utility>

#include "apps/desktop/services/textures.h"
#include "core/creases/repair.h"
#include "core/model/pattern_model.h"
#include "core/model/timeline.h"
#include "io/file.h"
#include "io/fold_history.h"
#include "io/gltf_animation.h"
#include "io/obj_writer.h"
#include "io/patterns/pattern_file.h"
#include "io/stl_writer.h"
#include "io/svg_pattern_writer.h"
#include "render/canvas/png.h"
#include "render/canvas/write.h"
#include "render/scene/model_scene.h"
#include "render/scene/opaque_image.h"
#include "render/scene/pattern_scene.h"

namespace kiri::desktop {

namespace {

Error cancelled() { return {ErrorCode::Cancelled, "", {}}; }

Appearance looksOf(const ExportSource& source, const ExportRequest& request) {
  Appearance looks = appearanceWithTextures(source.model, source.path);
  looks.lineStyle = request.lineStyle;
  looks.showCreases = request.showsCreases;
  looks.isShaded = request.isShaded;
  return looks;
}

/// The state whose pattern is drawn or written.
FoldedState patternStateOf(const ExportSource& source, const ExportRequest& request) {
  return request.isAsFolded ? asFolded(*source.state) : *source.state;
}

std::string generatorOf(const ExportRequest& request) {
  return "KiriSim " + request.version.toStdString();
}

GltfSide gltfSide(const SideLook& look) {
  GltfSide side{look.color, ""};
  if (!look.texture) return side;
  const Result<std::string> png = encodePng(overColor(*look.texture, look.color), 0);
  if (png.isOk()) side.png = *png;
  return side;
}

GltfOptions gltfOptionsOf(const ExportSource& source, const ExportRequest& request) {
  const Appearance looks = looksOf(source, request);
  GltfOptions gltf;
  gltf.generator = generatorOf(request);
  gltf.title = source.title.toStdString();
  gltf.sheet = looks.textureBox;
  gltf.front = gltfSide(looks.front);
  gltf.back = gltfSide(looks.back);
  gltf.layerGap = request.layerGap;
  gltf.thickness = request.thickness;
  gltf.isPattern = request.subject == ExportSubject::Sheet;
  return gltf;
}

Exported foldOf(const ExportSource& source, const ExportRequest& request) {
  const FoldOptions fold{generatorOf(request), source.title.toStdString(), source.model.notes};
  if (request.subject == ExportSubject::Sheet) {
    return writeFold(patternStateOf(source, request), {}, fold);
  }
  return writeFold(*source.state, foldHistoryOf(source.model, source.after), fold);
}

Exported objOf(const ExportSource& source, const ExportRequest& request) {
  ObjOptions obj;
  obj.title = source.title.toStdString();
  obj.sheet = appearanceOf(source.model).textureBox;
  obj.isTwoSided = request.isTwoSided;
  obj.layerGap = request.layerGap;
  obj.thickness = request.thickness;
  obj.isPattern = request.subject == ExportSubject::Sheet;
  return writeObj(*source.state, obj);
}

Exported stlOf(const ExportSource& source, const ExportRequest& request) {
  StlOptions stl;
  stl.layerGap = request.layerGap;
  stl.thickness = request.thickness;
  stl.isPattern = request.subject == ExportSubject::Sheet;
  return writeStl(*source.state, stl);
}

Result<Exported> gltfOf(const ExportSource& source, const ExportRequest& request,
                        const Progress& progress) {
  const GltfOptions gltf = gltfOptionsOf(source, request);
  if (!request.isAnimated) return writeGlb(*source.state, gltf);
  TimelineOptions options;
  options.lastStep = source.cursor;
  // Folding and writing take about the same time.
  const Result<Timeline> timeline =
      Timeline::of(source.model, options, [&](double done) { return goesOn(progress, done / 2); });
  if (!timeline.isOk()) return timeline.error();
  return writeAnimatedGlb(*timeline, gltf,
                          [&](double done) { return goesOn(progress, (1 + done) / 2); });
}

Result<std::string> picture(const Scene& scene, const ExportRequest& request) {
  if (request.format == ExportFormat::Svg) return writeSvg(scene);
  if (request.format == ExportFormat::Pdf) return writePdf(scene);
  return writePng(scene, {request.dpi});
}

Result<Exported> pictureOf(const ExportSource& source, const ExportRequest& request,
                           const Progress& progress) {
  const bool isLayered = request.subject == ExportSubject::Sheet &&
                         request.format == ExportFormat::Svg && request.isForMachines;
  if (isLayered) {
    return Exported{writeSvgPattern(patternStateOf(source, request),
                                    {source.title.toStdString(), request.margin}),
                    {}};
  }
  const Result<Scene> scene = sceneOf(source, request, progress);
  if (!scene.isOk()) return scene.error();
  if (!goesOn(progress, 0.5)) return cancelled();
  Result<std::string> bytes = picture(*scene, request);
  if (!bytes.isOk()) return bytes.error();
  return Exported{std::move(*bytes), {}};
}

PatternFormat patternFormat(ExportFormat format) {
  if (format == ExportFormat::Opx) return PatternFormat::Opx;
  return format == ExportFormat::Dxf ? PatternFormat::Dxf : PatternFormat::Cp;
}

WrittenPattern patternFrom(const ExportSource& source, const ExportRequest& request) {
  PatternFile file;
  file.drawing = drawingOf(assignedPatternOf(*source.state, request.isAsFolded));
  file.title = source.title.toStdString();
  file.description = source.model.notes;
  file.mmPerUnit = 1;
  return writePattern(file, patternFormat(request.format));
}

Result<Exported> bytesOf(const ExportSource& source, const ExportRequest& request,
                         const Progress& progress) {
  switch (request.format) {
    case ExportFormat::Fold:
      return foldOf(source, request);
    case ExportFormat::Obj:
      return objOf(source, request);
    case ExportFormat::Stl:
      return stlOf(source, request);
    case ExportFormat::Gltf:
      return gltfOf(source, request, progress);
    case ExportFormat::Cp:
    case ExportFormat::Opx:
    case ExportFormat::Dxf: {
      WrittenPattern written = patternFrom(source, request);
      return Exported{std::move(written.text), std::move(written.losses)};
    }
    case ExportFormat::Svg:
    case ExportFormat::Pdf:
    case ExportFormat::Png:
      return pictureOf(source, request, progress);
  }
  return cancelled();
}

ViewSpec specOf(ExportView view) {
  if (view == ExportView::Back) return backSpec();
  ViewSpec spec = frontSpec();
  if (view == ExportView::Angled) spec = {20, 50};  // as films are
  return spec;
}

}  // namespace

QString endingOf(ExportFormat format) {
  switch (format) {
    case ExportFormat::Svg:
      return "svg";
    case ExportFormat::Pdf:
      return "pdf";
    case ExportFormat::Png:
      return "png";
    case ExportFormat::Fold:
      return "fold";
    case ExportFormat::Obj:
      return "obj";
    case ExportFormat::Stl:
      return "stl";
    case ExportFormat::Gltf:
      return "glb";
    case ExportFormat::Cp:
      return "cp";
    case ExportFormat::Opx:
      return "opx";
    case ExportFormat::Dxf:
      return "dxf";
  }
  return {};
}

bool isPicture(ExportFormat format) {
  return format == ExportFormat::Svg || format == ExportFormat::Pdf || format == ExportFormat::Png;
}

bool isPatternOnly(ExportFormat format) {
  return format == ExportFormat::Cp || format == ExportFormat::Opx || format == ExportFormat::Dxf;
}

std::vector<std::string> lossesOf(const ExportSource& source, const ExportRequest& request) {
  if (!isPatternOnly(request.format)) return {};
  return patternFrom(source, request).losses;
}

Result<Scene> sceneOf(const ExportSource& source, const ExportRequest& request,
                      const Progress& progress) {
  if (!goesOn(progress, 0)) return cancelled();
  const Appearance looks = looksOf(source, request);
  const std::string title = source.title.toStdString();
  Result<Scene> scene = [&]() -> Result<Scene> {
    if (request.subject == ExportSubject::Sheet) {
      return patternScene(patternStateOf(source, request), looks,
                          {request.margin, request.scale, title,
                           request.isLinesOnly ? PatternFill::None : PatternFill::Paper});
    }
    const ModelSceneOptions options{request.margin, request.scale, title, {}, {}, progress};
    if (request.view == ExportView::Screen) {
      return modelScene(*source.state, looks, source.screen, options);
    }
    ViewSpec spec = specOf(request.view);
    spec.hasShadow = request.hasShadow;
    return modelScene(*source.state, looks, spec, options);
  }();
  if (scene.isOk()) scene->background = request.background;
  return scene;
}

Result<std::vector<std::string>> exportTo(const ExportSource& source, const ExportRequest& request,
                                          const Progress& progress) {
  Result<Exported> exported = bytesOf(source, request, progress);
  if (!exported.isOk()) return exported.error();
  if (!goesOn(progress, 1)) return cancelled();
  const Status written = writeFile(request.path.toStdString(), exported->text);
  if (!written.isOk()) return written.error();
  return exported->losses;
}

}  // namespace kiri::desktop
