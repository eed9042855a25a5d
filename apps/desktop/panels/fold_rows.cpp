// The list of fold lines, with widgets only for those that are seen.
// SPDX-License-Identifier: MIT
#include "apps/desktop/panels/fold_rows.h"

#include <QScrollBar>
#include <algorithm>
#include <utility>

#include "apps/desktop/panels/fold_row.h"

namespace kiri::desktop {

FoldRows::FoldRows(QWidget* parent) : QScrollArea(parent) {
  setFrameShape(QFrame::NoFrame);
  setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  verticalScrollBar()->setSingleStep(FoldRow::kHeight / 2);
  setWidget(new QWidget(this));
}

FoldRow* FoldRows::makeRow() {
  auto* row = new FoldRow(widget());
  connect(row, &FoldRow::held, this, &FoldRows::held);
  connect(row, &FoldRow::moved, this, &FoldRows::moved);
  connect(row, &FoldRow::released, this, &FoldRows::released);
  return row;
}

void FoldRows::show(std::vector<FoldSlider> sliders) {
  sliders_ = std::move(sliders);
  place();
}

void FoldRows::place() {
  const int width = viewport()->width();
  const int count = static_cast<int>(sliders_.size());
  widget()->resize(width, std::max(count * FoldRow::kHeight, 1));
  const bool isHeld =
      std::any_of(rows_.begin(), rows_.end(), [](const FoldRow* row) { return row->isHeld(); });
  if (!isHeld) first_ = static_cast<std::size_t>(verticalScrollBar()->value() / FoldRow::kHeight);
  const auto seen = static_cast<std::size_t>(viewport()->height() / FoldRow::kHeight) + 2;
  while (rows_.size() < std::min(seen, sliders_.size())) rows_.push_back(makeRow());
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    FoldRow* row = rows_[i];
    const std::size_t index = first_ + i;
    const bool isThere = index < sliders_.size();
    row->setVisible(isThere);
    if (!isThere) continue;
    row->show(sliders_[index]);
    row->setGeometry(0, static_cast<int>(index) * FoldRow::kHeight, width, FoldRow::kHeight);
  }
}

FoldRow* FoldRows::rowOf(std::size_t index) const {
  if (index < first_ || index - first_ >= rows_.size()) return nullptr;
  return rows_[index - first_];
}

void FoldRows::showAmount(double degrees) {
  for (FoldRow* row : rows_) {
    if (row->isHeld()) row->showAmount(degrees);
  }
}

void FoldRows::resizeEvent(QResizeEvent* event) {
  QScrollArea::resizeEvent(event);
  place();
}

void FoldRows::scrollContentsBy(int dx, int dy) {
  QScrollArea::scrollContentsBy(dx, dy);
  place();
}

}  // namespace kiri::desktop
