// Widgets for a list of fields: of the tool at work, or of a step that is done.
// SPDX-License-Identifier: MIT
#include "apps/desktop/panels/field_editor.h"

#include <QButtonGroup>
#include <QCheckBox>
#include <QComboBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QScopedValueRollback>
#include <QToolButton>
#include <algorithm>
#include <cmath>

#include "apps/desktop/look/convert.h"
#include "apps/desktop/panels/notes_box.h"
#include "apps/desktop/panels/unit_box.h"

namespace kiri::desktop {
namespace {

constexpr int kTextWidth = 110;
constexpr int kSpacing = 6;               // between a name and its box
constexpr int kBetween = 20;              // between one field and the next
constexpr std::size_t kMostSegments = 3;  // more options are a list that drops down

bool isOfTheSameMake(const Field& a, const Field& b) {
  return a.id == b.id && a.kind == b.kind && a.unit == b.unit && a.options == b.options &&
         a.label == b.label && a.hasLines == b.hasLines;
}

}  // namespace

FieldEditor::FieldEditor(Layout layout, QWidget* parent) : QWidget(parent), layout_(layout) {
  auto* outer = new QHBoxLayout(this);
  outer->setContentsMargins(0, 0, 0, 0);
}

bool FieldEditor::fits(const std::vector<Field>& fields) const {
  return fields.size() == fields_.size() &&
         std::equal(fields.begin(), fields.end(), fields_.begin(), isOfTheSameMake);
}

void FieldEditor::show(const std::vector<Field>& fields) {
  const QScopedValueRollback<bool> updating(isUpdating_, true);
  if (!fits(fields)) rebuild(fields);
  fields_ = fields;
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    rows_[i].widget->setEnabled(fields[i].isEnabled);
    rows_[i].update(fields[i]);
  }
}

void FieldEditor::rebuild(const std::vector<Field>& fields) {
  rows_.clear();
  if (inside_) {
    // An edit of one of these widgets may have brought us here.
    inside_->hide();
    layout()->removeWidget(inside_);
    inside_->deleteLater();
  }
  inside_ = new QWidget(this);
  if (layout_ == Layout::Row) {
    auto* row = new QHBoxLayout(inside_);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(kSpacing);
  } else {
    auto* form = new QFormLayout(inside_);
    form->setContentsMargins(0, 0, 0, 0);
    form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
    form->setLabelAlignment(Qt::AlignLeft | Qt::AlignVCenter);
    form->setVerticalSpacing(7);
  }
  for (const Field& field : fields) add(field);
  if (auto* row = qobject_cast<QHBoxLayout*>(inside_->layout())) row->addStretch(1);
  layout()->addWidget(inside_);
}

void FieldEditor::add(const Field& field) {
  Row row;
  switch (field.kind) {
    case Field::Kind::Number:
      row = makeNumber(field);
      break;
    case Field::Kind::Choice: {
      const bool isShort = layout_ == Layout::Row && field.options.size() <= kMostSegments;
      row = isShort ? makeSegments(field) : makeChoice(field);
      break;
    }
    case Field::Kind::Switch:
      row = makeSwitch(field);
      break;
    case Field::Kind::Text:
      row = field.hasLines ? makeNotes(field) : makeText(field);
      break;
    case Field::Kind::Button:
      row = makeButton(field);
      break;
  }
  row.id = field.id;
  const QString label = said(field.label);
  row.widget->setObjectName("field-" + toQt(field.id));
  row.widget->setAccessibleName(label);
  row.widget->setToolTip(said(field.help));
  const bool saysItself = field.kind == Field::Kind::Switch || field.kind == Field::Kind::Button;
  if (auto* form = qobject_cast<QFormLayout*>(inside_->layout())) {
    form->addRow(saysItself ? QString() : label, row.widget);
  } else {
    auto* line = static_cast<QHBoxLayout*>(inside_->layout());
    if (!line->isEmpty()) line->addSpacing(kBetween - 2 * kSpacing);
    if (!saysItself && !label.isEmpty()) {
      auto* name = new QLabel(label, inside_);
      name->setProperty("faint", true);
      name->setBuddy(row.widget);
      row.label = name;
      line->addWidget(name);
    }
    line->addWidget(row.widget);
  }
  rows_.push_back(std::move(row));
}

FieldEditor::Row FieldEditor::makeNumber(const Field& field) {
  auto* box = new UnitBox(inside_);
  box->setUnit(toQt(field.unit));
  box->setKeyboardTracking(layout_ == Layout::Row);
  box->setMinimumWidth(76);
  connect(box, &QDoubleSpinBox::valueChanged, this,
          [this, id = field.id](double value) { tell(id, value); });
  const auto update = [box](const Field& now) {
    const bool isFree = now.least >= now.most;  // no limits were given
    box->setRange(isFree ? -1'000'000 : now.least, isFree ? 1'000'000 : now.most);
    box->setSingleStep(now.step > 0 ? now.step : 1);
    // What is being typed is not taken out of the person's hands.
    const bool isTyping = box->hasFocus() && std::abs(box->value() - now.value) < 0.001;
    if (!isTyping) box->setValue(now.value);
  };
  return {{}, box, nullptr, update};
}

