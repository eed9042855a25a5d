// Where the model is looked at from, for the commands that show it in space.
// SPDX-License-Identifier: MIT
#include "apps/cli/view_options.h"

#include <locale>
#include <optional>
#include <sstream>

namespace kiri::cli {

namespace {

/// A number that is all of the text.
std::optional<double> numberOf(const std::string& text) {
  std::istringstream in(text);
  in.imbue(std::locale::classic());
  double value = 0;
  char rest = 0;
  if (!(in >> value) || in >> rest) return std::nullopt;
  return value;
}

std::string namesOf(const std::string& others) {
  return "front, back" + (others.empty() ? "" : ", " + others);
}

}  // namespace

void addViewOption(CLI::App& command, ViewOptions& options, const std::string& others) {
  command
      .add_option("--view", options.view,
                  namesOf(others) +
                      " or AZ,EL: degrees round the model (0: from the near edge, 90: from the "
                      "right) and up (90: from above, 0: level); default " +
                      options.view)
      ->type_name("VIEW");
}

void addViewOptions(CLI::App& command, ViewOptions& options, const std::string& others) {
  addViewOption(command, options, others);
  command
      .add_option("--perspective", options.perspective,
                  "field of view in degrees, up to 120; 0: parallel lines stay parallel (default)")
      ->type_name("DEG");
  command
      .add_option("--explode", options.explode,
                  "mm between the layers, lifted off each other to be read one by one")
      ->type_name("MM");
  command.add_option("--thickness", options.thickness, "mm that the paper seems to be thick")
      ->type_name("MM");
  command.add_flag("--shade", options.isShaded, "facets turned away look darker");
  command.add_flag("--shadow", options.hasShadow, "a soft shadow on the table below the model");
}

bool asksForSpace(const ViewOptions& options) {
  return options.perspective != 0 || options.explode != 0 || options.thickness != 0 ||
         options.isShaded || options.hasShadow;
}

Result<ViewSpec> viewSpecOf(const ViewOptions& options, const std::string& others) {
  ViewSpec spec = frontSpec();
  if (options.view == "back") {
    spec = backSpec();
  } else if (options.view != "front") {
    const std::size_t comma = options.view.find(',');
    const std::optional<double> azimuth = numberOf(options.view.substr(0, comma));
    const std::optional<double> elevation =
        comma == std::string::npos ? std::nullopt : numberOf(options.view.substr(comma + 1));
    if (!azimuth || !elevation) {
      return Error{ErrorCode::BadValue, "--view " + options.view + " is not known; it takes " +
                                            namesOf(others) + " or AZ,EL like 30,40"};
    }
    spec.azimuth = *azimuth;
    spec.elevation = *elevation;
  }
  spec.fieldOfView = options.perspective;
  spec.explode = options.explode;
  spec.thickness = options.thickness;
  spec.isShaded = options.isShaded;
  spec.hasShadow = options.hasShadow;
  const Status status = checkViewSpec(spec);
  if (!status) return status.error();
  return spec;
}

}  // namespace kiri::cli
