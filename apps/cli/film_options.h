// What kiri animate and animated exports are told about time and camera.
// SPDX-License-Identifier: MIT
#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>
#include <vector>

#include "apps/cli/console.h"
#include "apps/cli/model_input.h"
#include "core/model/timeline.h"
#include "render/film/film.h"

namespace kiri::cli {

struct TimeOptions {
  std::optional<double> speed;
  std::string ease = "smooth";
  std::optional<double> hold;
  std::string steps;
};

/// Declares --speed, --ease, --hold and --steps.
void addTimeOptions(CLI::App& command, TimeOptions& options);

/// Errors of --speed, --ease and --hold, told before any work is done.
Status checkTimeOptions(const TimeOptions& options);

/// What they mean for a model with so many steps. Errors: BadValue - steps that are not there.
Result<TimelineOptions> timelineOptionsOf(const TimeOptions& options, std::size_t stepCount);

/// The time line of a model, with progress; prints the collisions on the way. Errors: those of
/// Timeline::of, naming the file.
Result<Timeline> timelineOf(Console& console, const ModelInput& input,
                            const TimelineOptions& options);

/// Width and height of "640x480". Errors: BadValue.
struct PixelSize {
  int width = 0;
  int height = 0;
};
Result<PixelSize> pixelSizeOf(const std::string& text);

/// The stations of "0,90@0 40,35@0.5 180,20@1": azimuth, elevation, share of the time. Errors:
/// BadValue - with the part that cannot be understood.
Result<std::vector<CameraKey>> cameraOf(const std::string& text);

}  // namespace kiri::cli
