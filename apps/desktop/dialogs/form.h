// Small parts that all dialogs are made of.
// SPDX-License-Identifier: MIT
#pragma once

#include <QComboBox>
#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QLabel>
#include <QString>
#include <QVariant>
#include <QWidget>

namespace kiri::desktop {

/// A box for a number with a unit, such as " mm".
QDoubleSpinBox* numberBox(double value, double least, double most, const QString& unit,
                          int decimals = 1, double step = 1);

/// A box of choices, each with the number that it stands for.
QComboBox* choiceBox(const QList<QPair<QString, int>>& choices, int chosen);
int chosenIn(const QComboBox& box);
void choose(QComboBox& box, int choice);

/// A headline, and a paragraph of small words below something.
QLabel* headline(const QString& text);
QLabel* remark(const QString& text);

/// A form whose labels stand at the left and whose boxes keep their width.
QFormLayout* formLayout();
/// Shows or hides a row of a form with its label.
void setRowVisible(QFormLayout& form, QWidget& field, bool isVisible);

/// Takes the pictures off standard buttons: they are not in the colours of the theme.
void withoutIcons(QDialogButtonBox& buttons);

/// The sentence of an error as people read it: with a capital letter and a full stop.
QString sentenceOf(const std::string& message);

}  // namespace kiri::desktop
