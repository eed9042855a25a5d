// What a person prefers, kept from one start of the program to the next.
// SPDX-License-Identifier: MIT
#include "apps/desktop/services/settings.h"

#include <QDir>
#include <QFileInfo>
#include <QSettings>
#include <QStandardPaths>
#include <algorithm>
#include <array>
#include <tuple>
#include <utility>

namespace kiri::desktop {

namespace {

/// The words that stand for an enumeration in the file.
template <class T, std::size_t N>
using Words = std::array<std::pair<T, const char*>, N>;

constexpr Words<ThemeChoice, 3> kThemes{
    {{ThemeChoice::System, "system"}, {ThemeChoice::Light, "light"}, {ThemeChoice::Dark, "dark"}}};
constexpr Words<LineStyle, 4> kLineStyles{{{LineStyle::Thesis, "thesis"},
                                           {LineStyle::Diagram, "diagram"},
                                           {LineStyle::Program, "program"},
                                           {LineStyle::Safe, "safe"}}};

/// Reads and writes one value under its name, so that loading and saving are one list of fields.
class Fields {
 public:
  Fields(QSettings& store, bool isSaving) : store_(store), isSaving_(isSaving) {}

  void field(const char* name, bool& value) {
    if (isSaving_) {
      store_.setValue(name, value);
    } else {
      const QString text = store_.value(name, value).toString();
      if (text == "true" || text == "false") value = text == "true";
    }
  }
  void field(const char* name, QString& value) {
    if (isSaving_) {
      store_.setValue(name, value);
    } else {
      value = store_.value(name, value).toString();
    }
  }
  /// Numbers beyond the limits are not taken.
  void field(const char* name, double& value, double least, double most) {
    if (isSaving_) {
      store_.setValue(name, value);
      return;
    }
    bool isNumber = false;
    const double read = store_.value(name, value).toDouble(&isNumber);
    if (isNumber && read >= least && read <= most) value = read;
  }
  void field(const char* name, int& value, int least, int most) {
    double number = value;
    field(name, number, least, most);
    value = static_cast<int>(number);
  }
  template <class T, std::size_t N>
  void field(const char* name, T& value, const Words<T, N>& words) {
    for (const auto& [meant, word] : words) {
      if (isSaving_ && value == meant) store_.setValue(name, QString(word));
      if (!isSaving_ && store_.value(name).toString() == word) value = meant;
    }
  }

