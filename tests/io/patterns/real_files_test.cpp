// Files as people really have them: each is read, or refused with a sentence.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

#include "io/file.h"
#include "io/patterns/pattern_file.h"

namespace kiri {
namespace {

std::vector<std::filesystem::path> filesBelow(const std::string& folder) {
  std::vector<std::filesystem::path> out;
  const std::filesystem::path root = KIRI_SOURCE_DIR "/../shared/data/" + folder;
  if (!std::filesystem::is_directory(root)) return out;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(root)) {
    if (entry.is_regular_file()) out.push_back(entry.path());
  }
  std::sort(out.begin(), out.end());
  return out;
}

Result<PatternFile> readReal(const std::filesystem::path& path) {
  const Result<std::string> text = readFile(path.string());
  if (!text) return text.error();
  return readPattern(*text, path.filename().string());
}

/// With KIRI_SHOW_NOTES set, what is said of each file is shown.
void show(const std::filesystem::path& path, const Result<PatternFile>& file) {
  if (std::getenv("KIRI_SHOW_NOTES") == nullptr) return;
  const std::string name = path.parent_path().filename().string() + "/" + path.filename().string();
  if (!file) {
    std::printf("%s REFUSED %s\n", name.c_str(), file.error().message.c_str());
    return;
  }
  std::printf("%s %zu lines %zu faces %zu orders\n", name.c_str(), file->drawing.lines.size(),
              file->drawing.faces.size(), file->drawing.orders.size());
  for (const std::string& note : file->notes) std::printf("    %s\n", note.c_str());
}

TEST(RealFiles, EveryPatternIsRead) {
  const auto files = filesBelow("patterns");
  if (files.empty()) GTEST_SKIP() << "no files beside the checkout";
  int read = 0;
  for (const std::filesystem::path& path : files) {
    const auto format = patternFormatOf(path.string());
    if (!format) continue;
    const Result<PatternFile> file = readReal(path);
    show(path, file);
    const bool hasNoPlane = path.filename() == "no-faces.fold";  // a form in space without faces
    EXPECT_EQ(file.isOk(), !hasNoPlane) << path << (file.isOk() ? "" : file.error().message);
    if (file) {
      EXPECT_FALSE(file->drawing.lines.empty()) << path;
    }
    ++read;
  }
  EXPECT_GT(read, 400);
}

TEST(RealFiles, EveryFileOfAnyFormatIsReadOrRefusedWithASentence) {
  const auto files = filesBelow("formats");
  if (files.empty()) GTEST_SKIP() << "no files beside the checkout";
  for (const std::filesystem::path& path : files) {
    const Result<PatternFile> file = readReal(path);
    show(path, file);
    if (file) {
      EXPECT_FALSE(file->drawing.lines.empty()) << path;
    } else {
      EXPECT_EQ(file.error().message.rfind(path.filename().string(), 0), 0u)
          << file.error().message;
      EXPECT_EQ(file.error().code, ErrorCode::BadFile);
    }
  }
}

}  // namespace
}  // namespace kiri
