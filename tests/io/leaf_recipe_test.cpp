// Recipes are read with every mistake told, and those in the repository make leaves.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <filesystem>

#include "core/leaf/leaf_model.h"
#include "core/model/replay.h"
#include "io/file.h"
#include "io/leaf_recipe_reader.h"

namespace kiri {
namespace {

constexpr const char* kRecipe = R"({"format": "kiri leaf", "title": "Maple", "midVein": 80,
  "antiVeins": [{"angle": 24, "length": 0.6}], "veins": [{"angle": 42, "length": 0.9}],
  "base": {"angle": 118, "length": 0.3}, "margin": [{"angle": 10, "length": 0.8}],
  "collector": {"name": "N. N."}})";

TEST(LeafRecipeReader, ReadsEveryFieldAndWarnsOfTheRest) {
  const Result<LoadedRecipe> loaded = readLeafRecipe(kRecipe, "maple.json");
  ASSERT_TRUE(loaded) << loaded.error().message;
  const LeafRecipe& recipe = loaded->recipe;
  EXPECT_EQ(recipe.title, "Maple");
  EXPECT_EQ(recipe.midVein, 80);
  EXPECT_EQ(recipe.petiole, Petiole::Inside);
  EXPECT_EQ(recipe.antiVeins, (std::vector<LeafRay>{{24, 0.6}}));
  EXPECT_EQ(recipe.veins, (std::vector<LeafRay>{{42, 0.9}}));
  EXPECT_EQ(recipe.base, (LeafRay{118, 0.3}));
  EXPECT_EQ(recipe.margin, (std::vector<LeafRay>{{10, 0.8}}));
  ASSERT_EQ(loaded->warnings.size(), 1u);
  EXPECT_NE(loaded->warnings[0].find("maple.json:4:"), std::string::npos) << loaded->warnings[0];
  EXPECT_NE(loaded->warnings[0].find("\"collector\" is not a field that is known here; it does "
                                     "nothing"),
            std::string::npos)
      << loaded->warnings[0];
}

TEST(LeafRecipeReader, MistakesAreToldWithTheirPlace) {
  std::string text = kRecipe;
  text.replace(text.find("42"), 2, "\"wide\"");
  const Result<LoadedRecipe> loaded = readLeafRecipe(text, "maple.json");
  ASSERT_FALSE(loaded);
  EXPECT_NE(loaded.error().message.find("maple.json:2:"), std::string::npos)
      << loaded.error().message;
  EXPECT_NE(loaded.error().message.find("veins[0].angle"), std::string::npos);
  EXPECT_FALSE(readLeafRecipe("[]", "x"));
  EXPECT_FALSE(readLeafRecipe(R"({"format": "kiri"})", "x"));
}

std::string withSecondary(const std::string& secondary) {
  std::string text = kRecipe;
  return text.replace(text.find("\"collector\""), std::string::npos,
                      "\"secondary\": " + secondary + "}");
}

TEST(LeafRecipeReader, SecondaryLobesAreOnePairOrAListOfPairs) {
  const std::string pair =
      R"("at": 0.5, "antiVein": {"angle": 20, "length": 0.3}, "vein": {"angle": 30, "length": 0.4})";
  const SecondaryLobes wanted{0, 0.5, {20, 0.3}, {30, 0.4}, false};
  const Result<LoadedRecipe> one = readLeafRecipe(withSecondary("{" + pair + "}"), "x");
  ASSERT_TRUE(one) << one.error().message;
  EXPECT_EQ(one->recipe.secondary, std::vector<SecondaryLobes>{wanted});
  const Result<LoadedRecipe> two =
      readLeafRecipe(withSecondary("[{" + pair + "}, {\"lobe\": 1, " + pair + "}]"), "x");
  ASSERT_TRUE(two) << two.error().message;
  SecondaryLobes lateral = wanted;
  lateral.lobe = 1;
  EXPECT_EQ(two->recipe.secondary, (std::vector<SecondaryLobes>{wanted, lateral}));
  EXPECT_FALSE(readLeafRecipe(withSecondary("{\"lobe\": 0.5, " + pair + "}"), "x"));
  EXPECT_FALSE(readLeafRecipe(withSecondary("{\"lobe\": -1, " + pair + "}"), "x"));
}

TEST(LeafRecipeReader, ASecondaryLobeWithoutItsPairIsRefusedWithTheReason) {
  const Result<LoadedRecipe> loaded = readLeafRecipe(
      withSecondary(R"({"side": "left", "at": 0.5, "antiVein": {"angle": 20, "length": 0.3},
                        "vein": {"angle": 30, "length": 0.4}})"),
      "maple.json");
  ASSERT_FALSE(loaded);
  EXPECT_NE(loaded.error().message.find("only mirror images fold flat while the vein is straight"),
            std::string::npos)
      << loaded.error().message;
}

TEST(LeafRecipes, OfTheRepositoryMakeLeavesWithoutACollision) {
  int count = 0;
  const std::filesystem::path folder = KIRI_SOURCE_DIR "/examples/leaves";
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    SCOPED_TRACE(entry.path().filename().string());
    const Result<std::string> text = readFile(entry.path().string());
    ASSERT_TRUE(text);
    const Result<LoadedRecipe> loaded = readLeafRecipe(*text, "recipe");
    ASSERT_TRUE(loaded) << loaded.error().message;
    EXPECT_TRUE(loaded->warnings.empty());
    const Result<LeafModel> leaf = leafModelOf(loaded->recipe);
    ASSERT_TRUE(leaf) << leaf.error().message;
    const Result<Replay> replayed = replay(leaf->model);
    ASSERT_TRUE(replayed);
    const auto last = replayed->after(leaf->model.steps.size());
    ASSERT_TRUE(last) << last.error().message;
    EXPECT_TRUE((*last)->collisions.empty());
    ++count;
  }
  EXPECT_GE(count, 10);
}

}  // namespace
}  // namespace kiri
