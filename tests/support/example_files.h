// The models of examples/ as files.
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/model/model.h"

namespace kiri::test {

/// All .kiri files of examples/, sorted.
std::vector<std::filesystem::path> exampleFiles();

/// The same; in the build with sanitizers every fifth only. For tests that take long for each.
std::vector<std::filesystem::path> exampleFilesThatTakeLong();

/// The model in a file. Throws std::runtime_error with the reader's sentence when there is none,
/// or when the reader warns: nothing in examples/ is out of date.
Model modelInFile(const std::filesystem::path& file);

/// The same for a model of examples/, named without its ending.
Model modelOfExample(const std::string& name);

}  // namespace kiri::test
