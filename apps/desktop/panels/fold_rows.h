// The list of fold lines, with widgets only for those that are seen.
// SPDX-License-Identifier: MIT
#pragma once

#include <QScrollArea>
#include <vector>

#include "editor/motion/fold_sliders.h"

namespace kiri::desktop {

class FoldRow;

class FoldRows final : public QScrollArea {
  Q_OBJECT
 public:
  explicit FoldRows(QWidget* parent = nullptr);
  void show(std::vector<FoldSlider> sliders);
  const std::vector<FoldSlider>& sliders() const { return sliders_; }
  /// The row of a fold line that is seen now; none: it is scrolled away.
  FoldRow* rowOf(std::size_t index) const;
  void showAmount(double degrees);

 signals:
  void held(kiri::FoldLineId line);
  void moved(double degrees);
  void released(bool keep);

 protected:
  void resizeEvent(QResizeEvent* event) override;
  void scrollContentsBy(int dx, int dy) override;

 private:
  void place();
  FoldRow* makeRow();

  std::vector<FoldSlider> sliders_;
  std::vector<FoldRow*> rows_;
  std::size_t first_ = 0;
};

}  // namespace kiri::desktop
