// One fold line: mountain or valley, name, angle, slider.
// SPDX-License-Identifier: MIT
#pragma once

#include <QTimer>
#include <QWidget>
#include <optional>

#include "editor/motion/fold_sliders.h"

class QLabel;
class QSlider;

namespace kiri::desktop {

class UnitBox;

/// Shows whatever fold line it is given, so that a list of hundreds needs no more rows than are
/// seen. Keys on the slider count as one drag until they rest.
class FoldRow final : public QWidget {
  Q_OBJECT
 public:
  explicit FoldRow(QWidget* parent = nullptr);
  static constexpr int kHeight = 58;

  void show(const FoldSlider& slider);
  /// While it is dragged: where the paper is.
  void showAmount(double degrees);
  const std::optional<FoldSlider>& slider() const { return shown_; }
  bool isHeld() const { return isHeld_; }
  QSlider* bar() const { return bar_; }
  UnitBox* box() const { return box_; }

 signals:
  void held(kiri::FoldLineId line);
  void moved(double degrees);
  void released(bool keep);

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  void hold();
  void release();
  void set(double degrees);

  std::optional<FoldSlider> shown_;
  QLabel* name_;
  QSlider* bar_;
  UnitBox* box_;
  QTimer rest_;  ///< until keys count as done
  bool isHeld_ = false;
  bool isUpdating_ = false;
};

}  // namespace kiri::desktop
