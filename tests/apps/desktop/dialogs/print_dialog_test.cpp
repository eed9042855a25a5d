// Printing in true size.
// SPDX-License-Identifier: MIT
#include "apps/desktop/dialogs/print_dialog.h"

#include <QImage>
#include <QSignalSpy>
#include <random>

#include "apps/desktop/look/scene_painter.h"
#include "render/canvas/rasterise.h"
#include "tests/apps/desktop/dialogs/dialog_test_kit.h"

namespace kiri::desktop {
namespace {

TEST(PageTiles, ShowEveryPointOfThePictureAndNeighboursShareTheStrip) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> length(5, 1500);
  for (int i = 0; i < 300; ++i) {
    const QSizeF picture(length(random), length(random));
    const QSizeF page(190, 277);
    const double overlap = i % 3 * 7.0;
    const PageTiles tiles = tilesFor(picture, page, overlap);
    EXPECT_NEAR(tiles.partOn(0, 0).left(),
                picture.width() - tiles.partOn(tiles.columns - 1, 0).right(), 1e-6)
        << "in the middle";
    EXPECT_LE(tiles.partOn(0, 0).left(), 0.05);
    EXPECT_LE(tiles.partOn(0, 0).top(), 0.05);
    EXPECT_GE(tiles.partOn(tiles.columns - 1, tiles.rows - 1).bottom(), picture.height() - 0.05);
    for (int c = 1; c < tiles.columns; ++c) {
      EXPECT_NEAR(tiles.partOn(c - 1, 0).right() - tiles.partOn(c, 0).left(), overlap, 1e-6);
    }
    if (tiles.columns > 1) {
      const PageTiles fewer = tilesFor(picture, page, 0);
      EXPECT_GT(picture.width(), page.width() * (fewer.columns - 1)) << "as few as possible";
    }
  }
}

TEST(ScenePainter, DrawsWhatCairoDraws) {
  const ExportSource source = test::exampleSource("leaf_three_lobes");
  for (const ExportSubject subject : {ExportSubject::Model, ExportSubject::Sheet}) {
    ExportRequest request;
    request.subject = subject;
    request.view = ExportView::Front;
    request.background = Color{255, 255, 255};
    const Scene scene = sceneOf(source, request).value();
    constexpr int kPixels = 600;
    const double scale = kPixels / std::max(scene.width, scene.height);
    const int width = static_cast<int>(scene.width * scale);
    const int height = static_cast<int>(scene.height * scale);
    const Image cairo = rasterise(scene, width, height).value();
    QImage ours(width, height, QImage::Format_RGB32);
    ours.fill(Qt::white);
    QPainter painter(&ours);
    painter.scale(width / scene.width, height / scene.height);
    paintScene(painter, scene, 2 / scale);
    painter.end();
    int unlike = 0;
    int inked = 0;
    for (int y = 0; y < height; ++y) {
      for (int x = 0; x < width; ++x) {
        const std::size_t at = (static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                                static_cast<std::size_t>(x)) *
                               4;
        const QColor color = ours.pixelColor(x, y);
        const int difference = std::abs(color.red() - cairo.rgba[at]) +
                               std::abs(color.green() - cairo.rgba[at + 1]) +
                               std::abs(color.blue() - cairo.rgba[at + 2]);
        unlike += difference > 120 ? 1 : 0;
        inked += cairo.rgba[at] < 200 ? 1 : 0;
      }
    }
    EXPECT_GT(inked, 10000);
    EXPECT_LT(unlike, inked / 100);
  }
}

class PrintDialogTest : public test::DialogTest {
 protected:
  static void waitForPicture(PrintDialog& dialog) {
    ASSERT_TRUE(test::waitFor([&] { return dialog.tiles().has_value(); }));
  }
};

TEST_F(PrintDialogTest, ASheetThatFitsIsPrintedOnOnePageInTrueSize) {
  const ExportSource source = test::exampleSource("ship");
  PrintDialog dialog(source, runner_, settings_);
  waitForPicture(dialog);
  const Box sheet = boundsOf(makeSheet(source.model.sheet)->outline);
  EXPECT_EQ(dialog.tiles()->count(), 1);
  EXPECT_NEAR(dialog.tiles()->picture.width(), sheet.high.x - sheet.low.x, 1.5)
      << "the sheet, and half a line around it";
  ASSERT_TRUE(dialog.printToPdf(path("one.pdf")));
  EXPECT_EQ(bytesOf("one.pdf").substr(0, 4), "%PDF");
  QTest::qWait(300);
  test::show(dialog, "print-one");
}

TEST_F(PrintDialogTest, ALargerOneIsSpreadOverSeveralPages) {
  PrintDialog dialog(test::exampleSource("leaf_palmate"), runner_, settings_);
  waitForPicture(dialog);
  QDoubleSpinBox* scale = nullptr;
  for (QDoubleSpinBox* box : dialog.findChildren<QDoubleSpinBox*>())
    if (box->suffix().contains('%')) scale = box;
  ASSERT_NE(scale, nullptr);
  QSignalSpy ready(&dialog, &PrintDialog::pictureReady);
  scale->setValue(300);
  ASSERT_TRUE(test::waitFor([&] { return ready.count() > 0; }));
  EXPECT_EQ(dialog.tiles()->columns, 3);
  EXPECT_EQ(dialog.tiles()->rows, 2);
  ASSERT_TRUE(dialog.printToPdf(path("many.pdf")));
  const std::string pdf = bytesOf("many.pdf");
  std::size_t pages = 0;
  for (std::size_t at = pdf.find("/Type /Page\n"); at != std::string::npos;
       at = pdf.find("/Type /Page\n", at + 1))
    ++pages;
  EXPECT_EQ(pages, 6U);
  QTest::qWait(300);
  test::show(dialog, "print-tiled");
}

TEST_F(PrintDialogTest, OneMillimetreOfPaperIsOneMillimetreOnThePage) {
  const ExportSource source = test::exampleSource("ship");
  ExportRequest request;
  request.subject = ExportSubject::Sheet;
  request.margin = 0;
  request.isLinesOnly = true;
  const Scene scene = sceneOf(source, request).value();
  const PageTiles tiles =
      tilesFor({scene.width, scene.height}, {scene.width + 20, scene.height + 20}, 0);
  constexpr double kPixelsPerMm = 8;
  QImage page(static_cast<int>(tiles.page.width() * kPixelsPerMm),
              static_cast<int>(tiles.page.height() * kPixelsPerMm), QImage::Format_RGB32);
  page.fill(Qt::white);
  QPainter painter(&page);
  painter.scale(kPixelsPerMm, kPixelsPerMm);
  paintTile(painter, scene, tiles, 0, 0);
  painter.end();
  int first = page.width();
  int last = 0;
  for (int x = 0; x < page.width(); ++x) {
    for (int y = 0; y < page.height(); ++y) {
      if (qGray(page.pixel(x, y)) > 128) continue;
      first = std::min(first, x);
      last = std::max(last, x);
    }
  }
  const Result<Sheet> sheet = makeSheet(source.model.sheet);
  const Box box = boundsOf(sheet->outline);
  EXPECT_NEAR((last - first) / kPixelsPerMm, box.high.x - box.low.x, 0.7);
}

}  // namespace
}  // namespace kiri::desktop
