// Choosing a sheet of paper: square, rectangle, disc, blank of a leaf, or any outline.
// SPDX-License-Identifier: MIT
#pragma once

#include <QComboBox>
#include <QDialog>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QLabel>
#include <QPushButton>

#include "core/model/model.h"

namespace kiri::desktop {

/// A sheet that is offered by name, on the start page and in the dialog.
struct SheetPreset {
  QString name;
  QString icon;  ///< in look/icons.h
  SheetSpec sheet;
};
/// Square, A4, disc, leaf blank...
QList<SheetPreset> sheetPresets();

/// Asks for a sheet. `dialog.exec() == QDialog::Accepted` then `dialog.sheet()`.
class SheetDialog final : public QDialog {
  Q_OBJECT
 public:
  explicit SheetDialog(const SheetSpec& start = {}, QWidget* parent = nullptr);

  SheetSpec sheet() const;
  void setSheet(const SheetSpec& sheet);

 private:
  void showRows();
  void showPicture();
  void usePreset();

  SheetSpec polygon_;  ///< what a polygon keeps while it is scaled
  bool isSetting_ = false;
  QFormLayout* form_ = nullptr;
  QComboBox* preset_ = nullptr;
  QComboBox* shape_ = nullptr;
  QDoubleSpinBox* width_ = nullptr;
  QDoubleSpinBox* height_ = nullptr;
  QLabel* picture_ = nullptr;
  QLabel* fault_ = nullptr;
  QPushButton* take_ = nullptr;
};

}  // namespace kiri::desktop
