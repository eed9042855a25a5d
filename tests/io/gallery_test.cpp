// Galleries are read with every mistake told, and that of the examples shows all of them.
// SPDX-License-Identifier: MIT
#include "io/gallery.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "io/examples_folder.h"
#include "io/file.h"

namespace kiri {
namespace {

namespace fs = std::filesystem;

std::string galleryText(const std::string& groups) {
  return R"({"format": "kiri gallery", "version": 1, "title": "Mine", "groups": )" + groups + "}";
}

/// The sentence of the mistake in a gallery; empty when there is none.
std::string galleryMistake(const std::string& text) {
  const Result<Gallery> gallery = readGallery(text, "mine.json");
  return gallery ? "" : gallery.error().message;
}

TEST(GalleryReader, ReadsGroupsInTheirOrder) {
  const Result<Gallery> gallery =
      readGallery(galleryText(R"([{"title": "B", "notes": "Two.", "models": ["z.kiri", "a.kiri"]},
                      {"title": "Empty", "models": []},
                      {"title": "A", "models": ["m.kiri"]}])"),
                  "mine.json");
  ASSERT_TRUE(gallery) << gallery.error().message;
  EXPECT_EQ(gallery->title, "Mine");
  ASSERT_EQ(gallery->groups.size(), 2U);
  EXPECT_EQ(gallery->groups[0].title, "B");
  EXPECT_EQ(gallery->groups[0].notes, "Two.");
  EXPECT_EQ(gallery->groups[0].models, (std::vector<std::string>{"z.kiri", "a.kiri"}));
  EXPECT_EQ(gallery->groups[1].title, "A");
  EXPECT_TRUE(gallery->warnings.empty());
}

TEST(GalleryReader, EveryMistakeIsToldWithItsPlaceAndRemedy) {
  const struct {
    std::string text;
    std::vector<std::string> said;
  } cases[] = {
      {"[]", {"kiri gallery"}},
      {"{\n\"format\": \"kiri\", \"version\": 1}", {"mine.json:2:11", "\"kiri gallery\"", "other"}},
      {R"({"format": "kiri gallery", "version": 2})", {"version", "newer program"}},
      {R"({"format": "kiri gallery", "version": 1})", {"\"groups\" is missing"}},
      {galleryText("{}"), {"a list of groups"}},
      {galleryText(R"([{"models": []}])"), {"groups[0].title", "missing"}},
      {galleryText(R"([{"title": "A"}])"), {"groups[0].models", "missing"}},
      {galleryText(R"([{"title": "A", "models": "x.kiri"}])"), {"a list of names"}},
      {galleryText(R"([{"title": "A", "models": [7]}])"), {"models[0]", "but is 7"}},
      {galleryText(R"([{"title": "A", "models": ["x.fold"]}])"), {"x.fold", ".kiri"}},
      {galleryText(R"([{"title": "A", "models": [".kiri"]}])"), {"the name of a .kiri file"}},
      {galleryText(R"([{"title": "A", "models": ["in/x.kiri"]}])"),
       {"in/x.kiri", "without a path"}},
      {galleryText(R"([{"title": "A", "models": ["in\\x.kiri"]}])"), {"without a path"}},
      {galleryText(R"([{"title": "A", "models": ["x.kiri"]}, {"title": "B",
                        "models": ["y.kiri", "x.kiri"]}])"),
       {"groups[1].models[1]", "\"A\" already"}},
  };
  for (const auto& [text, said] : cases) {
    const std::string sentence = galleryMistake(text);
    EXPECT_EQ(sentence.rfind("mine.json:", 0), 0U) << text << "\n" << sentence;
    for (const std::string& part : said) {
      EXPECT_NE(sentence.find(part), std::string::npos) << text << "\n" << sentence;
    }
  }
}

TEST(GalleryReader, WarnsOfATypingError) {
  const Result<Gallery> gallery = readGallery(
      galleryText(R"([{"title": "A", "note": "x", "models": ["x.kiri"]}])"), "mine.json");
  ASSERT_TRUE(gallery) << gallery.error().message;
  ASSERT_EQ(gallery->warnings.size(), 1U);
  EXPECT_NE(gallery->warnings[0].find("\"notes\""), std::string::npos) << gallery->warnings[0];
}

TEST(GalleryOfTheExamples, ShowsEachExampleOnceAndNothingElse) {
  const fs::path folder = KIRI_SOURCE_DIR "/examples";
  const std::string path = (folder / kGalleryFile).string();
  const Result<std::string> text = readFile(path);
  ASSERT_TRUE(text) << text.error().message;
  const Result<Gallery> gallery = readGallery(*text, path);
  ASSERT_TRUE(gallery) << gallery.error().message;
  EXPECT_TRUE(gallery->warnings.empty());
  std::vector<std::string> shown;
  for (const GalleryGroup& group : gallery->groups) {
    EXPECT_FALSE(group.notes.empty()) << group.title;
    shown.insert(shown.end(), group.models.begin(), group.models.end());
  }
  std::vector<std::string> there;
  for (const fs::directory_entry& file : fs::directory_iterator(folder)) {
    if (file.path().extension() == ".kiri") there.push_back(file.path().filename().string());
  }
  std::sort(shown.begin(), shown.end());
  std::sort(there.begin(), there.end());
  // The reader has refused what stands there twice.
  EXPECT_EQ(shown, there);
}

TEST(ExamplesFolder, IsWhereTheEnvironmentSaysElseThatOfTheSource) {
  const fs::path own = fs::path(testing::TempDir()) / "kiri_examples_here";
  fs::create_directories(own);
  ASSERT_EQ(::setenv("KIRI_EXAMPLES", own.c_str(), 1), 0);
  EXPECT_EQ(fs::path(examplesFolder("")), own.lexically_normal());
  fs::remove_all(own);
  // What is not there is passed over.
  EXPECT_TRUE(fs::equivalent(examplesFolder(""), KIRI_SOURCE_DIR "/examples"));
  ASSERT_EQ(::unsetenv("KIRI_EXAMPLES"), 0);
  EXPECT_TRUE(fs::equivalent(examplesFolder("/nowhere"), KIRI_SOURCE_DIR "/examples"));
}

}  // namespace
}  // namespace kiri
