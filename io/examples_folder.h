// Where the examples are that come with the program.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace kiri {

/// The folder with the examples: KIRI_EXAMPLES in the environment, that of the source the program
/// was built from, `examples` in `programFolder` (where the running program's file is), or
/// ../share/kirisim/examples seen from there; the first that is a folder, empty when none is.
std::string examplesFolder(const std::string& programFolder);

}  // namespace kiri
