// SPDX-License-Identifier: MIT
#include "core/model/facet_finder.h"

#include <algorithm>
#include <cmath>

namespace kiri {
namespace {

/// From the point to the facet's border, mm.
double roomAround(const CreasePattern& pattern, FacetId facet, Vec2 p) {
  double least = HUGE_VAL;
  for (const EdgeUse use : pattern[facet].border)
    least = std::min(least, nearestOn(arcOf(pattern, use), p).distance);
  return least;
}

}  // namespace

FacetFinder::FacetFinder(const CreasePattern& pattern) : nearness_(pattern.tolerance.length()) {
  const std::size_t count = pattern.facets.size();
  KIRI_CHECK(count > 0, "a pattern has facets");
  for (std::size_t f = 0; f < count; ++f) {
    regions_.push_back(regionOf(pattern, FacetId(f)));
    boxes_.push_back(boundsOf(regions_.back()));
    box_ = f == 0 ? boxes_[0] : joined(box_, boxes_[f]);
  }
  columns_ = static_cast<std::size_t>(std::ceil(std::sqrt(static_cast<double>(count))));
  cells_.resize(columns_ * columns_);
  for (std::size_t f = 0; f < count; ++f) {
    const std::size_t right = cellOf(boxes_[f].high.x, box_.low.x, box_.high.x);
    const std::size_t top = cellOf(boxes_[f].high.y, box_.low.y, box_.high.y);
    for (std::size_t y = cellOf(boxes_[f].low.y, box_.low.y, box_.high.y); y <= top; ++y) {
      for (std::size_t x = cellOf(boxes_[f].low.x, box_.low.x, box_.high.x); x <= right; ++x)
        cells_[y * columns_ + x].push_back(FacetId(f));
    }
  }
}

std::size_t FacetFinder::cellOf(double value, double low, double high) const {
  const double part = high > low ? (value - low) / (high - low) : 0;
  const auto cell = static_cast<double>(columns_) * std::clamp(part, 0.0, 1.0);
  return std::min(columns_ - 1, static_cast<std::size_t>(cell));
}

std::optional<FacetId> FacetFinder::at(Vec2 paper) const {
  const std::size_t x = cellOf(paper.x, box_.low.x, box_.high.x);
  const std::size_t y = cellOf(paper.y, box_.low.y, box_.high.y);
  std::optional<FacetId> touching;
  for (const FacetId f : cells_[y * columns_ + x]) {
    if (!areNear(boxes_[f.index], {paper, paper}, nearness_)) continue;
    const Where where = locate(regions_[f.index], paper, nearness_);
    if (where == Where::Inside) return f;
    if (where == Where::OnBorder && !touching) touching = f;
  }
  return touching;
}

Vec2 namingPointOf(const CreasePattern& pattern, FacetId facet) {
  const Vec2 exact = interiorPointOf(pattern, facet);
  const double allowed = roomAround(pattern, facet, exact) / 8;
  constexpr double kBase = 10;
  constexpr int kMostDigits = 12;
  double scale = 1;
  for (int digits = 0; digits < kMostDigits; ++digits, scale *= kBase) {
    const Vec2 rounded{std::round(exact.x * scale) / scale, std::round(exact.y * scale) / scale};
    if (distance(rounded, exact) <= allowed) return rounded;
  }
  return exact;
}

}  // namespace kiri
