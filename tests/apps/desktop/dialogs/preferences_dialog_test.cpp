// Preferences and keys.
// SPDX-License-Identifier: MIT
#include "apps/desktop/dialogs/preferences_dialog.h"

#include <QSignalSpy>
#include <memory>

#include "apps/desktop/look/icons.h"
#include "tests/apps/desktop/dialogs/dialog_test_kit.h"

namespace kiri::desktop {
namespace {

class PreferencesDialogTest : public test::DialogTest {
 protected:
  PreferencesDialogTest() {
    add("fold", "&Fold", "F");
    add("line", "Fold &line", "L");
    add("add-edge", "&Add edge", "A");
    add("redo", "&Redo", "Ctrl+Y; Ctrl+Shift+Z");
    add("save-as", "Save &as...", "Ctrl+Shift+S");
    add("export", "&Export...", "Ctrl+E");
    add("film", "&Film...", "");
    add("unfold", "U&nfold all", "Ctrl+U");
    add("fit", "&Fit", "0");
  }
  void add(const char* name, const char* text, const char* keys) {
    auto action = std::make_unique<QAction>(icon(name), text);
    action->setObjectName(name);
    own_.insert(name, QKeySequence::listFromString(keys));
    list_.append(action.get());
    actions_.push_back(std::move(action));
  }
  std::vector<std::unique_ptr<QAction>> actions_;
  QList<QAction*> list_;
  QMap<QString, Keys> own_;
};

template <class Box>
Box* boxNamed(const QWidget& dialog, const QString& text) {
  for (Box* box : dialog.findChildren<Box*>())
    if (box->text().contains(text)) return box;
  return nullptr;
}

TEST_F(PreferencesDialogTest, ShowsWhatIsAndAppliesAtOnce) {
  Preferences p;
  p.lineStyle = LineStyle::Safe;
  p.snaps.divisions = 3;
  p.snaps.angleStep = 22.5;
  p.language = "de";
  settings_.setPreferences(p);
  PreferencesDialog dialog(settings_, list_, own_);
  EXPECT_EQ(dialog.preferences(), p);
  QSignalSpy changes(&settings_, &Settings::preferencesChanged);
  auto* autosave = boxNamed<QCheckBox>(dialog, "crashes");
  ASSERT_NE(autosave, nullptr);
  autosave->click();
  EXPECT_EQ(changes.count(), 1);
  EXPECT_FALSE(settings_.preferences().autosaves);
  dialog.accept();
  EXPECT_FALSE(Settings().preferences().autosaves);
}

TEST_F(PreferencesDialogTest, CancelTakesEverythingBack) {
  PreferencesDialog dialog(settings_, list_, own_);
  boxNamed<QCheckBox>(dialog, "crashes")->click();
  boxNamed<QCheckBox>(dialog, "Middles")->click();
  ASSERT_NE(settings_.preferences(), Preferences{});
  dialog.reject();
  EXPECT_EQ(settings_.preferences(), Preferences{});
}

TEST_F(PreferencesDialogTest, LooksRightOnAllPages) {
  PreferencesDialog dialog(settings_, list_, own_);
  test::show(dialog, "preferences-general");
  auto* pages = dialog.findChild<QTabWidget*>();
  ASSERT_EQ(pages->count(), 3);
  pages->setCurrentIndex(1);
  test::show(dialog, "preferences-hand");
  dialog.findChild<ShortcutEditor*>()->setKeys("line", {QKeySequence("F")});
  dialog.showShortcuts();
  EXPECT_EQ(pages->currentIndex(), 2);
  test::show(dialog, "preferences-keys");
}

TEST_F(PreferencesDialogTest, KeysAreKeptWhenAcceptedOnly) {
  {
    PreferencesDialog dialog(settings_, list_, own_);
    dialog.findChild<ShortcutEditor*>()->setKeys("fold", {QKeySequence("K")});
    dialog.reject();
    EXPECT_TRUE(settings_.shortcuts().isEmpty());
  }
  PreferencesDialog dialog(settings_, list_, own_);
  QSignalSpy changes(&settings_, &Settings::shortcutsChanged);
  dialog.findChild<ShortcutEditor*>()->setKeys("fold", {QKeySequence("K")});
  dialog.accept();
  EXPECT_EQ(changes.count(), 1);
  EXPECT_EQ(settings_.shortcuts()["fold"], Keys{QKeySequence("K")});
}

TEST_F(PreferencesDialogTest, PressedKeysBecomeThoseOfTheChosenAction) {
  ShortcutEditor editor(list_, own_, {});
  editor.show();
  ASSERT_TRUE(QTest::qWaitForWindowActive(&editor));
  auto* list = editor.findChild<QTreeWidget*>();
  list->setCurrentItem(list->topLevelItem(1));
  auto* press = editor.findChild<QKeySequenceEdit*>();
  press->setFocus();
  QTest::keyClick(press, Qt::Key_J, Qt::ControlModifier);
  ASSERT_TRUE(test::waitFor([&] { return editor.shortcuts().contains("line"); }));
  EXPECT_EQ(editor.shortcuts()["line"], Keys{QKeySequence("Ctrl+J")});
}

TEST_F(PreferencesDialogTest, ClashesAreShownUntilTheyAreGone) {
  ShortcutEditor editor(list_, own_, {});
  editor.show();
  auto* clash = editor.findChild<QLabel*>("clash");
  EXPECT_TRUE(editor.clashing().isEmpty());
  EXPECT_FALSE(clash->isVisible());
  editor.setKeys("line", {QKeySequence("F")});
  EXPECT_EQ(editor.clashing(), (QStringList{"fold", "line"}));
  EXPECT_TRUE(clash->isVisible());
  EXPECT_TRUE(clash->text().contains("Fold line"));
  editor.setKeys("line", {QKeySequence("F, L")});
  EXPECT_EQ(editor.clashing().size(), 2) << "a key that begins another one hides it";
  editor.setKeys("line", own_["line"]);
  EXPECT_TRUE(editor.clashing().isEmpty());
  EXPECT_TRUE(editor.shortcuts().isEmpty()) << "its own keys are no choice";
}

TEST_F(PreferencesDialogTest, SearchFindsByNameAndByKey) {
  ShortcutEditor editor(list_, own_, {});
  auto* list = editor.findChild<QTreeWidget*>();
  const auto shown = [&] {
    QStringList names;
    for (int i = 0; i < list->topLevelItemCount(); ++i)
      if (!list->topLevelItem(i)->isHidden()) names.append(list->topLevelItem(i)->text(0));
    return names;
  };
  auto* search = editor.findChild<QLineEdit*>();
  search->setText("EXPORT");
  EXPECT_EQ(shown(), QStringList{"Export"});
  search->setText("shift+z");
  EXPECT_EQ(shown(), QStringList{"Redo"});
  search->clear();
  EXPECT_EQ(shown().size(), list_.size());
}

TEST_F(PreferencesDialogTest, PresetsHaveNoClashesAndResetGoesBack) {
  ShortcutEditor editor(list_, own_, {{"fold", {QKeySequence("Q")}}});
  for (const KeyPreset preset : {KeyPreset::Oriedita, KeyPreset::Orimath}) {
    editor.usePreset(preset);
    EXPECT_FALSE(editor.shortcuts().isEmpty());
    EXPECT_FALSE(editor.shortcuts().contains("fold")) << "the preset replaces what was chosen";
    EXPECT_TRUE(editor.clashing().isEmpty());
    for (const QString& name : editor.shortcuts().keys()) EXPECT_TRUE(own_.contains(name));
  }
  editor.resetAll();
  EXPECT_TRUE(editor.shortcuts().isEmpty());
}

}  // namespace
}  // namespace kiri::desktop
