// The table of actions.
// SPDX-License-Identifier: MIT
#include "apps/desktop/actions.h"

#include <gtest/gtest.h>

#include <QMenu>
#include <QMenuBar>
#include <QSet>

#include "apps/desktop/look/icons.h"
#include "apps/desktop/menus.h"

namespace kiri::desktop {
namespace {

void collect(const QList<QAction*>& actions, QSet<QAction*>& found) {
  for (QAction* action : actions) {
    found.insert(action);
    if (action->menu()) collect(action->menu()->actions(), found);
  }
}

TEST(Actions, AllHaveATextAndNamesAreUnique) {
  const Actions actions;
  QSet<QString> names;
  for (const QAction* action : actions.all()) {
    EXPECT_FALSE(action->text().isEmpty()) << action->objectName().toStdString();
    EXPECT_FALSE(action->toolTip().isEmpty()) << action->objectName().toStdString();
    EXPECT_FALSE(names.contains(action->objectName())) << action->objectName().toStdString();
    names.insert(action->objectName());
  }
  EXPECT_GT(names.size(), 60);
}

TEST(Actions, NoTwoAnswerToTheSameKey) {
  const Actions actions;
  for (const auto& [one, other] : actions.conflicts()) {
    ADD_FAILURE() << one.toStdString() << " and " << other.toStdString();
  }
}

TEST(Actions, AConflictThatIsMadeIsFound) {
  Actions actions;
  actions.setKeys({{"tear", {QKeySequence("F")}}});
  ASSERT_EQ(actions.conflicts().size(), 1);
  EXPECT_EQ(actions.conflicts().front(), (QPair<QString, QString>("fold", "tear")));
  actions.setKeys({});
  EXPECT_TRUE(actions.conflicts().isEmpty());
}

TEST(Actions, HaveTheKeysThatThisFieldKnows) {
  const Actions actions;
  const QMap<QString, QStringList> known{
      {"new", {"Ctrl+N"}},     {"open", {"Ctrl+O"}},
      {"save", {"Ctrl+S"}},    {"save-as", {"Ctrl+Shift+S"}},
      {"undo", {"Ctrl+Z"}},    {"redo", {"Ctrl+Y", "Ctrl+Shift+Z"}},
      {"fold", {"F"}},         {"line", {"L"}},
      {"add-edge", {"A"}},     {"tear", {"T"}},
      {"straight-cut", {"C"}}, {"curve-cut", {"B"}},
      {"select", {"S"}},       {"mountain", {"M"}},
      {"valley", {"V"}},       {"turn-over", {"X"}},
      {"grid", {"G"}},         {"view-front", {"1"}},
      {"view-back", {"2"}},    {"sheet-only", {"3"}},
      {"fit", {"0"}},          {"help", {"F1"}},
      {"cancel", {"Esc"}},     {"delete", {"Del"}}};
  for (auto it = known.begin(); it != known.end(); ++it) {
    QStringList keys;
    for (const QKeySequence& key : actions[it.key()].shortcuts()) keys << key.toString();
    EXPECT_EQ(keys, it.value()) << it.key().toStdString();
  }
}

TEST(Actions, EveryIconThatIsNamedIsDrawn) {
  for (const ActionSpec& spec : actionTable()) {
    if (spec.icon[0] != '\0') EXPECT_TRUE(hasIcon(spec.icon)) << spec.icon;
  }
  EXPECT_FALSE(hasIcon("no-such-icon"));
}

TEST(Actions, EveryToolHasAnIconAndAKey) {
  const Actions actions;
  for (const QString& id : toolActionIds()) {
    EXPECT_FALSE(actions[id].icon().isNull()) << id.toStdString();
    EXPECT_FALSE(actions[id].shortcut().isEmpty()) << id.toStdString();
    EXPECT_TRUE(actions[id].isCheckable()) << id.toStdString();
  }
}

TEST(Menus, ReachEveryAction) {
  QMainWindow window;
  Actions actions;
  makeMenus(window, actions);
  QSet<QAction*> reached;
  collect(window.menuBar()->actions(), reached);
  for (QAction* action : actions.all()) {
    EXPECT_TRUE(reached.contains(action)) << action->objectName().toStdString();
  }
}

TEST(Menus, HaveMnemonicsThatDoNotCollideWithinAMenu) {
  QMainWindow window;
  Actions actions;
  makeMenus(window, actions);
  for (const QAction* top : window.menuBar()->actions()) {
    QMap<QChar, QString> taken;
    for (const QAction* action : top->menu()->actions()) {
      const qsizetype at = action->text().indexOf('&');
      if (at < 0) continue;
      const QChar letter = action->text()[at + 1].toLower();
      EXPECT_FALSE(taken.contains(letter))
          << top->text().toStdString() << ": " << action->text().toStdString() << " and "
          << taken[letter].toStdString();
      taken.insert(letter, action->text());
    }
  }
}

}  // namespace
}  // namespace kiri::desktop
