// Choosing a sheet of paper: square, rectangle, disc, blank of a leaf, or any outline.
// SPDX-License-Identifier: MIT
#pragma once

#include <QComboBox>
#include <QDialog>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QLabel>
#include <QPushButton>
#include <vector>

#include "core/model/model.h"
#include "editor/document/new_sheet.h"

namespace kiri::desktop {

/// The drawing that stands for a sheet of editor/document/new_sheet.h.
QString iconOf(const SheetPreset& preset);

/// Asks for a sheet. Accepted: `dialog.model()`, a model without steps.
class SheetDialog final : public QDialog {
  Q_OBJECT
 public:
  explicit SheetDialog(const SheetSpec& start = {}, QWidget* parent = nullptr);

  SheetSpec sheet() const;
  /// The sheet in the colours of the paper that was chosen last.
  Model model() const;
  void setSheet(const SheetSpec& sheet);

 private:
  void showRows();
  void showPicture();
  void usePreset();

  std::vector<SheetPreset> presets_ = sheetPresets();
  Model paper_;
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
