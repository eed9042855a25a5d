// Which models the gallery measures as leaves.
// SPDX-License-Identifier: MIT
#include "apps/cli/gallery_leaf.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <set>
#include <string>

#include "core/model/replay.h"
#include "io/file.h"
#include "io/kiri_reader.h"

namespace kiri::cli {
namespace {

TEST(GalleryLeaf, OfTheExamplesThePalmateLeavesAreMeasured) {
  std::set<std::string> measured;
  std::set<std::string> palmate;
  for (const auto& file : std::filesystem::directory_iterator(KIRI_SOURCE_DIR "/examples")) {
    if (file.path().extension() != ".kiri") continue;
    const std::string name = file.path().stem().string();
    // The hornbeam's leaf is pleated: its creases do not meet in the petiole.
    if (name.rfind("leaf_", 0) == 0 && name != "leaf_hornbeam") palmate.insert(name);
    const Result<std::string> text = readFile(file.path().string());
    ASSERT_TRUE(text);
    const Result<LoadedModel> loaded = readKiri(*text, name);
    ASSERT_TRUE(loaded) << loaded.error().message;
    const Result<Replay> replayed = replay(loaded->model);
    ASSERT_TRUE(replayed);
    const auto last = replayed->after(loaded->model.steps.size());
    ASSERT_TRUE(last) << name << ": " << last.error().message;
    // Whether it lies open does not decide here: the rest of the rule is enough.
    if (galleryLeafOf(loaded->model, **last, true)) measured.insert(name);
    EXPECT_FALSE(galleryLeafOf(loaded->model, **last, false)) << name;
  }
  EXPECT_EQ(measured, palmate);
}

}  // namespace
}  // namespace kiri::cli