FieldEditor::Row FieldEditor::makeChoice(const Field& field) {
  auto* box = new QComboBox(inside_);
  // A long option must not make the panel wider than it is.
  box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  box->setMinimumContentsLength(layout_ == Layout::Row ? 9 : 6);
  for (const Phrase& option : field.options) box->addItem(said(option));
  connect(box, &QComboBox::currentIndexChanged, this,
          [this, id = field.id](int index) { tell(id, index); });
  return {{}, box, nullptr, [box](const Field& now) {
            box->setCurrentIndex(static_cast<int>(std::lround(now.value)));
          }};
}

/// A row of buttons of which one is down.
FieldEditor::Row FieldEditor::makeSegments(const Field& field) {
  auto* row = new QWidget(inside_);
  auto* line = new QHBoxLayout(row);
  line->setContentsMargins(0, 0, 0, 0);
  line->setSpacing(0);
  auto* group = new QButtonGroup(row);
  for (std::size_t i = 0; i < field.options.size(); ++i) {
    auto* button = new QToolButton(row);
    button->setText(said(field.options[i]));
    button->setCheckable(true);
    button->setProperty("segment", true);
    button->setFocusPolicy(Qt::TabFocus);
    button->setAccessibleName(said(field.label) + ": " + button->text());
    group->addButton(button, static_cast<int>(i));
    line->addWidget(button);
  }
  connect(group, &QButtonGroup::idClicked, this,
          [this, id = field.id](int index) { tell(id, index); });
  return {{}, row, nullptr, [group](const Field& now) {
            if (QAbstractButton* button = group->button(static_cast<int>(std::lround(now.value)))) {
              button->setChecked(true);
            }
          }};
}

FieldEditor::Row FieldEditor::makeSwitch(const Field& field) {
  auto* box = new QCheckBox(said(field.label), inside_);
  connect(box, &QCheckBox::toggled, this,
          [this, id = field.id](bool isOn) { tell(id, isOn ? 1 : 0); });
  return {{}, box, nullptr, [box](const Field& now) { box->setChecked(now.value > 0.5); }};
}

FieldEditor::Row FieldEditor::makeText(const Field& field) {
  auto* line = new QLineEdit(inside_);
  if (layout_ == Layout::Row) line->setFixedWidth(kTextWidth);
  const auto changed = [this, line, id = field.id] { tell(id, 0, line->text()); };
  if (layout_ == Layout::Row) {
    connect(line, &QLineEdit::textEdited, this, changed);
  } else {
    connect(line, &QLineEdit::editingFinished, this, [line, changed] {
      if (line->isModified()) changed();
      line->setModified(false);
    });
  }
  return {{}, line, nullptr, [line](const Field& now) {
            const QString text = toQt(now.text);
            if (line->text() != text && !(line->hasFocus() && line->isModified())) {
              line->setText(text);
            }
          }};
}

FieldEditor::Row FieldEditor::makeNotes(const Field& field) {
  auto* box = new NotesBox(inside_);
  connect(box, &NotesBox::edited, this,
          [this, id = field.id](const QString& text) { tell(id, 0, text); });
  return {{}, box, nullptr, [box](const Field& now) { box->show(toQt(now.text)); }};
}

FieldEditor::Row FieldEditor::makeButton(const Field& field) {
  auto* button = new QPushButton(said(field.label), inside_);
  button->setFocusPolicy(Qt::TabFocus);
  connect(button, &QPushButton::clicked, this, [this, id = field.id] { tell(id, 1); });
  return {{}, button, nullptr, [](const Field&) {}};
}

void FieldEditor::tell(const std::string& id, double number, const QString& text) {
  if (isUpdating_) return;
  emit edited(toQt(id), FieldValue{number, text.toStdString()});
}

QWidget* FieldEditor::widgetOf(const std::string& id) const {
  for (const Row& row : rows_) {
    if (row.id == id) return row.widget;
  }
  return nullptr;
}

std::size_t FieldEditor::fitInto(int width) {
  std::size_t shown = 0;
  int used = 0;
  for (const Row& row : rows_) {
    used += row.widget->sizeHint().width() + kBetween;
    if (row.label) used += row.label->sizeHint().width() + kSpacing;
    const bool fits = shown == static_cast<std::size_t>(&row - rows_.data()) && used <= width;
    row.widget->setVisible(fits);
    if (row.label) row.label->setVisible(fits);
    shown += fits ? 1 : 0;
  }
  return shown;
}

bool FieldEditor::focusFirst() {
  for (const Row& row : rows_) {
    auto* box = qobject_cast<UnitBox*>(row.widget);
    if (!box || !box->isEnabled()) continue;
    box->setFocus(Qt::TabFocusReason);
    box->selectAll();
    return true;
  }
  return false;
}

}  // namespace kiri::desktop
