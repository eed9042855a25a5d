// kiri gallery on the command line.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <filesystem>

#include "apps/cli/exit_codes.h"
#include "io/kiri_reader.h"
#include "tests/apps/cli/run_kiri.h"

namespace kiri::cli {
namespace {

namespace fs = std::filesystem;

constexpr const char* kFolded = R"({"format": "kiri", "version": 1, "title": "One & two",
  "notes": "a <fold>", "sheet": {"shape": "square", "side": 40}, "steps": [
  {"do": "fold", "title": "Fold in half", "line": {"paper": [[20, 0], [20, 40]]},
   "type": "valley", "move": "left"}]})";

class GalleryCommand : public KiriFolder {
 protected:
  void SetUp() override {
    KiriFolder::SetUp();
    fs::create_directories(path("models"));
  }
};

TEST_F(GalleryCommand, MakesAPageOfEachModelInAFolderAndOneOfAll) {
  put("models/half.kiri", kFolded);
  const Answer answer = runKiri({"gallery", path("models"), "-o", path("out"), "--no-animations"});
  ASSERT_EQ(answer.code, kDone) << answer.err;
  const std::string index = get("out/index.html");
  EXPECT_TRUE(contains(index, "One &amp; two"));
  EXPECT_TRUE(contains(index, "a &lt;fold&gt;"));
  EXPECT_TRUE(contains(index, "half/index.html"));
  const std::string page = get("out/half/index.html");
  EXPECT_TRUE(contains(page, "<li>Fold in half"));
  // What the pages show is there.
  for (const std::string name : {"finished.png", "folded.png", "half.png", "unfolded.png",
                                 "pattern.svg", "steps.svg", "half.kiri", "half.fold"}) {
    EXPECT_TRUE(contains(page, name)) << name;
    EXPECT_TRUE(fs::exists(path("out/half/" + name))) << name;
  }
  EXPECT_TRUE(readKiri(get("out/half/half.kiri"), "half.kiri"));
}

TEST_F(GalleryCommand, TwoModelsOfOneNameAreRefused) {
  const Answer answer = runKiri({"gallery", "a/x.kiri", "b/x.kiri", "-o", path("out")});
  EXPECT_EQ(answer.code, kBadUsage);
  EXPECT_TRUE(contains(answer.err, "two models are named x")) << answer.err;
}

TEST_F(GalleryCommand, CanBeStopped) {
  put("models/half.kiri", kFolded);
  EXPECT_EQ(runKiri({"gallery", path("models"), "-o", path("out")}, {"", false, 0}).code,
            kCancelled);
}

}  // namespace
}  // namespace kiri::cli
