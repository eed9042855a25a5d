// Files with numbers in their names: f_0001.png, f_0002.png.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "core/base/result.h"

namespace kiri::cli {

/// A path with a place for a number, as in f_%04d.png.
struct NumberedPath {
  std::string before;
  std::size_t digits = 0;
  std::string after;

  std::string at(std::size_t number) const;
};

/// None where the path has not exactly one place for a number.
std::optional<NumberedPath> numberedPath(const std::string& path);

/// Writes files with the numbers that follow each other; those that were written go again unless
/// `keep` is called.
class NumberedFiles {
 public:
  explicit NumberedFiles(NumberedPath path, std::size_t first = 1);
  NumberedFiles(const NumberedFiles&) = delete;
  NumberedFiles& operator=(const NumberedFiles&) = delete;
  ~NumberedFiles();

  /// Errors: Unwritable.
  Status add(const std::string& bytes);
  void keep() { written_.clear(); }

 private:
  NumberedPath path_;
  std::size_t next_;
  std::vector<std::string> written_;
};

}  // namespace kiri::cli
