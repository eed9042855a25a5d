// Where the examples are that come with the program.
// SPDX-License-Identifier: MIT
#include "io/examples_folder.h"

#include <cstdlib>
#include <filesystem>
#include <system_error>
#include <vector>

namespace kiri {

std::string examplesFolder(const std::string& programFolder) {
  namespace fs = std::filesystem;
  std::vector<fs::path> places;
  if (const char* wanted = std::getenv("KIRI_EXAMPLES"); wanted != nullptr) {
    places.emplace_back(wanted);
  }
#ifdef KIRI_EXAMPLES_DIR
  places.emplace_back(KIRI_EXAMPLES_DIR);
#endif
  if (!programFolder.empty()) {
    const fs::path program(programFolder);
    places.push_back(program / "examples");
    places.push_back(program / ".." / "share" / "kirisim" / "examples");
  }
  for (const fs::path& place : places) {
    std::error_code error;
    if (!place.empty() && fs::is_directory(place, error)) {
      const fs::path whole = fs::absolute(place, error);
      return (error ? place : whole).lexically_normal().string();
    }
  }
  return "";
}

}  // namespace kiri
