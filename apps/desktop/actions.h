// Everything that can be done in the window, by name: text, icon, keys.
// SPDX-License-Identifier: MIT
#pragma once

#include <QAction>
#include <QKeySequence>
#include <QList>
#include <QMap>
#include <QObject>
#include <QString>
#include <QStringList>
#include <vector>

namespace kiri::desktop {

/// Where an action's keys work.
enum class KeyScope {
  Window,  ///< everywhere in the window
  Panes,   ///< in the panes and the bar above them only: Enter and Esc mean other things elsewhere
};

struct ActionSpec {
  const char* id;    ///< also QAction::objectName, in settings and scripts
  const char* text;  ///< with the ampersand of menus; translated
  const char* icon;  ///< name of a drawing, or empty
  const char* keys;  ///< portable, with "; " between: "Ctrl+Y; Ctrl+Shift+Z"
  const char* help;  ///< a sentence for tooltip and status bar; may be empty
  bool isCheckable = false;
  KeyScope scope = KeyScope::Window;
};

/// The table of all actions, in the order of the menus.
const std::vector<ActionSpec>& actionTable();

/// Makes every action once. Menus, tool bars and the shortcut editor take them from here; nobody
/// else makes actions with keys.
class Actions final : public QObject {
  Q_OBJECT
 public:
  explicit Actions(QObject* parent = nullptr);

  /// The action of that name; a defect when there is none.
  QAction& operator[](const QString& id) const;
  QAction* find(const QString& id) const;
  const QList<QAction*>& all() const { return all_; }
  KeyScope scopeOf(const QAction& action) const;

  QList<QKeySequence> defaultKeys(const QString& id) const;
  /// Keys that differ from the defaults, by name; all others get their defaults.
  void setKeys(const QMap<QString, QList<QKeySequence>>& keys);
  /// Pairs of actions that answer to the same key in the same place.
  QList<QPair<QString, QString>> conflicts() const;
  /// Texts and tooltips again, after a change of language.
  void retranslate();

 private:
  void describe(QAction& action, const ActionSpec& spec) const;

  QList<QAction*> all_;
  QMap<QString, QAction*> byId_;
};

/// The name of the action that takes up a tool: "fold", "add-edge"...
QStringList toolActionIds();

}  // namespace kiri::desktop
