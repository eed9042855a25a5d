// Export: pictures, patterns for machines, and files for other programs.
// SPDX-License-Identifier: MIT
#pragma once

#include <QCheckBox>
#include <QComboBox>
#include <QDialog>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QImage>
#include <QLabel>
#include <QPushButton>

#include "apps/desktop/dialogs/work_bar.h"
#include "apps/desktop/services/exporter.h"
#include "apps/desktop/services/settings.h"
#include "editor/base/task.h"

namespace kiri::desktop {

/// Shows what the file will hold and writes it beside the window; the dialog stays until the file
/// is there or the person closes it.
///
///   ExportDialog dialog(exportSourceOf(session.document(), session.camera().map().frame),
///                       runner, settings, version, this);
///   dialog.exec();
class ExportDialog final : public QDialog {
  Q_OBJECT
 public:
  ExportDialog(ExportSource source, TaskRunner& runner, Settings& settings, const QString& version,
               QWidget* parent = nullptr);

  /// What the dialog would write now, without a path.
  ExportRequest request() const;
  /// Writes to `path`; the file dialog is left out.
  void exportInto(const QString& path);
  bool isBusy() const { return bar_->isBusy(); }

 signals:
  void exported(const QString& path);

 private:
  QWidget* makeOptions();
  void addPictureRows();
  void addProgramRows();
  QComboBox* makeFormats();
  void remember();
  void recall();
  void showRows();
  void askPreview();
  void showPreview(const QImage& picture);
  void chooseAndExport();
  void ended(const QString& path, const Result<std::vector<std::string>>& outcome);
  void reject() override;

  ExportSource source_;
  Settings& settings_;
  QString version_;
  LatestTask previews_;

  QFormLayout* form_ = nullptr;
  QComboBox* subject_ = nullptr;
  QComboBox* format_ = nullptr;
  QComboBox* view_ = nullptr;
  QComboBox* lines_ = nullptr;
  QDoubleSpinBox* scale_ = nullptr;
  QDoubleSpinBox* margin_ = nullptr;
  QDoubleSpinBox* dpi_ = nullptr;
  QCheckBox* creases_ = nullptr;
  QCheckBox* shaded_ = nullptr;
  QCheckBox* linesOnly_ = nullptr;
  QCheckBox* machines_ = nullptr;
  QCheckBox* white_ = nullptr;
  QCheckBox* asFolded_ = nullptr;
  QDoubleSpinBox* layerGap_ = nullptr;
  QDoubleSpinBox* thickness_ = nullptr;
  QCheckBox* twoSided_ = nullptr;
  QCheckBox* animated_ = nullptr;
  QLabel* preview_ = nullptr;
  QLabel* facts_ = nullptr;
  WorkBar* bar_ = nullptr;
  QPushButton* export_ = nullptr;
  QPushButton* close_ = nullptr;
};

}  // namespace kiri::desktop