 private:
  QSettings& store_;
  bool isSaving_;
};

void exchange(Fields& fields, SnapSettings& snaps) {
  constexpr int kMostDivisions = 64;
  constexpr double kWidestAngle = 90;
  constexpr double kWidestGrid = 1000;
  constexpr double kLargestRadius = 60;
  fields.field("snap/on", snaps.isOn);
  fields.field("snap/vertices", snaps.toVertices);
  fields.field("snap/midpoints", snaps.toMidpoints);
  fields.field("snap/crossings", snaps.toCrossings);
  fields.field("snap/edges", snaps.toEdges);
  fields.field("snap/divisions", snaps.divisions, 0, kMostDivisions);
  fields.field("snap/angleStep", snaps.angleStep, 0, kWidestAngle);
  fields.field("snap/gridSpacing", snaps.gridSpacing, 0, kWidestGrid);
  fields.field("snap/radius", snaps.radius, 2, kLargestRadius);
}

void exchange(Fields& fields, Preferences& preferences) {
  constexpr double kWidestView = 120;
  fields.field("look/theme", preferences.theme, kThemes);
  fields.field("look/creases", preferences.lineStyle, kLineStyles);
  fields.field("view/perspective", preferences.hasPerspective);
  fields.field("view/fieldOfView", preferences.fieldOfView, 5, kWidestView);
  exchange(fields, preferences.snaps);
  fields.field("language", preferences.language);
  fields.field("autosave", preferences.autosaves);
  fields.field("startPage", preferences.showsStartPage);
  fields.field("tips", preferences.showsTips);
}

constexpr const char* kRecent = "recentFiles";
constexpr const char* kShortcuts = "shortcuts";

auto tied(const SnapSettings& s) {
  return std::tie(s.isOn, s.toVertices, s.toMidpoints, s.toCrossings, s.toEdges, s.divisions,
                  s.angleStep, s.gridSpacing, s.radius);
}
auto tied(const Preferences& p) {
  return std::tie(p.theme, p.lineStyle, p.hasPerspective, p.fieldOfView, p.language, p.autosaves,
                  p.showsStartPage, p.showsTips);
}

}  // namespace

bool operator==(const Preferences& a, const Preferences& b) {
  return tied(a) == tied(b) && tied(a.snaps) == tied(b.snaps);
}

Settings::Settings(QObject* parent) : QObject(parent) {
  // The test mode of QStandardPaths moves this folder, which QSettings' own choice would not.
  const QString folder = QStandardPaths::writableLocation(QStandardPaths::AppConfigLocation);
  QDir().mkpath(folder);
  store_ = std::make_unique<QSettings>(folder + "/kirisim.ini", QSettings::IniFormat);
  Fields fields(*store_, false);
  exchange(fields, preferences_);
}

Settings::~Settings() = default;

void Settings::setPreferences(const Preferences& preferences) {
  if (preferences == preferences_) return;
  preferences_ = preferences;
  Fields fields(*store_, true);
  exchange(fields, preferences_);
  emit preferencesChanged();
}

QStringList Settings::recentFiles() const {
  QStringList files = store_->value(kRecent).toStringList();
  files.removeIf([](const QString& path) { return !QFileInfo(path).isFile(); });
  return files;
}

void Settings::addRecentFile(const QString& path) {
  const QString full = QFileInfo(path).absoluteFilePath();
  QStringList files = recentFiles();
  files.removeAll(full);
  files.prepend(full);
  if (files.size() > kMostRecent) files.resize(kMostRecent);
  store_->setValue(kRecent, files);
  emit recentFilesChanged();
}

void Settings::removeRecentFile(const QString& path) {
  QStringList files = recentFiles();
  files.removeAll(path);
  store_->setValue(kRecent, files);
  emit recentFilesChanged();
}

void Settings::clearRecentFiles() {
  store_->remove(kRecent);
  emit recentFilesChanged();
}

QString Settings::folderFor(const QString& kind) const {
  QString kept = store_->value("folders/" + kind).toString();
  if (QFileInfo(kept).isDir()) return kept;
  const QString documents = QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation);
  return QFileInfo(documents).isDir() ? documents : QDir::homePath();
}

void Settings::setFolderFor(const QString& kind, const QString& folder) {
  store_->setValue("folders/" + kind, folder);
}

QMap<QString, QList<QKeySequence>> Settings::shortcuts() const {
  QMap<QString, QList<QKeySequence>> all;
  store_->beginGroup(kShortcuts);
  for (const QString& action : store_->childKeys()) {
    QList<QKeySequence> keys;
    for (const QString& text : store_->value(action).toStringList()) {
      const QKeySequence key(text, QKeySequence::PortableText);
      if (!key.isEmpty()) keys.append(key);
    }
    all.insert(action, keys);
  }
  store_->endGroup();
  return all;
}

void Settings::setShortcuts(const QMap<QString, QList<QKeySequence>>& shortcuts) {
  store_->remove(kShortcuts);
  store_->beginGroup(kShortcuts);
  for (auto entry = shortcuts.begin(); entry != shortcuts.end(); ++entry) {
    QStringList texts;
    for (const QKeySequence& key : entry.value())
      texts.append(key.toString(QKeySequence::PortableText));
    store_->setValue(entry.key(), texts);
  }
  store_->endGroup();
  emit shortcutsChanged();
}

QByteArray Settings::layout(const QString& name) const {
  return store_->value("layout/" + name).toByteArray();
}

void Settings::setLayout(const QString& name, const QByteArray& bytes) {
  store_->setValue("layout/" + name, bytes);
}

QVariant Settings::value(const QString& name, const QVariant& otherwise) const {
  return store_->value("choices/" + name, otherwise);
}

void Settings::setValue(const QString& name, const QVariant& value) {
  store_->setValue("choices/" + name, value);
}

QString journalFolder() {
  QString folder = QStandardPaths::writableLocation(QStandardPaths::AppDataLocation) + "/journals";
  QDir().mkpath(folder);
  return folder;
}

}  // namespace kiri::desktop
