// What the commands that make pictures have in common.
// SPDX-License-Identifier: MIT
#include "apps/cli/picture_options.h"

#include <memory>
#include <optional>
#include <utility>

#include "apps/cli/output_format.h"
#include "io/file.h"
#include "io/sheet_json.h"
#include "render/canvas/png.h"
#include "render/canvas/write.h"

namespace kiri::cli {

namespace {

Result<std::optional<Color>> backgroundOf(const PictureOptions& options) {
  if (options.background.empty() || options.background == "none") return std::optional<Color>{};
  const std::optional<Color> color = colorFromText(options.background);
  if (!color) {
    return Error{ErrorCode::BadValue, "--background " + options.background +
                                          " is no colour; write one like \"#ffffff\", or none"};
  }
  return color;
}

std::shared_ptr<const Image> textureOf(Console& console, const ModelInput& input,
                                       const std::string& texture) {
  if (texture.empty()) return nullptr;
  const std::string path = texturePath(input, texture);
  const Result<std::string> bytes = readFile(path);
  if (!bytes.isOk()) {
    warn(console, input.name + ": paper: the texture is left out: " + bytes.error().message);
    return nullptr;
  }
  Result<Image> image = decodePng(*bytes);
  if (!image.isOk()) {
    warn(console,
         input.name + ": paper: the texture " + path + " is left out: " + image.error().message);
    return nullptr;
  }
  return std::make_shared<const Image>(std::move(*image));
}

}  // namespace

std::string texturePath(const ModelInput& input, const std::string& texture) {
  return texture.front() == '/' ? texture : input.folder + texture;
}

void addPictureOptions(CLI::App& command, PictureOptions& options) {
  command.add_option("-o,--output", options.out, "file to write, - for standard output")
      ->type_name("OUT")
      ->required();
  command.add_option("--format", options.format, "svg, png or pdf (default: by the ending of OUT)")
      ->type_name("FORMAT");
  command.add_option("--dpi", options.dpi, "pixels per inch of a PNG (default 200)")
      ->type_name("N");
  command
      .add_option("--style", options.style,
                  "thesis: mountain blue, valley red; diagram: black dashes")
      ->type_name("STYLE");
  command.add_flag("--no-creases", options.hidesCreases, "leave out creases that lie flat");
  command.add_option("--background", options.background, "colour like \"#ffffff\" (default: none)")
      ->type_name("COLOUR");
}

Result<std::string> checkPictureOptions(const PictureOptions& options) {
  constexpr double kLowest = 1;
  constexpr double kHighest = 10000;
  if (!(options.dpi >= kLowest && options.dpi <= kHighest)) {
    return Error{ErrorCode::BadValue, "--dpi must lie between 1 and 10000"};
  }
  if (options.style != "thesis" && options.style != "diagram") {
    return Error{ErrorCode::BadValue,
                 "--style " + options.style + " is not known; it takes thesis or diagram"};
  }
  const Result<std::optional<Color>> background = backgroundOf(options);
  if (!background.isOk()) return background.error();
  return chooseFormat(options.out, options.format, {"svg", "png", "pdf"});
}

Result<Appearance> appearanceFor(Console& console, const ModelInput& input,
                                 const PictureOptions& options) {
  Appearance appearance = appearanceOf(input.model);
  appearance.front.texture = textureOf(console, input, input.model.front.texture);
  appearance.back.texture = textureOf(console, input, input.model.back.texture);
  appearance.lineStyle = options.style == "diagram" ? LineStyle::Diagram : LineStyle::Thesis;
  appearance.showCreases = !options.hidesCreases;
  return appearance;
}

Result<std::string> pictureBytes(const Scene& scene, const std::string& format, double dpi) {
  if (format == "svg") return writeSvg(scene);
  if (format == "pdf") return writePdf(scene);
  return writePng(scene, {dpi});
}

int writePicture(Console& console, Scene scene, const PictureOptions& options,
                 const std::string& format) {
  const Result<std::optional<Color>> background = backgroundOf(options);
  if (background.isOk() && *background) scene.background = **background;
  if (isCancelled(console)) return fail(console, Error{ErrorCode::Cancelled, "", {}});
  const Result<std::string> bytes = pictureBytes(scene, format, options.dpi);
  if (!bytes.isOk()) return fail(console, bytes.error(), kBadUsage);
  return writeResult(console, options.out, *bytes);
}

}  // namespace kiri::cli
