// Which models the gallery measures as leaves.
// SPDX-License-Identifier: MIT
#include "apps/cli/gallery_leaf.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <set>
#include <string>

#include "core/model/replay.h"
#include "tests/support/example_files.h"

namespace kiri::cli {
namespace {

TEST(GalleryLeaf, OfTheExamplesThePalmateLeavesAreMeasured) {
  std::set<std::string> measured;
  std::set<std::string> palmate;
  for (const std::filesystem::path& file : test::exampleFiles()) {
    const std::string name = file.stem().string();
    // The hornbeam's leaf is pleated: its creases do not meet in the petiole.
    if (name.rfind("leaf_", 0) == 0 && name != "leaf_hornbeam") palmate.insert(name);
    const Model model = test::modelInFile(file);
    const Result<Replay> replayed = replay(model);
    ASSERT_TRUE(replayed);
    const auto last = replayed->after(model.steps.size());
    ASSERT_TRUE(last) << name << ": " << last.error().message;
    // Whether it lies open does not decide here: the rest of the rule is enough.
    if (galleryLeafOf(model, **last, true)) measured.insert(name);
    EXPECT_FALSE(galleryLeafOf(model, **last, false)) << name;
  }
  EXPECT_EQ(measured, palmate);
}

}  // namespace
}  // namespace kiri::cli
