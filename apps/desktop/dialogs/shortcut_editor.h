// The keys of all actions: search, press, see what clashes, reset.
// SPDX-License-Identifier: MIT
#pragma once

#include <QAction>
#include <QComboBox>
#include <QKeySequenceEdit>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTreeWidget>
#include <QWidget>

#include "apps/desktop/services/key_map.h"

namespace kiri::desktop {

/// A page of the preferences. Nothing is changed by it: who shows it reads `shortcuts()` in the
/// end.
class ShortcutEditor final : public QWidget {
  Q_OBJECT
 public:
  /// `own`: the keys that the actions have without a choice, by name.
  ShortcutEditor(const QList<QAction*>& actions, const QMap<QString, Keys>& own,
                 const QMap<QString, Keys>& chosen, QWidget* parent = nullptr);
  ~ShortcutEditor() override;

  /// What differs from the actions' own keys.
  const QMap<QString, Keys>& shortcuts() const { return chosen_; }
  void setKeys(const QString& action, const Keys& keys);
  void resetAll();
  void usePreset(KeyPreset preset);
  /// Names of actions whose keys clash with others.
  QStringList clashing() const;

 private:
  QLayout* makeEditRow();
  QMap<QString, Keys> allKeys() const;
  Keys keysOf(const QAction& action) const;
  QAction* actionNamed(const QString& name) const;
  QAction* current() const;
  void fill();
  void showKeys();
  void showCurrent();
  void filter(const QString& words);
  void takePressed();

  QList<QAction*> actions_;
  QMap<QString, Keys> own_;
  QMap<QString, Keys> chosen_;
  QLineEdit* search_ = nullptr;
  QComboBox* preset_ = nullptr;
  QTreeWidget* list_ = nullptr;
  QLabel* editing_ = nullptr;
  QKeySequenceEdit* press_ = nullptr;
  QPushButton* none_ = nullptr;
  QPushButton* reset_ = nullptr;
  QLabel* clash_ = nullptr;
};

}  // namespace kiri::desktop
