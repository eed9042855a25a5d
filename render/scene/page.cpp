// Laying pictures out on a page.
// SPDX-License-Identifier: MIT
#include "render/scene/page.h"

#include <algorithm>
#include <cmath>

namespace kiri {

Affine placed(const Box& box, double scale, Vec2 corner) {
  return {scale, 0, 0, scale, corner.x - scale * box.low.x, corner.y - scale * box.low.y};
}

Group gridGroup(const Box& box, double spacing, const Affine& toScene) {
  constexpr double kMostLines = 2000;  // more would be a grey field
  StrokeItem item;
  item.stroke.color = {200, 210, 220};
  item.stroke.width = 0.1;
  const Vec2 size = box.high - box.low;
  if (!(spacing > 0) || (size.x + size.y) / spacing > kMostLines) return {};
  for (double x = std::ceil(box.low.x / spacing); x * spacing <= box.high.x; ++x) {
    const Vec2 from{x * spacing, box.low.y};
    item.chains.push_back({transformed(toScene, Arc::line(from, {from.x, box.high.y}))});
  }
  for (double y = std::ceil(box.low.y / spacing); y * spacing <= box.high.y; ++y) {
    const Vec2 from{box.low.x, y * spacing};
    item.chains.push_back({transformed(toScene, Arc::line(from, {box.high.x, from.y}))});
  }
  Group group{"grid", "grid", {}, {}};
  if (!item.chains.empty()) group.items.push_back({std::move(item), "grid", "", {}});
  return group;
}

std::optional<Arc> clippedTo(const Box& box, const Arc& line) {
  const Vec2 d = line.end - line.start;
  double from = 0;
  double to = 1;
  // Along each axis the line is inside between two parameters (Liang and Barsky).
  const auto clip = [&](double start, double direction, double low, double high) {
    if (direction == 0) return start >= low && start <= high;
    const double a = (low - start) / direction;
    const double b = (high - start) / direction;
    from = std::max(from, std::min(a, b));
    to = std::min(to, std::max(a, b));
    return from < to;
  };
  if (!clip(line.start.x, d.x, box.low.x, box.high.x)) return std::nullopt;
  if (!clip(line.start.y, d.y, box.low.y, box.high.y)) return std::nullopt;
  return Arc::line(pointAt(line, from), pointAt(line, to));
}

}  // namespace kiri
