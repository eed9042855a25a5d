// What kiri export writes: one function for each group of formats.
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

#include "apps/cli/console.h"
#include "apps/cli/film_options.h"
#include "apps/cli/model_input.h"
#include "io/fold_writer.h"
#include "io/gltf_writer.h"
#include "render/scene/appearance.h"

namespace kiri::cli {

struct ExportOptions {
  std::string model;
  std::string out;
  std::string format;
  std::string view;
  std::optional<double> step;
  bool isAsFolded = false;
  bool isTwoSided = false;
  std::optional<double> layerGap;
  std::optional<double> thickness;
  bool isAnimated = false;
  TimeOptions time;
};

/// Mistakes that can be told before any work is done.
Status checkExport(const ExportOptions& options, const std::string& format);

/// How glTF files show a model that looks like this.
GltfOptions gltfLooksOf(const ModelInput& input, const Appearance& appearance);

/// The state that is written, and how it came to be.
struct ExportSource {
  const ModelInput& input;
  const Replay& replay;
  const StepChoice& moment;
  const FoldedState& state;
};

/// The bytes of the file in a format that checkExport let pass.
Exported exportedAs(Console& console, const std::string& format, const ExportSource& source,
                    const ExportOptions& options);

/// The process in motion as glTF. Errors: those of Timeline::of, naming the file; Cancelled.
Result<Exported> exportedInMotion(Console& console, const ModelInput& input,
                                  const TimelineOptions& time, const ExportOptions& options);

}  // namespace kiri::cli
