// Finds what lies near without looking at everything.
// SPDX-License-Identifier: MIT
#include "render/visibility/grid.h"

#include <algorithm>
#include <cmath>

namespace kiri {
namespace {

/// Cells along one side: about one for each typical thing, never many more cells than things.
std::uint32_t cellsAlong(double extent, double typical, std::size_t count) {
  const double most = std::clamp(2 * std::sqrt(static_cast<double>(count)), 1.0, 2048.0);
  if (!(extent > 0) || !(typical > 0)) return 1;
  return static_cast<std::uint32_t>(std::clamp(extent / typical, 1.0, most));
}

}  // namespace

Grid::Grid(const Box& box, Vec2 typicalSize, std::size_t count) : low_(box.low) {
  const Vec2 extent = box.high - box.low;
  nx_ = cellsAlong(extent.x, typicalSize.x, count);
  ny_ = cellsAlong(extent.y, typicalSize.y, count);
  perMm_ = {extent.x > 0 ? nx_ / extent.x : 0, extent.y > 0 ? ny_ / extent.y : 0};
  cells_.resize(std::size_t{nx_} * ny_);
}

std::uint32_t Grid::column(double x) const {
  const double place = (x - low_.x) * perMm_.x;
  return place <= 0 ? 0 : std::min(nx_ - 1, static_cast<std::uint32_t>(std::min(place, 1.0 * nx_)));
}

std::uint32_t Grid::row(double y) const {
  const double place = (y - low_.y) * perMm_.y;
  return place <= 0 ? 0 : std::min(ny_ - 1, static_cast<std::uint32_t>(std::min(place, 1.0 * ny_)));
}

Grid::Range Grid::rangeOf(const Box& box) const {
  return {column(box.low.x), column(box.high.x), row(box.low.y), row(box.high.y)};
}

void Grid::addBox(const Box& box, std::uint32_t number) {
  const Range r = rangeOf(box);
  for (std::uint32_t y = r.y0; y <= r.y1; ++y) {
    for (std::uint32_t x = r.x0; x <= r.x1; ++x) cells_[std::size_t{y} * nx_ + x].push_back(number);
  }
}

void Grid::addSegment(Vec2 a, Vec2 b, double margin, std::uint32_t number) {
  if (a.x > b.x) std::swap(a, b);
  const std::uint32_t first = column(a.x - margin);
  const std::uint32_t last = column(b.x + margin);
  const double rise = b.x > a.x ? (b.y - a.y) / (b.x - a.x) : 0;
  for (std::uint32_t x = first; x <= last; ++x) {
    double y0 = a.y;
    double y1 = b.y;
    if (first != last && b.x > a.x) {  // the part of the segment over this column, a margin wider
      const double left = std::max(a.x, low_.x + x / perMm_.x - margin);
      const double right = std::min(b.x, low_.x + (x + 1) / perMm_.x + margin);
      y0 = a.y + rise * (left - a.x);
      y1 = a.y + rise * (right - a.x);
    }
    const std::uint32_t bottom = row(std::min(y0, y1) - margin);
    const std::uint32_t top = row(std::max(y0, y1) + margin);
    for (std::uint32_t y = bottom; y <= top; ++y) {
      cells_[std::size_t{y} * nx_ + x].push_back(number);
    }
  }
}

const std::vector<std::uint32_t>& Grid::at(Vec2 p) const {
  return cells_[std::size_t{row(p.y)} * nx_ + column(p.x)];
}

}  // namespace kiri
