// The command line program, but for the process around it.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "apps/cli/console.h"

namespace kiri::cli {

/// Does what the arguments (without the program's name) say and returns the exit code. Defects of
/// the program are reported as such, with exit code kDefect; no exception leaves.
int run(const std::vector<std::string>& arguments, Console& console);

}  // namespace kiri::cli
