// The gallery of examples, and the sheets of the start page.
// SPDX-License-Identifier: MIT
#include "editor/document/gallery.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <set>

#include "editor/document/document.h"
#include "editor/document/new_sheet.h"
#include "io/kiri_reader.h"
#include "io/kiri_writer.h"
#include "tests/support/expect.h"
#include "tests/support/model_text.h"

namespace kiri::test {
namespace {

namespace fs = std::filesystem;

/// A folder that goes with the test.
class GalleryFolder : public ::testing::Test {
 protected:
  void SetUp() override {
    folder = (fs::temp_directory_path() / "kiri-gallery-XXXXXX").string();
    ASSERT_NE(::mkdtemp(folder.data()), nullptr);
  }
  void TearDown() override { fs::remove_all(folder); }
  void put(const std::string& name, const std::string& text) {
    std::ofstream(folder + "/" + name) << text;
  }

  std::string folder;
};

TEST(Gallery, OfTheExamplesHoldsEachOnceInGroupsAndEachHasItsPicture) {
  const std::string folder = KIRI_SOURCE_DIR "/examples";
  const Gallery gallery = galleryIn(folder);
  EXPECT_TRUE(gallery.warnings.empty());
  ASSERT_GE(gallery.groups.size(), 4u);
  std::set<std::string> seen;
  for (const GalleryGroup& group : gallery.groups) {
    EXPECT_FALSE(group.title.empty()) << group.models.front() << " stands in no group";
    for (const std::string& name : group.models) {
      SCOPED_TRACE(name);
      EXPECT_TRUE(seen.insert(name).second);
      const ModelWords words = wordsOf(folder + "/" + name).value();
      EXPECT_GT(words.steps, 0u);
      EXPECT_FALSE(words.notes.empty());
      const Image image = galleryPicture(folder + "/" + name, 48).value();
      const auto covered = std::count_if(image.rgba.begin(), image.rgba.end(),
                                         [](std::uint8_t byte) { return byte != 0; });
      EXPECT_GT(covered, 48 * 48 / 4);
    }
  }
  std::size_t files = 0;
  for (const fs::directory_entry& file : fs::directory_iterator(folder))
    if (file.path().extension() == ".kiri") ++files;
  EXPECT_EQ(seen.size(), files);
}

TEST_F(GalleryFolder, WithoutAGalleryFileIsOneGroupByName) {
  for (const char* name : {"b.kiri", "a.kiri", "readme.txt"}) put(name, "{}");
  const Gallery gallery = galleryIn(folder);
  ASSERT_EQ(gallery.groups.size(), 1u);
  EXPECT_EQ(gallery.groups[0].title, "");
  EXPECT_EQ(gallery.groups[0].models, (std::vector<std::string>{"a.kiri", "b.kiri"}));
  EXPECT_TRUE(gallery.warnings.empty());
  EXPECT_TRUE(galleryIn(folder + "/nowhere").groups.empty());
}

TEST_F(GalleryFolder, ShowsWhatIsThereAndWhatTheGalleryFileForgot) {
  for (const char* name : {"a.kiri", "b.kiri", "c.kiri"}) put(name, "{}");
  put(kGalleryFile, R"({"format": "kiri gallery", "version": 1, "title": "Mine", "groups": [
    {"title": "Gone", "models": ["gone.kiri"]},
    {"title": "First", "notes": "C first.", "models": ["c.kiri", "lost.kiri"]}]})");
  const Gallery gallery = galleryIn(folder);
  ASSERT_EQ(gallery.groups.size(), 2u);
  EXPECT_EQ(gallery.groups[0].title, "First");
  EXPECT_EQ(gallery.groups[0].models, std::vector<std::string>{"c.kiri"});
  EXPECT_EQ(gallery.groups[1].models, (std::vector<std::string>{"a.kiri", "b.kiri"}));
}

