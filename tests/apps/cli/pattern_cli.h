// kiri run on crease patterns in a folder of its own, for tests.
// SPDX-License-Identifier: MIT
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

namespace kiri::cli {

struct PatternAnswer {
  int code = 0;
  std::string out;
  std::string err;
};

/// What is around a run of the program.
struct PatternSetting {
  std::string input;
  bool showsProgress = false;
  int patience = 1000000000;  ///< is stopped after it asked so often
};

PatternAnswer runKiri(const std::vector<std::string>& arguments,
                      const PatternSetting& setting = {});

bool contains(const std::string& text, const std::string& part);

/// A sheet of 60 x 60 divided into three by two by creases of one letter: a map.
std::string mapAsFold(const std::string& letter);
/// A square of 100 with four creases that meet in its middle, one turned by some degrees: .cp, y
/// down. Three mountains and a valley; at 0 degrees it folds flat.
std::string starAsCp(double degrees);

class PatternCli : public ::testing::Test {
 protected:
  void SetUp() override;
  void TearDown() override;

  std::string path(const std::string& name) const { return (folder_ / name).string(); }
  std::string put(const std::string& name, const std::string& text) const;
  std::string get(const std::string& name) const;
  std::size_t fileCount() const;

 private:
  std::filesystem::path folder_;
};

}  // namespace kiri::cli
