// kiri leaf on the command line.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <sstream>

#include "apps/cli/run.h"
#include "io/kiri_reader.h"

namespace kiri::cli {
namespace {

constexpr const char* kMaple = R"({"format": "kiri leaf", "title": "Maple",
  "antiVeins": [{"angle": 24, "length": 0.6}], "veins": [{"angle": 42, "length": 0.9}],
  "base": {"angle": 118, "length": 0.3}})";

struct LeafRun {
  int code = 0;
  std::string out;
  std::string err;
};

LeafRun leafRun(const std::string& recipe, const std::vector<std::string>& arguments) {
  std::istringstream in(recipe);
  std::ostringstream out;
  std::ostringstream err;
  Console console{in, out, err, false, {}};
  LeafRun done;
  done.code = run(arguments, console);
  done.out = out.str();
  done.err = err.str();
  return done;
}

TEST(LeafCommand, WritesAModelThatReadsBack) {
  const LeafRun done = leafRun(kMaple, {"leaf", "-", "-o", "-"});
  ASSERT_EQ(done.code, kDone) << done.err;
  const Result<LoadedModel> loaded = readKiri(done.out, "out");
  ASSERT_TRUE(loaded) << loaded.error().message;
  EXPECT_EQ(loaded->model.title, "Maple");
  EXPECT_EQ(loaded->model.steps.size(), 3u + 4u + 3u);
}

TEST(LeafCommand, ListsTheRaysBesideTheKirigamiLaw) {
  const LeafRun done = leafRun(kMaple, {"leaf", "-"});
  ASSERT_EQ(done.code, kDone) << done.err;
  EXPECT_NE(done.out.find("first anti-vein          24.0     24.0    0.600"), std::string::npos)
      << done.out;
}

TEST(LeafCommand, ARecipeThatCannotWorkGetsASentence) {
  std::string text = kMaple;
  text.replace(text.find("42"), 2, "60");
  const LeafRun done = leafRun(text, {"leaf", "-"});
  EXPECT_EQ(done.code, kBadModel);
  EXPECT_NE(done.err.find("past the mid-vein"), std::string::npos) << done.err;
}

}  // namespace
}  // namespace kiri::cli
