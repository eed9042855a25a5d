// The file that a command was given, and whether it is a model or a crease pattern.
// SPDX-License-Identifier: MIT
#include "apps/cli/input_text.h"

#include <algorithm>
#include <cctype>
#include <optional>

#include "io/file.h"
#include "io/patterns/pattern_file.h"

namespace kiri::cli {

namespace {

bool endsWith(const std::string& name, const std::string& ending) {
  return name.size() >= ending.size() &&
         std::equal(ending.rbegin(), ending.rend(), name.rbegin(), [](char a, char b) {
           return a == static_cast<char>(std::tolower(static_cast<unsigned char>(b)));
         });
}

/// A JSON text that says of itself that it is a .kiri model.
bool saysKiri(const std::string& text) {
  constexpr std::size_t kHead = 4096;
  const std::string head = text.substr(0, kHead);
  const std::size_t key = head.find("\"format\"");
  return key != std::string::npos && head.find("\"kiri\"", key) != std::string::npos;
}

}  // namespace

Result<InputText> readInput(Console& console, const std::string& path) {
  const bool isStream = path == "-";
  InputText input;
  input.name = isStream ? "standard input" : path;
  input.fileName = isStream ? "" : path;
  const std::size_t slash = path.rfind('/');
  input.folder = isStream || slash == std::string::npos ? "" : path.substr(0, slash + 1);
  Result<std::string> text = isStream ? readStream(console.in, input.name) : readFile(path);
  if (!text.isOk()) return text.error();
  input.text = std::move(*text);
  return input;
}

bool isPattern(const InputText& input) {
  if (endsWith(input.fileName, ".kiri")) return false;
  if (patternFormatOf(input.fileName)) return true;
  return !saysKiri(input.text) && sniffedFormat(input.text).has_value();
}

std::string bareName(const InputText& input) {
  const std::string name =
      input.fileName.substr(std::min(input.folder.size(), input.fileName.size()));
  const std::size_t dot = name.rfind('.');
  return dot == std::string::npos || dot == 0 ? name : name.substr(0, dot);
}

}  // namespace kiri::cli
