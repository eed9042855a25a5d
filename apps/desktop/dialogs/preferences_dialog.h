// What a person prefers, on three pages.
// SPDX-License-Identifier: MIT
#pragma once

#include <QAction>
#include <QCheckBox>
#include <QComboBox>
#include <QDialog>
#include <QDoubleSpinBox>
#include <QSpinBox>
#include <QTabWidget>

#include "apps/desktop/dialogs/shortcut_editor.h"
#include "apps/desktop/services/settings.h"

namespace kiri::desktop {

/// Changes are seen at once where they can be; Cancel takes them back. `actions`: those of the
/// window that may have keys (objectName, text and icon are shown); `ownKeys`: their defaults.
///
///   PreferencesDialog dialog(settings, actions.all(), defaults, this);
///   dialog.exec();      // settings.preferencesChanged() and shortcutsChanged() tell the rest
class PreferencesDialog final : public QDialog {
  Q_OBJECT
 public:
  PreferencesDialog(Settings& settings, const QList<QAction*>& actions,
                    const QMap<QString, Keys>& ownKeys, QWidget* parent = nullptr);

  /// What the boxes say.
  Preferences preferences() const;
  /// Opens the page with the keys.
  void showShortcuts();

  void accept() override;
  void reject() override;

 private:
  QWidget* makeLookPage();
  QWidget* makeHandPage();
  void show(const Preferences& preferences);
  void apply();
  void addLanguages();

  Settings& settings_;
  Preferences before_;
  bool isShowing_ = false;
  QTabWidget* pages_ = nullptr;
  QComboBox* theme_ = nullptr;
  QComboBox* lines_ = nullptr;
  QComboBox* language_ = nullptr;
  QCheckBox* perspective_ = nullptr;
  QDoubleSpinBox* field_ = nullptr;
  QCheckBox* startPage_ = nullptr;
  QCheckBox* tips_ = nullptr;
  QCheckBox* autosave_ = nullptr;
  QCheckBox* snap_ = nullptr;
  QCheckBox* vertices_ = nullptr;
  QCheckBox* midpoints_ = nullptr;
  QCheckBox* crossings_ = nullptr;
  QCheckBox* edges_ = nullptr;
  QSpinBox* divisions_ = nullptr;
  QDoubleSpinBox* angle_ = nullptr;
  QDoubleSpinBox* grid_ = nullptr;
  QDoubleSpinBox* radius_ = nullptr;
  ShortcutEditor* shortcuts_ = nullptr;
};

}  // namespace kiri::desktop
