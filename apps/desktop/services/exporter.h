// The open model as a file of another kind, written beside the window.
// SPDX-License-Identifier: MIT
#pragma once

#include <QString>
#include <optional>
#include <string>
#include <vector>

#include "apps/desktop/services/export_source.h"
#include "core/base/progress.h"
#include "core/base/result.h"
#include "render/scene/appearance.h"
#include "render/scene/scene.h"
#include "render/scene/view_spec.h"

namespace kiri::desktop {

enum class ExportSubject { Model, Sheet };
enum class ExportFormat { Svg, Pdf, Png, Fold, Obj, Stl, Gltf, Cp, Opx, Dxf };
enum class ExportView { Screen, Front, Back, Angled };

/// Ending of the file's name: "svg", "glb".
QString endingOf(ExportFormat format);
bool isPicture(ExportFormat format);
/// Crease patterns of other programs, that hold the sheet only.
bool isPatternOnly(ExportFormat format);

struct ExportRequest {
  ExportSubject subject = ExportSubject::Model;
  ExportFormat format = ExportFormat::Svg;
  QString path;

  // Pictures.
  ExportView view = ExportView::Screen;
  LineStyle lineStyle = LineStyle::Thesis;
  double scale = 1;
  double margin = 5;  ///< mm
  double dpi = 200;   ///< PNG
  bool showsCreases = true;
  bool isShaded = false;
  bool hasShadow = false;
  bool isLinesOnly = false;   ///< sheet: without the colour of the paper
  bool isForMachines = true;  ///< sheet as SVG: layers and colours for cutters and origami programs
  std::optional<Color> background;

  // Other programs.
  bool isAsFolded = false;  ///< sheet: creases of an open model get the angle of their fold
  double layerGap = 0;      ///< mm
  double thickness = 0;     ///< mm
  bool isTwoSided = false;  ///< OBJ
  bool isAnimated = false;  ///< glTF: all steps in motion
  QString version = "0";    ///< of KiriSim, noted in files
};

/// The picture that a request for SVG, PDF or PNG means; also for previews and for printing.
/// Errors: those of modelScene; Cancelled.
Result<Scene> sceneOf(const ExportSource& source, const ExportRequest& request,
                      const Progress& progress = {});

/// What a crease pattern in this format will lack, in sentences, before anything is written;
/// nothing for other formats.
std::vector<std::string> lossesOf(const ExportSource& source, const ExportRequest& request);

/// Writes the file. The value: what the format could not hold, in sentences. Errors: those of the
/// writers, Unwritable, Cancelled; an existing file is unchanged then.
Result<std::vector<std::string>> exportTo(const ExportSource& source, const ExportRequest& request,
                                          const Progress& progress = {});

}  // namespace kiri::desktop
