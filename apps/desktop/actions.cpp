// Everything that can be done in the window, by name: text, icon, keys.
// SPDX-License-Identifier: MIT
#include "apps/desktop/actions.h"

#include <QActionGroup>
#include <QCoreApplication>
#include <algorithm>

#include "apps/desktop/look/icons.h"
#include "core/base/check.h"

namespace kiri::desktop {
namespace {

const ActionSpec* specOf(const QString& id) {
  for (const ActionSpec& spec : actionTable()) {
    if (id == spec.id) return &spec;
  }
  return nullptr;
}

/// Space belongs to the panes, where it pans while it is held, and to buttons that have the focus:
/// no shortcut takes it from them (PaneInput::tapped).
Qt::ShortcutContext contextOf(const ActionSpec& spec, const QList<QKeySequence>& keys) {
  if (keys.contains(QKeySequence(Qt::Key_Space))) return Qt::WidgetShortcut;
  return spec.scope == KeyScope::Panes ? Qt::WidgetWithChildrenShortcut : Qt::WindowShortcut;
}

}  // namespace

Actions::Actions(QObject* parent) : QObject(parent) {
  auto* tools = new QActionGroup(this);
  const QStringList toolIds = toolActionIds();
  for (const ActionSpec& spec : actionTable()) {
    auto* action = new QAction(this);
    action->setObjectName(spec.id);
    if (spec.icon[0] != '\0') action->setIcon(icon(spec.icon));
    action->setCheckable(spec.isCheckable);
    action->setMenuRole(QAction::NoRole);
    if (toolIds.contains(spec.id)) tools->addAction(action);
    all_.push_back(action);
    byId_.insert(spec.id, action);
  }
  byId_["quit"]->setMenuRole(QAction::QuitRole);
  byId_["about"]->setMenuRole(QAction::AboutRole);
  byId_["preferences"]->setMenuRole(QAction::PreferencesRole);
  setKeys({});
}

QAction& Actions::operator[](const QString& id) const {
  QAction* action = find(id);
  KIRI_CHECK(action != nullptr, "an action is asked for by a name of the table");
  return *action;
}

QAction* Actions::find(const QString& id) const { return byId_.value(id, nullptr); }

KeyScope Actions::scopeOf(const QAction& action) const {
  const ActionSpec* spec = specOf(action.objectName());
  return spec ? spec->scope : KeyScope::Window;
}

QList<QKeySequence> Actions::defaultKeys(const QString& id) const {
  const ActionSpec* spec = specOf(id);
  if (!spec) return {};
  QList<QKeySequence> keys;
  const QString text = spec->keys;
  for (const QString& part : text.split("; ", Qt::SkipEmptyParts)) {
    keys.push_back(QKeySequence::fromString(part, QKeySequence::PortableText));
  }
  return keys;
}

void Actions::setKeys(const QMap<QString, QList<QKeySequence>>& keys) {
  for (QAction* action : all_) {
    const QString id = action->objectName();
    const QList<QKeySequence> own = keys.contains(id) ? keys[id] : defaultKeys(id);
    action->setShortcuts(own);
    action->setShortcutContext(contextOf(*specOf(id), own));
  }
  retranslate();
}

QList<QPair<QString, QString>> Actions::conflicts() const {
  QList<QPair<QString, QString>> found;
  for (qsizetype i = 0; i < all_.size(); ++i) {
    for (qsizetype j = i + 1; j < all_.size(); ++j) {
      const QList<QKeySequence> other = all_[j]->shortcuts();
      const QList<QKeySequence> own = all_[i]->shortcuts();
      if (std::any_of(own.begin(), own.end(),
                      [&](const QKeySequence& key) { return other.contains(key); })) {
        found.push_back({all_[i]->objectName(), all_[j]->objectName()});
      }
    }
  }
  return found;
}

void Actions::retranslate() {
  for (QAction* action : all_) describe(*action, *specOf(action->objectName()));
}

void Actions::describe(QAction& action, const ActionSpec& spec) const {
  const QString text = QCoreApplication::translate("kiri::desktop", spec.text);
  action.setText(text);
  QString name = text;
  name.remove('&').remove("...");
  action.setIconText(name);
  const QString help =
      spec.help[0] == '\0' ? QString() : QCoreApplication::translate("kiri::desktop", spec.help);
  const QString key = action.shortcut().toString(QKeySequence::NativeText);
  QString tip = "<b>" + name.toHtmlEscaped() + "</b>";
  if (!key.isEmpty()) tip += " &nbsp;(" + key.toHtmlEscaped() + ")";
  if (!help.isEmpty()) tip += "<br>" + help.toHtmlEscaped();
  action.setToolTip(tip);
  action.setStatusTip(help);
}

}  // namespace kiri::desktop
