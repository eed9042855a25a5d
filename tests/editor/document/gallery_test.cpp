// The gallery of examples, and the sheets of the start page.
// SPDX-License-Identifier: MIT
#include "editor/document/gallery.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>

#include "editor/document/document.h"
#include "editor/document/new_sheet.h"
#include "io/kiri_reader.h"
#include "io/kiri_writer.h"
#include "tests/support/expect.h"
#include "tests/support/model_text.h"

namespace kiri::test {
namespace {

namespace fs = std::filesystem;

TEST(Gallery, OfTheExamplesHasThemAllWithPictures) {
  const std::vector<GalleryEntry> entries = galleryOf(KIRI_SOURCE_DIR "/examples");
  ASSERT_GE(entries.size(), 10u);
  for (const GalleryEntry& entry : entries) {
    SCOPED_TRACE(entry.file);
    EXPECT_FALSE(entry.error.has_value());
    EXPECT_FALSE(entry.title.empty());
    EXPECT_GT(entry.steps, 0u);
    const Image image = galleryPicture(entry, 48).value();
    const auto covered = std::count_if(image.rgba.begin(), image.rgba.end(),
                                       [](std::uint8_t byte) { return byte != 0; });
    EXPECT_GT(covered, 48 * 48 / 4);
  }
  EXPECT_TRUE(std::is_sorted(
      entries.begin(), entries.end(),
      [](const GalleryEntry& a, const GalleryEntry& b) { return a.title < b.title; }));
}

TEST(Gallery, ListsFilesThatCannotBeReadLast) {
  std::string folder = (fs::temp_directory_path() / "kiri-gallery-XXXXXX").string();
  ASSERT_NE(::mkdtemp(folder.data()), nullptr);
  Model model = modelOf("square 100; fold A valley 50,0 50,100 left; angle nobody 30");
  std::ofstream(folder + "/z_without_title.kiri") << writeKiri(model);
  model.title = "Zeppelin";
  model.notes = "flies";
  std::ofstream(folder + "/b.kiri") << writeKiri(model);
  std::ofstream(folder + "/a.kiri") << "{ not a model";
  std::ofstream(folder + "/readme.txt") << "no model";
  const std::vector<GalleryEntry> entries = galleryOf(folder);
  ASSERT_EQ(entries.size(), 3u);
  EXPECT_EQ(entries[0].title, "Zeppelin");
  EXPECT_EQ(entries[0].notes, "flies");
  EXPECT_EQ(entries[0].steps, 2u);
  EXPECT_EQ(entries[1].title, "z_without_title");
  EXPECT_EQ(entries[2].title, "a");
  ASSERT_TRUE(entries[2].error.has_value());
  EXPECT_EQ(galleryPicture(entries[2], 48).error().code, ErrorCode::BadFile);
  EXPECT_TRUE(galleryPicture(entries[0], 48).isOk()) << "up to the step that does not apply";
  EXPECT_EQ(galleryPicture(entries[0], 48, [](double) { return false; }).error().code,
            ErrorCode::Cancelled);
  EXPECT_TRUE(galleryOf(folder + "/nowhere").empty());
  fs::remove_all(folder);
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
