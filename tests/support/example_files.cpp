// Lists examples/ and reads what is there.
// SPDX-License-Identifier: MIT
#include "tests/support/example_files.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "io/file.h"
#include "io/kiri_reader.h"
#include "tests/support/sanitized.h"

namespace kiri::test {

std::vector<std::filesystem::path> exampleFiles() {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(KIRI_SOURCE_DIR "/examples")) {
    if (entry.path().extension() == ".kiri") files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

std::vector<std::filesystem::path> exampleFilesThatTakeLong() {
  const std::vector<std::filesystem::path> all = exampleFiles();
  std::vector<std::filesystem::path> some;
  for (std::size_t i = 0; i < all.size(); i += casesOf<std::size_t>(1, 5)) some.push_back(all[i]);
  return some;
}

Model modelInFile(const std::filesystem::path& file) {
  const Result<std::string> text = readFile(file.string());
  if (!text) throw std::runtime_error(text.error().message);
  Result<LoadedModel> loaded = readKiri(*text, file.filename().string());
  if (!loaded) throw std::runtime_error(loaded.error().message);
  if (!loaded->warnings.empty()) throw std::runtime_error(loaded->warnings.front());
  return std::move(loaded->model);
}

Model modelOfExample(const std::string& name) {
  return modelInFile(KIRI_SOURCE_DIR "/examples/" + name + ".kiri");
}

}  // namespace kiri::test
