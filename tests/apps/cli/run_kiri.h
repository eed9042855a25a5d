// kiri run inside a test, with what is around it, and a folder of its own.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "tests/support/scratch_folder.h"

namespace kiri::cli {

struct Answer {
  int code = 0;
  std::string out;
  std::string err;
};

/// What is around a run of the program.
struct Setting {
  std::string input;
  bool showsProgress = false;
  int patience = 1000000000;  ///< is stopped after it asked so often
};

Answer runKiri(const std::vector<std::string>& arguments, const Setting& setting = {});

bool contains(const std::string& text, const std::string& part);

using KiriFolder = test::ScratchFolder;

}  // namespace kiri::cli
