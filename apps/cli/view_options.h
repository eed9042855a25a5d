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
};

/// Declares --view. `others`: what else the command takes there, like "pattern"; may be empty.
void addViewOptions(CLI::App& command, ViewOptions& options, const std::string& others = "");

/// What the options ask for; `options.view` is not one of the `others`. Errors: BadValue - words
/// and numbers that mean nothing; the sentence names the option.
Result<ViewSpec> viewSpecOf(const ViewOptions& options, const std::string& others = "");

}  // namespace kiri::cli
