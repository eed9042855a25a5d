// What a person prefers, kept from one start of the program to the next.
// SPDX-License-Identifier: MIT
#pragma once

#include <QByteArray>
#include <QKeySequence>
#include <QMap>
#include <QObject>
#include <QString>
#include <QStringList>
#include <QVariant>
#include <memory>

#include "editor/snap/snap.h"
#include "render/scene/appearance.h"

class QSettings;

namespace kiri::desktop {

enum class ThemeChoice { System, Light, Dark };

/// Everything that the preferences dialog shows. A default-made one holds the defaults.
struct Preferences {
  ThemeChoice theme = ThemeChoice::System;
  LineStyle lineStyle = LineStyle::Thesis;  ///< colours of creases on the screen
  bool hasPerspective = true;
  double fieldOfView = 30;  ///< degrees, of the perspective
  SnapSettings snaps;
  QString language;  ///< "en", "de"; empty: that of the desktop
  bool autosaves = true;
  bool showsStartPage = true;  ///< when the program starts without a file
  bool showsTips = true;       ///< the hints beside the pointer and the tour's offer
};

bool operator==(const Preferences& a, const Preferences& b);
inline bool operator!=(const Preferences& a, const Preferences& b) { return !(a == b); }

/// The preferences on disk, in the person's configuration folder. One object, made in main after
/// the names of application and organisation are set, passed by reference; who shows a preference
/// listens to `preferencesChanged`. Broken or unknown values on disk give the default.
/// QStandardPaths::setTestModeEnabled(true) before its making keeps tests away from the person's
/// own settings.
class Settings final : public QObject {
  Q_OBJECT
 public:
  explicit Settings(QObject* parent = nullptr);
  ~Settings() override;

  const Preferences& preferences() const { return preferences_; }
  void setPreferences(const Preferences& preferences);

  /// Files that were opened or saved, the newest first, without those that are gone.
  QStringList recentFiles() const;
  void addRecentFile(const QString& path);
  void removeRecentFile(const QString& path);
  void clearRecentFiles();
  static constexpr int kMostRecent = 12;
  /// Where the last file dialog of a kind ("model", "picture", "film") ended.
  QString folderFor(const QString& kind) const;
  void setFolderFor(const QString& kind, const QString& folder);

  /// Keys that differ from an action's own, by the name of the action (QAction::objectName). An
  /// entry with an empty list: the action has no key.
  QMap<QString, QList<QKeySequence>> shortcuts() const;
  void setShortcuts(const QMap<QString, QList<QKeySequence>>& shortcuts);

  /// QMainWindow::saveGeometry and saveState, or what other windows keep, by name.
  QByteArray layout(const QString& name) const;
  void setLayout(const QString& name, const QByteArray& bytes);

  /// A single choice that is remembered, such as the last export format.
  QVariant value(const QString& name, const QVariant& otherwise = {}) const;
  void setValue(const QString& name, const QVariant& value);

 signals:
  void preferencesChanged();
  void recentFilesChanged();
  void shortcutsChanged();

 private:
  std::unique_ptr<QSettings> store_;
  Preferences preferences_;
};

/// The folder for journals and reports of crashes: the person's data folder, made when missing.
QString journalFolder();

}  // namespace kiri::desktop
