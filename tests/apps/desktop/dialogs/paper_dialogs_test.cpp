// Sheets, colours, about.
// SPDX-License-Identifier: MIT
#include <QLabel>

#include "apps/desktop/dialogs/about_dialog.h"
#include "apps/desktop/dialogs/appearance_dialog.h"
#include "apps/desktop/dialogs/sheet_dialog.h"
#include "apps/desktop/look/icons.h"
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
