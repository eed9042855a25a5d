// What the commands that make pictures have in common.
// SPDX-License-Identifier: MIT
#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "apps/cli/console.h"
#include "apps/cli/model_input.h"
#include "render/scene/appearance.h"
#include "render/scene/scene.h"

namespace kiri::cli {

struct PictureOptions {
  std::string out;
  std::string format;
  double dpi = 200;
  std::string style = "thesis";
  std::string background;
  bool hidesCreases = false;
};

/// Declares -o, --format, --dpi, --style, --no-creases and --background.
void addPictureOptions(CLI::App& command, PictureOptions& options);

/// The file of a texture that the model names.
std::string texturePath(const ModelInput& input, const std::string& texture);

/// How paper and lines shall look; reads the textures that the model names. A texture that cannot
/// be read is a warning, the paper has its plain colour then. Errors: BadValue - a background that
/// is no colour.
Result<Appearance> appearanceFor(Console& console, const ModelInput& input,
                                 const PictureOptions& options);

/// Errors of the options that can be told before any work is done.
Result<std::string> checkPictureOptions(const PictureOptions& options);

/// The scene as svg, pdf or png. Errors: those of the writers (a page that is too large).
Result<std::string> pictureBytes(const Scene& scene, const std::string& format, double dpi);

/// Writes the scene in the chosen format.
int writePicture(Console& console, Scene scene, const PictureOptions& options,
                 const std::string& format);

}  // namespace kiri::cli
