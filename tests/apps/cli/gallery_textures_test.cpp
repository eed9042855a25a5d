// What a model of the gallery needs beside it comes with it.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "apps/cli/exit_codes.h"
#include "io/file.h"
#include "tests/apps/cli/run_kiri.h"

namespace kiri::cli {
namespace {

using GalleryTextures = KiriFolder;

TEST_F(GalleryTextures, AreDownloadedWithTheModelThatNamesThem) {
  const std::string examples = KIRI_SOURCE_DIR "/examples/";
  const Answer made =
      runKiri({"gallery", examples + "origami_frog.kiri", "-o", path("out"), "--no-animations"});
  ASSERT_EQ(made.code, kDone) << made.err;
  EXPECT_EQ(get("out/origami_frog/frog.png"), *readFile(examples + "frog.png"));
  EXPECT_TRUE(contains(get("out/origami_frog/index.html"), "\"frog.png\""));
  const Answer seen =
      runKiri({"render", path("out/origami_frog/origami_frog.kiri"), "-o", path("frog.png")});
  EXPECT_EQ(seen.code, kDone);
  EXPECT_EQ(seen.err, "");
}

}  // namespace
}  // namespace kiri::cli
