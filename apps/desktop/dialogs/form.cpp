// Small parts that all dialogs are made of.
// SPDX-License-Identifier: MIT
#include "apps/desktop/dialogs/form.h"

#include <QAbstractButton>
#include <QFont>

namespace kiri::desktop {

QDoubleSpinBox* numberBox(double value, double least, double most, const QString& unit,
                          int decimals, double step) {
  auto* box = new QDoubleSpinBox;
  box->setDecimals(decimals);
  box->setRange(least, most);
  box->setSingleStep(step);
  box->setSuffix(unit);
  box->setValue(value);
  box->setMinimumWidth(110);
  return box;
}

QComboBox* choiceBox(const QList<QPair<QString, int>>& choices, int chosen) {
  auto* box = new QComboBox;
  for (const auto& [text, number] : choices) box->addItem(text, number);
  choose(*box, chosen);
  return box;
}

int chosenIn(const QComboBox& box) { return box.currentData().toInt(); }

void choose(QComboBox& box, int choice) {
  const int index = box.findData(choice);
  if (index >= 0) box.setCurrentIndex(index);
}

QLabel* headline(const QString& text) {
  auto* label = new QLabel(text);
  QFont font = label->font();
  font.setPointSizeF(font.pointSizeF() * 1.25);
  font.setBold(true);
  label->setFont(font);
  return label;
}

QLabel* remark(const QString& text) {
  auto* label = new QLabel(text);
  label->setWordWrap(true);
  label->setForegroundRole(QPalette::PlaceholderText);
  return label;
}

QFormLayout* formLayout() {
  auto* form = new QFormLayout;
  form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
  form->setLabelAlignment(Qt::AlignLeft | Qt::AlignVCenter);
  form->setHorizontalSpacing(16);
  form->setVerticalSpacing(8);
  return form;
}

void setRowVisible(QFormLayout& form, QWidget& field, bool isVisible) {
  form.setRowVisible(&field, isVisible);
}

void withoutIcons(QDialogButtonBox& buttons) {
  for (QAbstractButton* button : buttons.buttons()) button->setIcon({});
}

QString sentenceOf(const std::string& message) {
  QString text = QString::fromStdString(message).trimmed();
  if (text.isEmpty()) return text;
  text[0] = text[0].toUpper();
  if (!text.endsWith('.') && !text.endsWith('!')) text += '.';
  return text;
}

}  // namespace kiri::desktop
