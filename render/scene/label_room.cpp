// Walks outward until a box is free.
// SPDX-License-Identifier: MIT
#include "render/scene/label_room.h"

#include <algorithm>
#include <cmath>

#include "core/geometry/bounds.h"

namespace kiri {
namespace {

bool isWithin(const Box& box, const Box& page) {
  return holds(page, box.low, 0) && holds(page, box.high, 0);
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

std::optional<LabelPlace> LabelRoom::take(Vec2 from, Vec2 direction, Vec2 size, double reach) {
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

}  // namespace kiri
