// kiri run inside a test, with what is around it, and a folder of its own.
// SPDX-License-Identifier: MIT
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

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

/// A folder of its own for each test, which goes with it.
class KiriFolder : public ::testing::Test {
 protected:
  void SetUp() override;
  void TearDown() override;

  std::string path(const std::string& name) const { return (folder_ / name).string(); }
  /// Writes a file and gives its path.
  std::string put(const std::string& name, const std::string& text) const;
  std::string get(const std::string& name) const;
  std::size_t fileCount() const;

 private:
  std::filesystem::path folder_;
};

}  // namespace kiri::cli
