// The keys of all actions.
// SPDX-License-Identifier: MIT
#include "apps/desktop/dialogs/shortcut_editor.h"

#include <QHBoxLayout>
#include <QHeaderView>
#include <QVBoxLayout>
#include <algorithm>

#include "apps/desktop/dialogs/form.h"
#include "apps/desktop/look/theme.h"

namespace kiri::desktop {

namespace {

/// The text of an action as it stands in lists: without & and dots.
QString nameOf(const QAction& action) {
  QString text = action.text();
  text.remove('&');
  while (text.endsWith('.') || text.endsWith("…")) text.chop(1);
  return text;
}

QString textOf(const Keys& keys) {
  return QKeySequence::listToString(keys, QKeySequence::NativeText).replace("; ", ",  ");
}

}  // namespace

ShortcutEditor::ShortcutEditor(const QList<QAction*>& actions, const QMap<QString, Keys>& own,
                               const QMap<QString, Keys>& chosen, QWidget* parent)
    : QWidget(parent), own_(own), chosen_(chosen) {
  for (QAction* action : actions) {
    if (!action->objectName().isEmpty() && !action->isSeparator()) actions_.append(action);
  }
  search_ = new QLineEdit;
  search_->setPlaceholderText(tr("Search actions and keys"));
  search_->setClearButtonEnabled(true);
  preset_ = choiceBox({{tr("KiriSim"), static_cast<int>(KeyPreset::KiriSim)},
                       {tr("Oriedita"), static_cast<int>(KeyPreset::Oriedita)},
                       {tr("Orimath"), static_cast<int>(KeyPreset::Orimath)}},
                      static_cast<int>(KeyPreset::KiriSim));
  preset_->setToolTip(tr("Keys as in another program"));
  list_ = new QTreeWidget;
  list_->setHeaderLabels({tr("Action"), tr("Keys")});
  list_->setRootIsDecorated(false);
  list_->setUniformRowHeights(true);
  list_->setAlternatingRowColors(true);
  list_->header()->setSectionResizeMode(0, QHeaderView::Stretch);
  list_->header()->setSectionResizeMode(1, QHeaderView::ResizeToContents);
  list_->header()->setStretchLastSection(false);
  clash_ = new QLabel;
  clash_->setWordWrap(true);
  clash_->setObjectName("clash");

  auto* upper = new QHBoxLayout;
  upper->addWidget(search_, 1);
  upper->addWidget(new QLabel(tr("Keys as in")));
  upper->addWidget(preset_);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(16, 16, 16, 16);
  layout->addLayout(upper);
  layout->addWidget(list_, 1);
  layout->addLayout(makeEditRow());
  layout->addWidget(clash_);

  connect(search_, &QLineEdit::textChanged, this, &ShortcutEditor::filter);
  connect(preset_, &QComboBox::activated, this,
          [this] { usePreset(static_cast<KeyPreset>(chosenIn(*preset_))); });
  connect(list_, &QTreeWidget::currentItemChanged, this, &ShortcutEditor::showCurrent);
  fill();
  showKeys();
  if (list_->topLevelItemCount() > 0) list_->setCurrentItem(list_->topLevelItem(0));
}

// A box that loses the focus as it goes says that its editing is finished.
ShortcutEditor::~ShortcutEditor() { press_->disconnect(this); }

QLayout* ShortcutEditor::makeEditRow() {
  editing_ = new QLabel;
  press_ = new QKeySequenceEdit;
  press_->setClearButtonEnabled(true);
  press_->setToolTip(tr("Click here and press the keys"));
  none_ = new QPushButton(tr("No key"));
  reset_ = new QPushButton(tr("Reset"));
  auto* row = new QHBoxLayout;
  row->addWidget(editing_, 1);
  row->addWidget(press_);
  row->addWidget(none_);
  row->addWidget(reset_);
  connect(press_, &QKeySequenceEdit::editingFinished, this, &ShortcutEditor::takePressed);
  connect(none_, &QPushButton::clicked, this, [this] {
    if (const QAction* action = current()) setKeys(action->objectName(), {});
  });
  connect(reset_, &QPushButton::clicked, this, [this] {
    if (const QAction* action = current())
      setKeys(action->objectName(), own_.value(action->objectName()));
  });
  return row;
}

QAction* ShortcutEditor::actionNamed(const QString& name) const {
  const auto found = std::find_if(actions_.begin(), actions_.end(),
                                  [&](const QAction* a) { return a->objectName() == name; });
  return found == actions_.end() ? nullptr : *found;
}

QAction* ShortcutEditor::current() const {
  const QTreeWidgetItem* item = list_->currentItem();
  return item ? actionNamed(item->data(0, Qt::UserRole).toString()) : nullptr;
}

Keys ShortcutEditor::keysOf(const QAction& action) const {
  return chosen_.value(action.objectName(), own_.value(action.objectName()));
}

QMap<QString, Keys> ShortcutEditor::allKeys() const {
  QMap<QString, Keys> all;
  for (const QAction* action : actions_) all.insert(action->objectName(), keysOf(*action));
  return all;
}

QStringList ShortcutEditor::clashing() const { return clashesIn(allKeys()).keys(); }

void ShortcutEditor::fill() {
  for (const QAction* action : actions_) {
    auto* item = new QTreeWidgetItem(list_);
    item->setText(0, nameOf(*action));
    item->setIcon(0, action->icon());
    item->setData(0, Qt::UserRole, action->objectName());
    item->setToolTip(0, action->toolTip());
  }
}

void ShortcutEditor::showKeys() {
  const QMap<QString, QStringList> clashes = clashesIn(allKeys());
  QStringList sentences;
  for (int i = 0; i < list_->topLevelItemCount(); ++i) {
    QTreeWidgetItem* item = list_->topLevelItem(i);
    const QString name = item->data(0, Qt::UserRole).toString();
    const QAction* action = actionNamed(name);
    item->setText(1, textOf(keysOf(*action)));
    const bool isClashing = clashes.contains(name);
    QFont font = list_->font();
    font.setBold(chosen_.contains(name));
    item->setFont(1, font);
    // Without a colour of its own it follows the theme.
    item->setData(1, Qt::ForegroundRole, isClashing ? QVariant(QBrush(theme().fault)) : QVariant());
    if (!isClashing || name > clashes[name].first()) continue;
    sentences.append(tr("%1 has the same keys as %2.")
                         .arg(nameOf(*action), nameOf(*actionNamed(clashes[name].first()))));
  }
  clash_->setText(sentences.join(" "));
  clash_->setVisible(!sentences.isEmpty());
  clash_->setStyleSheet(QString("color: %1;").arg(theme().fault.name()));
  showCurrent();
}

void ShortcutEditor::showCurrent() {
  const QAction* action = current();
  for (QWidget* widget :
       {static_cast<QWidget*>(press_), static_cast<QWidget*>(none_), static_cast<QWidget*>(reset_)})
    widget->setEnabled(action != nullptr);
  if (!action) return;
  const Keys keys = keysOf(*action);
  editing_->setText(tr("Keys of “%1”").arg(nameOf(*action)));
  press_->setKeySequence(keys.isEmpty() ? QKeySequence() : keys.first());
  reset_->setEnabled(chosen_.contains(action->objectName()));
}

void ShortcutEditor::takePressed() {
  const QAction* action = current();
  if (!action) return;
  const QKeySequence pressed = press_->keySequence();
  Keys keys = keysOf(*action);
  if (pressed.isEmpty()) {
    keys.clear();
  } else if (keys.isEmpty()) {
    keys.append(pressed);
  } else {
    keys.removeAll(pressed);
    keys.isEmpty() ? keys.append(pressed) : keys.replace(0, pressed);
  }
  setKeys(action->objectName(), keys);
}

void ShortcutEditor::setKeys(const QString& name, const Keys& keys) {
  const QAction* action = actionNamed(name);
  if (!action) return;
  if (keys == own_.value(action->objectName())) {
    chosen_.remove(name);
  } else {
    chosen_.insert(name, keys);
  }
  showKeys();
}

void ShortcutEditor::resetAll() {
  chosen_.clear();
  choose(*preset_, static_cast<int>(KeyPreset::KiriSim));
  showKeys();
}

void ShortcutEditor::usePreset(KeyPreset preset) {
  chosen_ = keysOfPreset(preset);
  chosen_.removeIf([this](const auto& entry) { return actionNamed(entry.key()) == nullptr; });
  choose(*preset_, static_cast<int>(preset));
  showKeys();
}

void ShortcutEditor::filter(const QString& words) {
  for (int i = 0; i < list_->topLevelItemCount(); ++i) {
    QTreeWidgetItem* item = list_->topLevelItem(i);
    item->setHidden(!item->text(0).contains(words, Qt::CaseInsensitive) &&
                    !item->text(1).contains(words, Qt::CaseInsensitive));
  }
}

}  // namespace kiri::desktop
