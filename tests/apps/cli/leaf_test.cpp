// kiri leaf on the command line.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "apps/cli/exit_codes.h"
#include "io/kiri_reader.h"
#include "tests/apps/cli/run_kiri.h"

namespace kiri::cli {
namespace {

constexpr const char* kMaple = R"({"format": "kiri leaf", "title": "Maple",
  "antiVeins": [{"angle": 24, "length": 0.6}], "veins": [{"angle": 42, "length": 0.9}],
  "base": {"angle": 118, "length": 0.3}})";

TEST(LeafCommand, WritesAModelThatReadsBack) {
  const Answer done = runKiri({"leaf", "-", "-o", "-"}, {kMaple});
  ASSERT_EQ(done.code, kDone) << done.err;
  const Result<LoadedModel> loaded = readKiri(done.out, "out");
  ASSERT_TRUE(loaded) << loaded.error().message;
  EXPECT_EQ(loaded->model.title, "Maple");
  EXPECT_EQ(loaded->model.steps.size(), 3u + 4u + 3u);
}

TEST(LeafCommand, ListsTheRaysBesideTheKirigamiLaw) {
  const Answer done = runKiri({"leaf", "-"}, {kMaple});
  ASSERT_EQ(done.code, kDone) << done.err;
  EXPECT_NE(done.out.find("first anti-vein          24.0     24.0    0.600"), std::string::npos)
      << done.out;
}

TEST(LeafCommand, ARecipeThatCannotWorkGetsASentence) {
  std::string text = kMaple;
  text.replace(text.find("42"), 2, "60");
  const Answer done = runKiri({"leaf", "-"}, {text});
  EXPECT_EQ(done.code, kBadModel);
  EXPECT_NE(done.err.find("past the mid-vein"), std::string::npos) << done.err;
}

}  // namespace
}  // namespace kiri::cli
