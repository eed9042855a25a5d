// Free places for labels on a page: outward until a box is free, or around for the freest.
// SPDX-License-Identifier: MIT
#include "render/scene/label_room.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "core/geometry/bounds.h"

namespace kiri {
namespace {

bool isWithin(const Box& box, const Box& page) {
  return holds(page, box.low, 0) && holds(page, box.high, 0);
}

double sizeOfBox(const Box& box) {
  return std::max(0.0, box.high.x - box.low.x) * std::max(0.0, box.high.y - box.low.y);
}

Box commonBox(const Box& a, const Box& b) {
  return {{std::max(a.low.x, b.low.x), std::max(a.low.y, b.low.y)},
          {std::min(a.high.x, b.high.x), std::min(a.high.y, b.high.y)}};
}

}  // namespace

bool LabelRoom::isOnShape(const Box& box) const {
  const Vec2 p = (box.low + box.high) / 2;
  bool isInside = false;
  for (const auto& loop : loops_) {
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const Vec2 a = loop[i];
      const Vec2 b = loop[(i + 1) % loop.size()];
      if (holds(box, a, 0)) return true;
      if ((a.y > p.y) != (b.y > p.y) && p.x < a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x)) {
        isInside = !isInside;
      }
    }
  }
  return isInside;
}

bool LabelRoom::isFree(const Box& box) const {
  const bool isTaken = std::any_of(taken_.begin(), taken_.end(),
                                   [&box](const Box& other) { return areNear(box, other, 0); });
  return !isTaken && isWithin(box, page_) && !isOnShape(box);
}

bool LabelRoom::isClear(Vec2 from, Vec2 to) const {
  constexpr int kSteps = 32;
  for (int i = 0; i <= kSteps; ++i) {
    const Vec2 p = lerp(from, to, static_cast<double>(i) / kSteps);
    for (const Box& box : taken_) {
      if (holds(box, p, 0)) return false;
    }
  }
  return true;
}

std::optional<LabelPlace> LabelRoom::takeBeyond(Vec2 from, Vec2 direction, Vec2 size,
                                                double reach) {
  const double half = (std::abs(direction.x) * size.x + std::abs(direction.y) * size.y) / 2;
  const double step = size.y / 2;
  for (double away = step; away <= reach; away += step) {
    const Vec2 middle = from + direction * (away + half);
    const Box box{middle - size / 2, middle + size / 2};
    const Vec2 near = from + direction * away;
    if (!isFree(box) || !isClear(from, near)) continue;
    taken_.push_back(box);
    return LabelPlace{middle, near, away > 2 * step};
  }
  return std::nullopt;
}

double LabelRoom::covered(const Box& box) const {
  // Outside the page is worse than over another label.
  double sum = 10 * (sizeOfBox(box) - sizeOfBox(commonBox(box, page_)));
  for (const Box& other : taken_) sum += sizeOfBox(commonBox(box, other));
  return sum;
}

Box LabelRoom::pushedIntoPage(const Box& box) const {
  const Vec2 push{
      std::max(0.0, page_.low.x - box.low.x) - std::max(0.0, box.high.x - page_.high.x),
      std::max(0.0, page_.low.y - box.low.y) - std::max(0.0, box.high.y - page_.high.y)};
  return {box.low + push, box.high + push};
}

Vec2 LabelRoom::takeAround(Vec2 point, Vec2 size, double away) {
  constexpr int kDirections = 12;
  constexpr int kDistances = 4;
  const Vec2 half = size / 2;
  double least = std::numeric_limits<double>::infinity();
  Box best;
  for (int ring = 0; ring < kDistances && least > 0; ++ring) {
    const double reach = away + ring * size.y * 0.8;
    for (int i = 0; i < kDirections && least > 0; ++i) {
      const double angle = 2 * std::numbers::pi * (i + 0.5) / kDirections;
      const Vec2 way{std::cos(angle), std::sin(angle)};
      const Vec2 middle = point + way * reach + Vec2{way.x * half.x, way.y * half.y};
      const Box box{middle - half, middle + half};
      const double sum = covered(box);
      if (sum >= least) continue;
      least = sum;
      best = box;
    }
  }
  taken_.push_back(pushedIntoPage(best));
  return (taken_.back().low + taken_.back().high) / 2;
}

}  // namespace kiri