TEST_F(GalleryFolder, AGalleryFileThatCannotBeReadHidesNoModel) {
  put("a.kiri", "{}");
  put(kGalleryFile, "{ no gallery");
  const Gallery gallery = galleryIn(folder);
  ASSERT_EQ(gallery.groups.size(), 1u);
  EXPECT_EQ(gallery.groups[0].models, std::vector<std::string>{"a.kiri"});
  EXPECT_EQ(gallery.warnings.size(), 1u);
}

TEST_F(GalleryFolder, WordsOfAModelNameItsFigure) {
  Model model = modelOf("square 100; fold A valley 50,0 50,100 left; angle nobody 30");
  const auto wordsWith = [&](const std::string& notes) {
    model.notes = notes;
    put("z_without_title.kiri", writeKiri(model));
    return wordsOf(folder + "/z_without_title.kiri").value();
  };
  EXPECT_EQ(wordsWith("Figure 7.13: a frog.").figure, "Figure 7.13");
  EXPECT_EQ(wordsWith("Like Figure 7.17: a swan.").figure, "Like Figure 7.17");
  EXPECT_EQ(wordsWith("A frog: it jumps.").figure, "");
  EXPECT_EQ(wordsWith("No colon in Figure 7.13").figure, "");
  EXPECT_EQ(wordsWith("A long sentence about Figure 7.13 that tells much: more.").figure, "");
  EXPECT_EQ(wordsWith("").title, "z_without_title");
  EXPECT_EQ(wordsWith("").steps, 2u);
  EXPECT_TRUE(galleryPicture(folder + "/z_without_title.kiri", 48).isOk())
      << "up to the step that does not apply";
  const auto stopped =
      galleryPicture(folder + "/z_without_title.kiri", 48, [](double) { return false; });
  EXPECT_EQ(stopped.error().code, ErrorCode::Cancelled);
  put("broken.kiri", "{ not a model");
  EXPECT_EQ(wordsOf(folder + "/broken.kiri").error().code, ErrorCode::BadFile);
  EXPECT_EQ(galleryPicture(folder + "/broken.kiri", 48).error().code, ErrorCode::BadFile);
}

TEST(NewSheet, EveryPresetIsASheetThatCanBeFoldedAndSaved) {
  for (const SheetPreset& preset : sheetPresets()) {
    SCOPED_TRACE(preset.id);
    const Result<Document> document = Document::create(preset.model);
    ASSERT_TRUE(document.isOk()) << document.error().message;
    EXPECT_FALSE(document->isModified());
    EXPECT_TRUE(isClean(*document->state()));
    const std::string file = writeKiri(preset.model);
    EXPECT_TRUE(readKiri(file, preset.id)->model == preset.model);
  }
}

TEST(NewSheet, ALeafIsSymmetricAboutItsMidVein) {
  const std::vector<SheetPreset> presets = sheetPresets();
  const auto leaf = std::find_if(presets.begin(), presets.end(),
                                 [](const SheetPreset& preset) { return preset.id == "leaf"; });
  ASSERT_NE(leaf, presets.end());
  EXPECT_EQ(leaf->model.opening, Sequence::Together);
  const FoldedState folded = after(startOf(leaf->model), "fold vein valley 55,0 55,160 left");
  EXPECT_EQ(facetCount(folded), 2u);
  for (const Vec2 p : leaf->model.sheet.outline) {
    if (p.x < 55) {
      EXPECT_TRUE(liesAt(folded, p, {110 - p.x, p.y, 0}));
    }
  }
}

TEST(NewSheet, RectanglesHaveSizesThatAHandCanFold) {
  EXPECT_EQ(rectangleModel(80, 80)->sheet.shape, SheetSpec::Shape::Square);
  EXPECT_EQ(rectangleModel(80, 60)->sheet.shape, SheetSpec::Shape::Rectangle);
  for (const double side : {0.0, -5.0, 1e6, std::nan("")}) {
    const Result<Model> refused = rectangleModel(100, side);
    ASSERT_FALSE(refused.isOk());
    EXPECT_EQ(refused.error().code, ErrorCode::BadValue);
  }
}

}  // namespace
}  // namespace kiri::test
