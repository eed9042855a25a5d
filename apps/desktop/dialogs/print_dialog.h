// Printing in true size, over as many pages as it takes.
// SPDX-License-Identifier: MIT
#pragma once

#include <QCheckBox>
#include <QComboBox>
#include <QDialog>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QLabel>
#include <QPrintPreviewWidget>
#include <QPrinter>
#include <QPushButton>
#include <memory>
#include <optional>

#include "apps/desktop/services/exporter.h"
#include "apps/desktop/services/page_tiles.h"
#include "apps/desktop/services/settings.h"
#include "editor/base/task.h"

namespace kiri::desktop {

/// The crease pattern or the model as it comes out of the printer, with a preview of every page.
/// Used like ExportDialog. One millimetre of paper is one millimetre on the printed page unless the
/// person asks for another scale.
class PrintDialog final : public QDialog {
  Q_OBJECT
 public:
  PrintDialog(ExportSource source, TaskRunner& runner, Settings& settings,
              QWidget* parent = nullptr);
  ~PrintDialog() override;

  ExportRequest request() const;
  /// Pages that would be printed now; none while the picture is being made.
  std::optional<PageTiles> tiles() const;
  /// Prints into a PDF file instead of on paper.
  bool printToPdf(const QString& path);

 signals:
  void pictureReady();

 private:
  QWidget* makeOptions();
  QLayout* makeButtons();
  void showRows();
  void askPicture();
  void setUpPage();
  void showPages();
  void showEvent(QShowEvent* event) override;
  void paintPages(QPrinter* printer);
  PageTiles tilesOn(const QPrinter& printer) const;
  void sayPages();
  void print();
  void chooseAndPrintToPdf();

  ExportSource source_;
  Settings& settings_;
  LatestTask pictures_;
  std::shared_ptr<const Scene> scene_;
  std::unique_ptr<QPrinter> printer_;
  QPrintPreviewWidget* preview_ = nullptr;
  QFormLayout* form_ = nullptr;
  QComboBox* subject_ = nullptr;
  QComboBox* view_ = nullptr;
  QComboBox* lines_ = nullptr;
  QComboBox* size_ = nullptr;
  QComboBox* orientation_ = nullptr;
  QDoubleSpinBox* scale_ = nullptr;
  QDoubleSpinBox* overlap_ = nullptr;
  QCheckBox* linesOnly_ = nullptr;
  QCheckBox* asFolded_ = nullptr;
  QLabel* facts_ = nullptr;
  QPushButton* print_ = nullptr;
  QPushButton* pdf_ = nullptr;
};

}  // namespace kiri::desktop
