// Preferences on disk.
// SPDX-License-Identifier: MIT
#include "apps/desktop/services/settings.h"

#include <gtest/gtest.h>

#include <QDir>
#include <QFile>
#include <QSettings>
#include <QSignalSpy>
#include <QStandardPaths>
#include <QTemporaryDir>

namespace kiri::desktop {
namespace {

QString fileOfSettings() {
  return QStandardPaths::writableLocation(QStandardPaths::AppConfigLocation) + "/kirisim.ini";
}

class SettingsTest : public ::testing::Test {
 protected:
  void SetUp() override { QFile::remove(fileOfSettings()); }
  void TearDown() override { QFile::remove(fileOfSettings()); }
};

Preferences allChanged() {
  Preferences p;
  p.theme = ThemeChoice::Dark;
  p.lineStyle = LineStyle::Safe;
  p.hasPerspective = !p.hasPerspective;
  p.fieldOfView = 45;
  p.snaps = {false, false, false, false, false, 5, 22.5, 12.5, 14};
  p.language = "de";
  p.autosaves = !p.autosaves;
  p.showsStartPage = !p.showsStartPage;
  p.showsTips = !p.showsTips;
  return p;
}

TEST_F(SettingsTest, TestsDoNotTouchTheSettingsOfThePerson) {
  EXPECT_TRUE(fileOfSettings().contains("qttest"));
  EXPECT_TRUE(journalFolder().contains("qttest"));
  EXPECT_TRUE(QDir(journalFolder()).exists());
}

TEST_F(SettingsTest, AreTheDefaultsAtFirst) {
  const Settings settings;
  EXPECT_EQ(settings.preferences(), Preferences{});
  EXPECT_TRUE(settings.recentFiles().isEmpty());
  EXPECT_TRUE(settings.shortcuts().isEmpty());
}

TEST_F(SettingsTest, EveryPreferenceOutlivesTheProgram) {
  {
    Settings settings;
    QSignalSpy changes(&settings, &Settings::preferencesChanged);
    settings.setPreferences(allChanged());
    settings.setPreferences(allChanged());
    EXPECT_EQ(changes.count(), 1) << "the same again is no change";
  }
  const Settings settings;
  EXPECT_EQ(settings.preferences(), allChanged());
}

TEST_F(SettingsTest, NonsenseOnDiskGivesTheDefaults) {
  {
    QSettings store(fileOfSettings(), QSettings::IniFormat);
    store.setValue("look/theme", "purple");
    store.setValue("look/creases", 7);
    store.setValue("view/fieldOfView", "wide");
    store.setValue("snap/divisions", -3);
    store.setValue("snap/radius", 1e9);
    store.setValue("snap/gridSpacing", "nan");
    store.setValue("autosave", "perhaps");
  }
  const Settings settings;
  EXPECT_EQ(settings.preferences(), Preferences{});
}

TEST_F(SettingsTest, RecentFilesAreTheNewestFirstOnceEachAndOnlyThoseThatAreThere) {
  QTemporaryDir folder;
  Settings settings;
  for (int i = 0; i < 15; ++i) {
    const QString path = folder.filePath(QString("%1.kiri").arg(i));
    QFile file(path);
    ASSERT_TRUE(file.open(QIODevice::WriteOnly));
    settings.addRecentFile(path);
  }
  settings.addRecentFile(folder.filePath("13.kiri"));
  QStringList files = settings.recentFiles();
  ASSERT_EQ(files.size(), Settings::kMostRecent);
  EXPECT_EQ(files[0], folder.filePath("13.kiri"));
  EXPECT_EQ(files[1], folder.filePath("14.kiri"));
  EXPECT_EQ(files.count(folder.filePath("13.kiri")), 1);
  QFile::remove(folder.filePath("14.kiri"));
  EXPECT_EQ(settings.recentFiles()[1], folder.filePath("12.kiri"));
  settings.removeRecentFile(folder.filePath("12.kiri"));
  EXPECT_FALSE(settings.recentFiles().contains(folder.filePath("12.kiri")));
  settings.clearRecentFiles();
  EXPECT_TRUE(Settings().recentFiles().isEmpty());
}

TEST_F(SettingsTest, ShortcutsKeepSeveralKeysAndNone) {
  const QMap<QString, QList<QKeySequence>> keys{
      {"redo", {QKeySequence("Ctrl+Y"), QKeySequence("Ctrl+Shift+Z")}},
      {"tool.fold", {QKeySequence("F")}},
      {"view.comma", {QKeySequence("Ctrl+,")}},
      {"help", {}}};
  {
    Settings settings;
    settings.setShortcuts({{"old", {QKeySequence("O")}}});
    settings.setShortcuts(keys);
  }
  EXPECT_EQ(Settings().shortcuts(), keys);
}

TEST_F(SettingsTest, LayoutsAndChoicesAreKeptByName) {
  const QByteArray bytes("\0\1\2state", 8);
  {
    Settings settings;
    settings.setLayout("window", bytes);
    settings.setValue("export/format", "pdf");
  }
  const Settings settings;
  EXPECT_EQ(settings.layout("window"), bytes);
  EXPECT_TRUE(settings.layout("other").isEmpty());
  EXPECT_EQ(settings.value("export/format").toString(), "pdf");
  EXPECT_EQ(settings.value("missing", 5).toInt(), 5);
}

TEST_F(SettingsTest, AFolderThatIsGoneIsNotOffered) {
  Settings settings;
  QString gone;
  {
    QTemporaryDir folder;
    gone = folder.path();
    settings.setFolderFor("model", gone);
    EXPECT_EQ(settings.folderFor("model"), gone);
  }
  EXPECT_NE(settings.folderFor("model"), gone);
  EXPECT_TRUE(QDir(settings.folderFor("model")).exists());
}

}  // namespace
}  // namespace kiri::desktop
