// Pan and zoom of the eye above the flat sheet.
// SPDX-License-Identifier: MIT
#include <algorithm>

#include "editor/view/camera.h"
#include "editor/view/zoom_limits.h"

namespace kiri {

void SheetCamera::fit(const Box& sheet) {
  sheet_ = sheet;
  const Vec2 extent = sheet.high - sheet.low;
  const double least = std::max(1.0, std::max(extent.x, extent.y)) / std::max(size_.x, size_.y);
  const double mmPerPixel = std::max({extent.x / size_.x, extent.y / size_.y, least / 2});
  pixelsPerMm_ = kFittedPart / mmPerPixel;
  centre_ = (sheet.low + sheet.high) / 2;
  isFitted_ = true;
}

void SheetCamera::resize(Vec2 pixels) {
  size_ = {std::max(1.0, pixels.x), std::max(1.0, pixels.y)};
  if (isFitted_) fit(sheet_);
}

void SheetCamera::pan(Vec2 byPixels) {
  const double right = showsBack_ ? -1 : 1;
  centre_ = centre_ + Vec2{-right * byPixels.x, byPixels.y} / pixelsPerMm_;
  isFitted_ = false;
}

void SheetCamera::zoom(Vec2 about, double factor) {
  if (!(factor > 0)) return;
  const double radius = std::max(distance(sheet_.low, sheet_.high) / 2, 1 / pixelsPerMm_);
  const double next = limitedScale(pixelsPerMm_ * factor, pixelsPerMm_, radius, size_);
  const double gained = 1 / pixelsPerMm_ - 1 / next;
  const double right = showsBack_ ? -1 : 1;
  centre_ = centre_ + Vec2{right * (about.x - size_.x / 2), size_.y / 2 - about.y} * gained;
  pixelsPerMm_ = next;
  isFitted_ = false;
}

void SheetCamera::setShowsBack(bool showsBack) { showsBack_ = showsBack; }

PaneMap SheetCamera::map() const {
  const ViewFrame frame = showsBack_ ? backView() : frontView();
  const Vec2 middle = frame.direction(Vec3{centre_.x, centre_.y, 0});
  return {Pane::Sheet, frame, pixelsPerMm_, middle, size_};
}

}  // namespace kiri
