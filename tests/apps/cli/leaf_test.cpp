// kiri leaf on the command line.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <filesystem>

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

TEST(LeafCommand, ListsTheCreasesAsToldAsMeasuredAndByTheKirigamiLaw) {
  const Answer done = runKiri({"leaf", "-"}, {kMaple});
  ASSERT_EQ(done.code, kDone) << done.err;
  EXPECT_NE(
      done.out.find("first anti-vein    24.00    24.00    0.600    24.00    0.600    0.610\n"),
      std::string::npos)
      << done.out;
  EXPECT_NE(
      done.out.find("basal edge         82.00   118.00    0.300        -        -    0.508\n"),
      std::string::npos)
      << done.out;
  EXPECT_NE(done.out.find("Lobes: 3, sinuses: 2."), std::string::npos) << done.out;
}

TEST(LeafCommand, ItsHelpNamesARecipeThatIsThere) {
  const Answer done = runKiri({"leaf", "--help"});
  const std::size_t at = done.out.find("examples/leaves/");
  ASSERT_NE(at, std::string::npos) << done.out;
  const std::string path = done.out.substr(at, done.out.find(' ', at) - at);
  EXPECT_TRUE(std::filesystem::exists(KIRI_SOURCE_DIR "/" + path)) << path;
}

TEST(LeafCommand, ALeafThatNoMarginCutsIsListedAsItLiesFolded) {
  std::string text = kMaple;
  text.replace(text.find("0.3"), 3, "0.7");
  const Answer listed = runKiri({"leaf", "-"}, {text});
  EXPECT_EQ(listed.code, kBadModel);
  EXPECT_NE(listed.err.find("no single margin"), std::string::npos) << listed.err;
  EXPECT_NE(listed.out.find("mid-vein            0.00    1.000\n"
                            "second vein         6.00    0.900\n"
                            "basal edge         82.00    0.700\n"
                            "first anti-vein    24.00    0.600\n"),
            std::string::npos)
      << listed.out;
  const Answer written = runKiri({"leaf", "-", "-o", "-"}, {text});
  EXPECT_EQ(written.code, kBadModel);
  EXPECT_EQ(written.out, "") << "a model or nothing";
}

TEST(LeafCommand, WritesNoModelUnderTheNameOfAPicture) {
  const Answer done = runKiri({"leaf", "-", "-o", "maple.png"}, {kMaple});
  EXPECT_EQ(done.code, kBadUsage);
  EXPECT_NE(done.err.find("kiri render makes pictures"), std::string::npos) << done.err;
  EXPECT_FALSE(std::filesystem::exists("maple.png"));
}

TEST(LeafCommand, LengthsInMillimetresAreToldFromPartsOfTheMidVein) {
  std::string text = kMaple;
  text.replace(text.find("0.9"), 3, "90");
  const Answer done = runKiri({"leaf", "-"}, {text});
  EXPECT_EQ(done.code, kBadModel);
  EXPECT_NE(done.err.find("lengths are parts of the mid-vein's"), std::string::npos) << done.err;
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
