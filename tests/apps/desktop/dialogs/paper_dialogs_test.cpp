// Sheets, colours, the start page, about.
// SPDX-License-Identifier: MIT
#include <QFile>
#include <QSignalSpy>
#include <QToolButton>
#include <set>

#include "apps/desktop/dialogs/about_dialog.h"
#include "apps/desktop/dialogs/appearance_dialog.h"
#include "apps/desktop/dialogs/sheet_dialog.h"
#include "apps/desktop/dialogs/start_page.h"
#include "apps/desktop/look/icons.h"
#include "apps/desktop/services/gallery.h"
#include "core/geometry/region.h"
#include "tests/apps/desktop/dialogs/dialog_test_kit.h"

namespace kiri::desktop {
namespace {

TEST(SheetDialogTest, GivesBackEverySheetThatItIsGiven) {
  for (const SheetPreset& preset : sheetPresets()) {
    EXPECT_TRUE(hasIcon(iconOf(preset))) << preset.id;
    SheetDialog dialog(preset.model.sheet);
    const Result<Sheet> back = makeSheet(dialog.sheet());
    ASSERT_TRUE(back.isOk());
    EXPECT_NEAR(areaOf(back->outline), areaOf(makeSheet(preset.model.sheet)->outline), 2);
  }
}

TEST(SheetDialogTest, LooksRightAndScalesAPolygon) {
  SheetDialog dialog(sheetPresets()[1].model.sheet);
  test::show(dialog, "sheet");
  const Box before = boundsOf(makeSheet(dialog.sheet())->outline);
  for (QDoubleSpinBox* box : dialog.findChildren<QDoubleSpinBox*>())
    box->setValue(2 * box->value());
  const Box after = boundsOf(makeSheet(dialog.sheet())->outline);
  EXPECT_NEAR(after.high.x - after.low.x, 2 * (before.high.x - before.low.x), 1e-6);
  EXPECT_NEAR(after.high.y - after.low.y, 2 * (before.high.y - before.low.y), 1e-6);
}

class PaperDialogs : public test::DialogTest {};

TEST_F(PaperDialogs, ColoursAndImagesOfBothSidesAreChosen) {
  const Model model;
  QImage image(40, 40, QImage::Format_RGB32);
  image.fill(Qt::magenta);
  ASSERT_TRUE(image.save(path("spots.png")));
  AppearanceDialog dialog(model.front, model.back, path("model.kiri"), runner_);
  EXPECT_FALSE(dialog.isChanged());
  dialog.setColor(false, {1, 2, 3});
  dialog.setTexture(true, path("spots.png"));
  EXPECT_TRUE(dialog.isChanged());
  EXPECT_EQ(dialog.back().color, (Color{1, 2, 3}));
  EXPECT_EQ(dialog.front().texture, "spots.png") << "relative to the model's file";
  ASSERT_TRUE(test::waitFor([&] {
    for (const QLabel* label : dialog.findChildren<QLabel*>()) {
      const QPixmap picture = label->pixmap();
      if (!picture.isNull() && picture.toImage().pixelColor(30, 30) == QColor(Qt::magenta))
        return true;
    }
    return false;
  }));
  test::show(dialog, "appearance");
  dialog.setTexture(true, "/elsewhere/spots.png");
  EXPECT_EQ(dialog.front().texture, "/elsewhere/spots.png");
  dialog.usePreset(0);
  EXPECT_EQ(dialog.front().texture, "");
  EXPECT_FALSE(dialog.isChanged()) << "the first preset is what new models have";
}

TEST_F(PaperDialogs, EveryExampleHasACardWithAPicture) {
  const QStringList paths = modelsIn(examplesFolder());
  ASSERT_GE(paths.size(), 8);
  std::set<QString> titles;
  for (const QString& example : paths) {
    const ModelCard card = cardOf(example, 64);
    EXPECT_FALSE(card.picture.isNull()) << example.toStdString();
    EXPECT_GT(card.steps, 0);
    titles.insert(card.title);
    int inked = 0;
    for (int y = 0; y < 64; ++y)
      for (int x = 0; x < 64; ++x) inked += qAlpha(card.picture.pixel(x, y)) > 200 ? 1 : 0;
    EXPECT_GT(inked, 300) << example.toStdString();
  }
  EXPECT_EQ(titles.size(), static_cast<std::size_t>(paths.size()));
  QFile broken(path("broken.kiri"));
  ASSERT_TRUE(broken.open(QIODevice::WriteOnly));
  broken.write("{");
  broken.close();
  EXPECT_TRUE(cardOf(path("broken.kiri"), 64).picture.isNull());
}

TEST_F(PaperDialogs, TheStartPageShowsExamplesAndTellsWhatWasClicked) {
  settings_.addRecentFile(QString::fromStdString(test::examplePath("ship")));
  StartPage page(runner_, settings_);
  page.resize(1100, 860);
  page.show();
  ASSERT_TRUE(QTest::qWaitForWindowExposed(&page));
  ASSERT_TRUE(test::waitFor([&] { return runner_.pending() == 0; }, 60000));
  test::show(page, "start");
  const QList<QListWidget*> lists = page.findChildren<QListWidget*>();
  ASSERT_EQ(lists.size(), 2);
  EXPECT_EQ(lists[0]->count(), 1);
  EXPECT_EQ(lists[1]->count(), modelsIn(examplesFolder()).size());
  QSignalSpy files(&page, &StartPage::fileChosen);
  QSignalSpy examples(&page, &StartPage::exampleChosen);
  QSignalSpy sheets(&page, &StartPage::modelChosen);
  QSignalSpy tour(&page, &StartPage::tourWanted);
  const auto click = [](QListWidget& list, int row) {
    QTest::mouseClick(list.viewport(), Qt::LeftButton, {},
                      list.visualItemRect(list.item(row)).center());
  };
  click(*lists[0], 0);
  ASSERT_EQ(files.count(), 1);
  EXPECT_TRUE(files[0][0].toString().endsWith("ship.kiri"));
  click(*lists[1], 1);
  ASSERT_EQ(examples.count(), 1);
  QTest::keyClick(lists[1], Qt::Key_Return);
  EXPECT_EQ(examples.count(), 2) << "by keyboard too";
  page.findChildren<QToolButton*>().first()->click();
  ASSERT_EQ(sheets.count(), 1);
  for (QPushButton* button : page.findChildren<QPushButton*>())
    if (button->text().contains("first leaf")) button->click();
  EXPECT_EQ(tour.count(), 1);
}

TEST_F(PaperDialogs, APageThatGoesWhileItsPicturesAreMadeDoesNoHarm) {
  {
    StartPage page(runner_, settings_);
    page.resize(800, 600);
    page.show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&page));
    EXPECT_GT(runner_.pending(), 0U);
  }
  EXPECT_TRUE(test::waitFor([&] { return runner_.pending() == 0; }));
}

TEST_F(PaperDialogs, AboutTellsVersionAndRenderer) {
  AboutDialog dialog("9.8.7", "Mesa llvmpipe, OpenGL 4.5");
  test::show(dialog, "about");
  EXPECT_TRUE(dialog.facts().contains("9.8.7"));
  EXPECT_TRUE(dialog.facts().contains("llvmpipe"));
}

TEST(Icons, EveryDrawingIsDrawnInTheColourThatIsAskedFor) {
  const QDir folder(QString(KIRI_SOURCE_DIR) + "/apps/desktop/look/icons");
  const QStringList files = folder.entryList({"*.svg"});
  ASSERT_GE(files.size(), 50);
  for (const QString& file : files) {
    const QString name = file.chopped(4);
    EXPECT_TRUE(hasIcon(name)) << name.toStdString();
    const QImage image = icon(name).pixmap(QSize(48, 48), 1.0).toImage();
    int inked = 0;
    for (int y = 0; y < image.height(); ++y)
      for (int x = 0; x < image.width(); ++x) inked += qAlpha(image.pixel(x, y)) > 128 ? 1 : 0;
    EXPECT_GT(inked, 60) << name.toStdString();
  }
}

}  // namespace
}  // namespace kiri::desktop
