// The start page: the gallery with its groups, search, keyboard and preview.
// SPDX-License-Identifier: MIT
#include "apps/desktop/dialogs/start_page.h"

#include <QFile>
#include <QSignalSpy>
#include <QToolButton>
#include <set>

#include "tests/apps/desktop/dialogs/dialog_test_kit.h"

namespace kiri::desktop {
namespace {

class StartPageTest : public test::DialogTest {
 protected:
  void SetUp() override { page.resize(1100, 860); }
  void show() {
    page.show();
    ASSERT_TRUE(QTest::qWaitForWindowActive(&page));
    settle();
  }
  void settle() {
    ASSERT_TRUE(test::waitFor([&] { return runner_.pending() == 0; }, 60000));
  }
  /// The cards that are not hidden by the search.
  QStringList shownPaths() {
    QStringList paths;
    for (CardList* list : page.gallery().lists()) {
      const QStringList all = list->paths();
      for (int i = 0; i < list->count(); ++i)
        if (!list->item(i)->isHidden()) paths << all[i];
    }
    return paths;
  }
  static QPoint middleOf(CardList& list, int row) {
    return list.visualItemRect(list.item(row)).center();
  }
  CardList* focused() { return qobject_cast<CardList*>(page.focusWidget()); }

  StartPage page{runner_, settings_};
};

TEST_F(StartPageTest, ShowsTheGroupsOfTheGalleryInOrderWithAllTheirModels) {
  show();
  test::show(page, "start");
  const QList<ExampleGroup> groups = exampleGroups();
  const QList<CardList*> lists = page.gallery().lists();
  ASSERT_GE(groups.size(), 5);
  ASSERT_EQ(lists.size(), groups.size());
  int y = -1;
  std::set<QString> seen;
  for (qsizetype i = 0; i < groups.size(); ++i) {
    EXPECT_EQ(lists[i]->paths(), groups[i].models);
    EXPECT_EQ(lists[i]->accessibleName(), groups[i].title);
    const int top = lists[i]->mapTo(&page, QPoint(0, 0)).y();
    EXPECT_GT(top, y) << "below the group before";
    y = top;
    for (const QString& path : groups[i].models) {
      SCOPED_TRACE(path.toStdString());
      EXPECT_TRUE(seen.insert(path).second);
      const ModelCard card = page.cards().card(path);
      EXPECT_FALSE(card.picture.isNull());
      EXPECT_GT(card.steps, 0);
      int inked = 0;
      for (int row = 0; row < card.picture.height(); ++row)
        for (int x = 0; x < card.picture.width(); ++x)
          inked += qAlpha(card.picture.pixel(x, row)) > 200 ? 1 : 0;
      EXPECT_GT(inked, 1000);
    }
  }
}

TEST_F(StartPageTest, TellsWhatWasClicked) {
  settings_.addRecentFile(QString::fromStdString(test::examplePath("ship")));
  show();
  QSignalSpy files(&page, &StartPage::fileChosen);
  QSignalSpy examples(&page, &StartPage::exampleChosen);
  QSignalSpy sheets(&page, &StartPage::modelChosen);
  QSignalSpy tour(&page, &StartPage::tourWanted);
  CardList* recent = page.findChildren<CardList*>().front();
  QTest::mouseClick(recent->viewport(), Qt::LeftButton, {}, middleOf(*recent, 0));
  ASSERT_EQ(files.count(), 1);
  EXPECT_TRUE(files[0][0].toString().endsWith("ship.kiri"));
  CardList& first = *page.gallery().lists().front();
  QTest::mouseClick(first.viewport(), Qt::LeftButton, {}, middleOf(first, 1));
  ASSERT_EQ(examples.count(), 1);
  EXPECT_EQ(examples[0][0].toString(), first.paths()[1]);
  QTest::keyClick(&first, Qt::Key_Return);
  EXPECT_EQ(examples.count(), 2) << "by keyboard too";
  page.findChildren<QToolButton*>().first()->click();
  ASSERT_EQ(sheets.count(), 1);
  for (QPushButton* button : page.findChildren<QPushButton*>())
    if (button->text().contains("first leaf")) button->click();
  EXPECT_EQ(tour.count(), 1);
}

TEST_F(StartPageTest, WordsInTheSearchLeaveTheModelsThatHaveThem) {
  show();
  const qsizetype all = shownPaths().size();
  page.gallery().search().setText("crane");
  const QStringList cranes = shownPaths();
  ASSERT_FALSE(cranes.isEmpty());
  EXPECT_LT(cranes.size(), 4);
  EXPECT_TRUE(cranes.join(' ').contains("origami_crane"));
  for (CardList* list : page.gallery().lists()) {
    bool isHere = false;
    for (const QString& path : list->paths()) isHere = isHere || cranes.contains(path);
    if (!isHere) EXPECT_FALSE(list->isVisible() && list->height() > 0);
  }
  test::show(page, "start-search");
  page.gallery().search().setText("7.16 CUP");
  ASSERT_EQ(shownPaths().size(), 1) << "figure and title, in any case";
  EXPECT_TRUE(shownPaths().front().endsWith("origami_cup.kiri"));
  page.gallery().search().setText("zeppelin");
  EXPECT_TRUE(shownPaths().isEmpty());
  QTest::keyClick(&page.gallery().search(), Qt::Key_Escape);
  EXPECT_EQ(shownPaths().size(), all) << "Esc empties the field, and leaves the page only then";
  QSignalSpy closed(&page, &StartPage::closeWanted);
  QTest::keyClick(&page.gallery().search(), Qt::Key_Escape);
  EXPECT_EQ(closed.count(), 1);
}

TEST_F(StartPageTest, TheKeyboardReachesEveryModelAndThePageFollows) {
  show();
  QTest::keyClick(&page, Qt::Key_F, Qt::ControlModifier);
  ASSERT_TRUE(page.gallery().search().hasFocus());
  QTest::keyClick(&page.gallery().search(), Qt::Key_Down);
  std::set<QString> reached;
  const qsizetype all = page.gallery().paths().size();
  QSignalSpy chosen(&page, &StartPage::exampleChosen);
  for (qsizetype i = 0; i <= all && focused(); ++i) {
    CardList& list = *focused();
    const QRect card = list.visualItemRect(list.currentItem());
    EXPECT_TRUE(page.rect().contains(list.mapTo(&page, card.center()))) << "it is seen";
    EXPECT_EQ(page.preview().path(), list.pointedAt());
    reached.insert(list.pointedAt());
    const QString before = list.pointedAt();
    QTest::keyClick(&list, Qt::Key_Right);
    if (focused() && focused()->pointedAt() == before) break;  // the last
  }
  EXPECT_EQ(static_cast<qsizetype>(reached.size()), all);
  ASSERT_TRUE(focused());
  QTest::keyClick(focused(), Qt::Key_Return);
  ASSERT_EQ(chosen.count(), 1);
  EXPECT_EQ(chosen[0][0].toString(), page.gallery().paths().back());
  for (int i = 0; i < 40 && focused(); ++i) QTest::keyClick(focused(), Qt::Key_Up);
  EXPECT_TRUE(page.gallery().search().hasFocus()) << "up through all rows";
}

TEST_F(StartPageTest, PointingAtAModelShowsItsNotesAndHowItUnfolds) {
  show();
  ASSERT_TRUE(page.preview().isVisible());
  CardList& first = *page.gallery().lists().front();
  const QString path = first.paths()[1];
  QTest::mouseMove(first.viewport(), middleOf(first, 1));
  ASSERT_TRUE(test::waitFor([&] { return page.preview().path() == path; }));
  EXPECT_EQ(page.preview().notes(), page.cards().card(path).notes);
  ASSERT_TRUE(test::waitFor([&] { return page.preview().pictureCount() == 3; }));
  test::show(page, "start-preview");
  QSignalSpy chosen(&page, &StartPage::exampleChosen);
  page.preview().findChild<QPushButton*>()->click();
  ASSERT_EQ(chosen.count(), 1);
  EXPECT_EQ(chosen[0][0].toString(), path);
}

TEST_F(StartPageTest, SmallWindowsShowCardsWithoutPreview) {
  page.resize(620, 480);
  show();
  test::show(page, "start-small");
  EXPECT_FALSE(page.preview().isVisible());
  for (CardList* list : page.gallery().lists()) {
    EXPECT_LE(list->mapTo(&page, list->rect().bottomRight()).x(), page.width());
    EXPECT_EQ(list->height(), list->heightForWidth(list->width())) << "the page scrolls, not it";
    for (int i = 0; i < list->count(); ++i)
      EXPECT_TRUE(list->viewport()->rect().contains(list->visualItemRect(list->item(i))));
  }
}

TEST_F(StartPageTest, PicturesOfAnEarlierRunAreThereAtOnce) {
  show();
  const QString path = page.gallery().paths().front();
  const QImage first = page.cards().card(path).picture;
  const QImage again = drawCard(path, first.width(), [](double) { return false; });
  // Read from the disk, a picture may have its pixels in another order.
  EXPECT_EQ(again.convertToFormat(QImage::Format_ARGB32),
            first.convertToFormat(QImage::Format_ARGB32))
      << "nothing was folded: that would have been stopped";
}

TEST_F(StartPageTest, AFileThatIsNoModelHasACardWithoutPicture) {
  QFile broken(path("broken.kiri"));
  ASSERT_TRUE(broken.open(QIODevice::WriteOnly));
  broken.write("{");
  broken.close();
  settings_.addRecentFile(path("broken.kiri"));
  show();
  EXPECT_EQ(page.cards().card(path("broken.kiri")).title, "Broken");
  EXPECT_TRUE(page.cards().card(path("broken.kiri")).picture.isNull());
}

TEST_F(StartPageTest, AFileThatWasSavedAgainGetsAnotherPicture) {
  const QString file = path("model.kiri");
  const auto put = [&](const std::string& example) {
    QFile::remove(file);
    ASSERT_TRUE(QFile::copy(QString::fromStdString(test::examplePath(example)), file));
  };
  put("ship");
  settings_.addRecentFile(file);
  show();
  const ModelCard ship = page.cards().card(file);
  put("kirigami_star");
  page.refresh();
  settle();
  const ModelCard star = page.cards().card(file);
  EXPECT_NE(star.title, ship.title);
  EXPECT_NE(star.picture, ship.picture);
}

class PageThatGoes : public test::DialogTest {};

TEST_F(PageThatGoes, WhileItsPicturesAreMadeDoesNoHarm) {
  {
    StartPage page(runner_, settings_);
    page.resize(800, 600);
    page.show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&page));
    EXPECT_GT(runner_.pending(), 0U);
  }
  EXPECT_TRUE(test::waitFor([&] { return runner_.pending() == 0; }));
}

}  // namespace
}  // namespace kiri::desktop
