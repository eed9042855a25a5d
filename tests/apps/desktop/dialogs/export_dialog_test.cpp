// Exports and films from the window.
// SPDX-License-Identifier: MIT
#include "apps/desktop/dialogs/export_dialog.h"

#include <QComboBox>
#include <QImage>
#include <QLabel>
#include <QProcess>
#include <QSignalSpy>

#include "apps/desktop/dialogs/film_dialog.h"
#include "apps/desktop/dialogs/form.h"
#include "io/patterns/pattern_file.h"
#include "tests/apps/desktop/dialogs/dialog_test_kit.h"

namespace kiri::desktop {
namespace {

class ExportDialogTest : public test::DialogTest {
 protected:
  /// The dialog with subject and format as they were remembered.
  std::unique_ptr<ExportDialog> dialogFor(ExportSubject subject, ExportFormat format,
                                          const std::string& example = "leaf_three_lobes") {
    settings_.setValue("export/subject", static_cast<int>(subject));
    settings_.setValue("export/format", static_cast<int>(format));
    return std::make_unique<ExportDialog>(test::exampleSource(example), runner_, settings_, "1.2");
  }
  void exportAs(ExportDialog& dialog, const QString& name) {
    QSignalSpy done(&dialog, &ExportDialog::exported);
    dialog.exportInto(path(name));
    EXPECT_TRUE(dialog.isBusy());
    EXPECT_TRUE(test::waitFor([&] { return !dialog.isBusy(); }));
    EXPECT_EQ(done.count(), 1) << name.toStdString();
  }
};

TEST_F(ExportDialogTest, WritesEveryFormatOfModelAndSheet) {
  const std::pair<ExportFormat, std::string> kFormats[] = {
      {ExportFormat::Svg, "<?xml"}, {ExportFormat::Pdf, "%PDF"}, {ExportFormat::Png, "\x89PNG"},
      {ExportFormat::Fold, "{"},    {ExportFormat::Obj, "#"},    {ExportFormat::Gltf, "glTF"}};
  for (const ExportSubject subject : {ExportSubject::Model, ExportSubject::Sheet}) {
    for (const auto& [format, begin] : kFormats) {
      const auto dialog = dialogFor(subject, format);
      const ExportRequest request = dialog->request();
      EXPECT_EQ(request.subject, subject);
      EXPECT_EQ(request.format, format);
      const QString name = "out." + endingOf(format);
      exportAs(*dialog, name);
      EXPECT_EQ(bytesOf(name).substr(0, begin.size()), begin);
    }
  }
}

TEST_F(ExportDialogTest, ASheetAsSvgHasTheLayersOfMachinesUnlessToldOtherwise) {
  const auto dialog = dialogFor(ExportSubject::Sheet, ExportFormat::Svg);
  exportAs(*dialog, "machines.svg");
  EXPECT_NE(bytesOf("machines.svg").find("id=\"Score-"), std::string::npos);
}

TEST_F(ExportDialogTest, TellsWhatAPatternFormatCannotHoldBeforeItIsWritten) {
  for (const ExportFormat format : {ExportFormat::Cp, ExportFormat::Opx, ExportFormat::Dxf}) {
    const auto dialog = dialogFor(ExportSubject::Model, format, "ship");
    EXPECT_EQ(dialog->request().subject, ExportSubject::Sheet) << "a pattern is of the sheet";
    const ExportSource source = test::exampleSource("ship");
    const std::vector<std::string> losses = lossesOf(source, dialog->request());
    if (!losses.empty()) {
      const auto isTold = [&] {
        for (const QLabel* label : dialog->findChildren<QLabel*>()) {
          if (label->text().contains(QString::fromStdString(losses.front()).mid(1))) return true;
        }
        return false;
      };
      EXPECT_TRUE(test::waitFor(isTold)) << losses.front();
    }
    const QString name = "ship." + endingOf(format);
    exportAs(*dialog, name);
    const auto read = readPattern(bytesOf(name), name.toStdString());
    ASSERT_TRUE(read.isOk()) << read.error().message;
    EXPECT_GE(read->drawing.lines.size(), 9U);
  }
  const auto dialog = dialogFor(ExportSubject::Sheet, ExportFormat::Cp, "ship");
  EXPECT_FALSE(lossesOf(test::exampleSource("ship"), dialog->request()).empty())
      << "the title of the ship, at least, is lost";
}

TEST_F(ExportDialogTest, SaysWhyAFileCannotBeWrittenAndStaysOpen) {
  const auto dialog = dialogFor(ExportSubject::Model, ExportFormat::Svg);
  dialog->show();
  QSignalSpy done(dialog.get(), &ExportDialog::exported);
  dialog->exportInto("/nowhere/at/all.svg");
  ASSERT_TRUE(test::waitFor([&] { return !dialog->isBusy(); }));
  EXPECT_EQ(done.count(), 0);
  EXPECT_TRUE(dialog->isVisible());
  EXPECT_TRUE(dialog->findChild<WorkBar*>()->said().contains("/nowhere/at/all.svg"));
}

TEST_F(ExportDialogTest, TheWindowAnswersWhileALargeModelIsWritten) {
  const auto dialog = dialogFor(ExportSubject::Model, ExportFormat::Fold, "leaf_secondary_lobes");
  dialog->exportInto(path("large.fold"));
  qint64 longest = 0;
  while (dialog->isBusy()) {
    QElapsedTimer turn;
    turn.start();
    QCoreApplication::processEvents();
    longest = std::max(longest, turn.elapsed());
    QTest::qSleep(1);
  }
  EXPECT_LT(longest, 100);
  EXPECT_GT(bytesOf("large.fold").size(), 1000U);
}

TEST_F(ExportDialogTest, ShowsOnlyOptionsThatMeanSomething) {
  const auto model = dialogFor(ExportSubject::Model, ExportFormat::Png);
  test::show(*model, "export-model-png");
  const auto sheet = dialogFor(ExportSubject::Sheet, ExportFormat::Svg);
  QTest::qWait(300);
  test::show(*sheet, "export-sheet-svg");
  const auto program = dialogFor(ExportSubject::Model, ExportFormat::Gltf);
  test::show(*program, "export-gltf");
  const auto visibleBoxes = [](const ExportDialog& dialog) {
    int count = 0;
    for (const QDoubleSpinBox* box : dialog.findChildren<QDoubleSpinBox*>())
      count += box->isVisible() ? 1 : 0;
    return count;
  };
  EXPECT_EQ(visibleBoxes(*model), 3) << "size, margin, resolution";
  EXPECT_EQ(visibleBoxes(*sheet), 1) << "margin";
  EXPECT_EQ(visibleBoxes(*program), 2) << "gap, thickness";
}

class FilmDialogTest : public test::DialogTest {};

TEST_F(FilmDialogTest, MakesAFilmAndShowsHowFarItIs) {
  if (!hasFilmProgram()) GTEST_SKIP() << "no ffmpeg here";
  settings_.setValue("film/format", static_cast<int>(FilmFormat::Gif));
  settings_.setValue("film/size", QSize(480, 360));
  FilmDialog dialog(test::exampleSource("straight_cut"), runner_, settings_);
  test::show(dialog, "film");
  QSignalSpy done(&dialog, &FilmDialog::filmed);
  dialog.filmInto(path("film.gif"));
  ASSERT_TRUE(test::waitFor([&] { return !dialog.isBusy(); }, 60000));
  ASSERT_EQ(done.count(), 1) << dialog.findChild<WorkBar*>()->said().toStdString();
  EXPECT_EQ(bytesOf("film.gif").substr(0, 4), "GIF8");
}

TEST_F(FilmDialogTest, CancelStopsItAndLeavesNothingBehind) {
  if (!hasFilmProgram()) GTEST_SKIP() << "no ffmpeg here";
  FilmDialog dialog(test::exampleSource("leaf_palmate"), runner_, settings_);
  dialog.show();
  QSignalSpy done(&dialog, &FilmDialog::filmed);
  dialog.filmInto(path("film.mp4"));
  QTest::qWait(100);
  static_cast<QDialog&>(dialog).reject();
  EXPECT_TRUE(dialog.isVisible()) << "the first cancel stops the work only";
  ASSERT_TRUE(test::waitFor([&] { return !dialog.isBusy(); }, 10000));
  EXPECT_EQ(done.count(), 0);
  EXPECT_TRUE(QDir(folder_.path()).isEmpty());
}

TEST_F(FilmDialogTest, WithoutFfmpegItSaysWhatToDo) {
  const QByteArray before = qgetenv("PATH");
  qputenv("PATH", "/nowhere");
  FilmDialog dialog(test::exampleSource("straight_cut"), runner_, settings_);
  test::show(dialog, "film-no-ffmpeg");
  qputenv("PATH", before);
  bool isSaid = false;
  for (const QLabel* label : dialog.findChildren<QLabel*>())
    isSaid = isSaid || (label->isVisible() && label->text().contains("apt install ffmpeg"));
  EXPECT_TRUE(isSaid);
  int enabled = 0;
  for (const QPushButton* button : dialog.findChildren<QPushButton*>())
    enabled += button->isEnabled() ? 1 : 0;
  EXPECT_EQ(enabled, 1) << "only Close";
}

}  // namespace
}  // namespace kiri::desktop
