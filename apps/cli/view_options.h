// Where the model is looked at from, for the commands that show it in space.
// SPDX-License-Identifier: MIT
#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "core/base/result.h"
#include "render/scene/view_spec.h"

namespace kiri::cli {

struct ViewOptions {
  std::string view = "front";
  double perspective = 0;
  double explode = 0;
  double thickness = 0;
  bool isShaded = false;
  bool hasShadow = false;
};

/// Declares --view alone. `others`: what else the command takes there, like "pattern"; may be
/// empty.
void addViewOption(CLI::App& command, ViewOptions& options, const std::string& others = "");
/// Declares --view and all that helps to read folds in space.
void addViewOptions(CLI::App& command, ViewOptions& options, const std::string& others = "");

/// True when one of the options other than --view is set.
bool asksForSpace(const ViewOptions& options);

/// What the options ask for; `options.view` is not one of the `others`. Errors: BadValue - words
/// and numbers that mean nothing; the sentence names the option.
Result<ViewSpec> viewSpecOf(const ViewOptions& options, const std::string& others = "");

}  // namespace kiri::cli
