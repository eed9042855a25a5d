// Files with numbers in their names: f_0001.png, f_0002.png.
// SPDX-License-Identifier: MIT
#include "apps/cli/numbered_files.h"

#include <cctype>
#include <cstdio>
#include <utility>

#include "io/file.h"

namespace kiri::cli {

std::string NumberedPath::at(std::size_t number) const {
  std::string text = std::to_string(number);
  if (text.size() < digits) text.insert(0, digits - text.size(), '0');
  return before + text + after;
}

std::optional<NumberedPath> numberedPath(const std::string& path) {
  const std::size_t start = path.find('%');
  if (start == std::string::npos || path.find('%', start + 1) != std::string::npos) return {};
  std::size_t at = start + 1;
  while (at < path.size() && std::isdigit(static_cast<unsigned char>(path[at])) != 0) ++at;
  constexpr std::size_t kMostDigits = 2;  // of the count of digits
  if (at == path.size() || path[at] != 'd' || at - start - 1 > kMostDigits) return {};
  const std::string digits = path.substr(start + 1, at - start - 1);
  return NumberedPath{path.substr(0, start), digits.empty() ? 1 : std::stoul(digits),
                      path.substr(at + 1)};
}

NumberedFiles::NumberedFiles(NumberedPath path, std::size_t first)
    : path_(std::move(path)), next_(first) {}

NumberedFiles::~NumberedFiles() {
  for (const std::string& name : written_) std::remove(name.c_str());
}

Status NumberedFiles::add(const std::string& bytes) {
  const std::string name = path_.at(next_++);
  Status status = writeFile(name, bytes);
  if (status.isOk()) written_.push_back(name);
  return status;
}

}  // namespace kiri::cli
