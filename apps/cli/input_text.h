// The file that a command was given, and whether it is a model or a crease pattern.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "apps/cli/console.h"
#include "core/base/result.h"

namespace kiri::cli {

struct InputText {
  std::string name;      ///< for sentences: the path, or "standard input"
  std::string fileName;  ///< whose ending says what it is; empty for standard input
  std::string folder;    ///< textures are found relative to it
  std::string text;
};

/// Reads a file, or standard input for "-". Errors: BadFile.
Result<InputText> readInput(Console& console, const std::string& path);

/// True when the input is a crease pattern in one of the formats of io/patterns, by its ending or,
/// where that says nothing, by what it looks like. Else it is read as a .kiri model.
bool isPattern(const InputText& input);

/// The name of a file without folder and ending; empty for standard input.
std::string bareName(const InputText& input);

}  // namespace kiri::cli
