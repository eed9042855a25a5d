// The whole process as a film: GIF, MP4 or WebP.
// SPDX-License-Identifier: MIT
#pragma once

#include <QCheckBox>
#include <QComboBox>
#include <QDialog>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QPushButton>
#include <QSpinBox>

#include "apps/desktop/dialogs/work_bar.h"
#include "apps/desktop/services/film_maker.h"
#include "apps/desktop/services/settings.h"

namespace kiri::desktop {

/// Used like ExportDialog. Where there is no ffmpeg it says so, and how to get it, instead of
/// offering to start.
class FilmDialog final : public QDialog {
  Q_OBJECT
 public:
  FilmDialog(ExportSource source, TaskRunner& runner, Settings& settings,
             QWidget* parent = nullptr);

  FilmRequest request() const;
  void filmInto(const QString& path);
  bool isBusy() const { return bar_->isBusy(); }

 signals:
  void filmed(const QString& path);

 private:
  QWidget* makeOptions();
  QLayout* makeButtons();
  void lookForProgram();
  void chooseAndFilm();
  void ended(const QString& path, const Status& outcome);
  void reject() override;

  ExportSource source_;
  Settings& settings_;
  QComboBox* format_ = nullptr;
  QComboBox* size_ = nullptr;
  QComboBox* view_ = nullptr;
  QCheckBox* turntable_ = nullptr;
  QCheckBox* creases_ = nullptr;
  QSpinBox* first_ = nullptr;
  QSpinBox* last_ = nullptr;
  QDoubleSpinBox* frames_ = nullptr;
  QDoubleSpinBox* speed_ = nullptr;
  QDoubleSpinBox* hold_ = nullptr;
  QLabel* missing_ = nullptr;
  WorkBar* bar_ = nullptr;
  QPushButton* film_ = nullptr;
  QPushButton* close_ = nullptr;
};

}  // namespace kiri::desktop
