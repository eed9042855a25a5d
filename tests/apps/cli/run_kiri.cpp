// kiri run inside a test, with what is around it, and a folder of its own.
// SPDX-License-Identifier: MIT
#include "tests/apps/cli/run_kiri.h"

#include <unistd.h>

#include <fstream>
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

void KiriFolder::SetUp() {
  std::string pattern = (std::filesystem::temp_directory_path() / "kiri-test-XXXXXX").string();
  ASSERT_NE(::mkdtemp(pattern.data()), nullptr);
  folder_ = pattern;
}

void KiriFolder::TearDown() { std::filesystem::remove_all(folder_); }

std::string KiriFolder::put(const std::string& name, const std::string& text) const {
  std::ofstream(folder_ / name) << text;
  return path(name);
}

std::string KiriFolder::get(const std::string& name) const {
  std::ifstream in(folder_ / name, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

std::size_t KiriFolder::fileCount() const {
  std::size_t count = 0;
  for ([[maybe_unused]] const auto& entry : std::filesystem::directory_iterator(folder_)) ++count;
  return count;
}

}  // namespace kiri::cli
