// kiri run inside a test, with what is around it, and a folder of its own.
// SPDX-License-Identifier: MIT
#include "tests/apps/cli/run_kiri.h"

#include <sstream>

#include "apps/cli/run.h"

namespace kiri::cli {

Answer runKiri(const std::vector<std::string>& arguments, const Setting& setting) {
  std::istringstream in(setting.input);
  std::ostringstream out;
  std::ostringstream err;
  int asked = 0;
  Console console{in, out, err, setting.showsProgress, [&] { return ++asked > setting.patience; }};
  Answer answer;
  answer.code = run(arguments, console);
  answer.out = out.str();
  answer.err = err.str();
  return answer;
}

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

}  // namespace kiri::cli
