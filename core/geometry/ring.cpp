// Making one closed ring of a border with holes and slits.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>

#include "core/geometry/orientation.h"
#include "core/geometry/triangulation.h"

namespace kiri {
namespace {

std::size_t nextIn(const Ring& ring, std::size_t i) { return i + 1 < ring.size() ? i + 1 : 0; }
std::size_t previousIn(const Ring& ring, std::size_t i) { return (i > 0 ? i : ring.size()) - 1; }

/// True when the direction from corner i towards q leads into the paper left of the ring, not along
/// a side.
bool leadsInside(const Ring& ring, std::size_t i, Vec2 q) {
  const Vec2 at = ring[i].point;
  const Vec2 before = ring[previousIn(ring, i)].point;
  const Vec2 after = ring[nextIn(ring, i)].point;
  const int turn = orientation(before, at, after);
  const bool isLeftOfFirst = orientation(before, at, q) > 0;
  const bool isLeftOfSecond = orientation(at, after, q) > 0;
  if (turn > 0) return isLeftOfFirst && isLeftOfSecond;
  if (turn < 0) return isLeftOfFirst || isLeftOfSecond;
  if (dot(before - at, after - at) < 0) return isLeftOfFirst;
  return orientation(at, after, q) != 0 || dot(after - at, q - at) < 0;  // the tip of a slit
}

bool isStrictlyBetween(Vec2 p, Vec2 a, Vec2 b) {
  return orientation(a, b, p) == 0 && dot(p - a, b - a) > 0 && dot(p - b, a - b) > 0;
}

/// True when a side of the ring crosses the segment or a corner lies on it.
bool blocks(const Ring& ring, Vec2 a, Vec2 b) {
  Vec2 p = ring.back().point;
  int sideOfP = orientation(a, b, p);
  for (const Corner& corner : ring) {
    const Vec2 q = corner.point;
    const int sideOfQ = orientation(a, b, q);
    if (sideOfQ == 0 && isStrictlyBetween(q, a, b)) return true;
    if (sideOfP * sideOfQ < 0 && orientation(p, q, a) * orientation(p, q, b) < 0) return true;
    p = q;
    sideOfP = sideOfQ;
  }
  return false;
}

std::size_t leftmost(const Ring& ring) {
  std::size_t best = 0;
  for (std::size_t i = 1; i < ring.size(); ++i) {
    const Vec2 p = ring[i].point;
    const Vec2 q = ring[best].point;
    if (p.x < q.x || (p.x == q.x && p.y < q.y)) best = i;
  }
  return best;
}

/// The corners of `ring` from the nearest to `p` to the farthest.
std::vector<std::size_t> byDistance(const Ring& ring, Vec2 p) {
  std::vector<std::pair<double, std::size_t>> order(ring.size());
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Vec2 d = ring[i].point - p;
    order[i] = {dot(d, d), i};
  }
  std::sort(order.begin(), order.end());
  std::vector<std::size_t> result(ring.size());
  for (std::size_t i = 0; i < ring.size(); ++i) result[i] = order[i].second;
  return result;
}

/// The corner of `ring` to which corner `h` of hole number `which` is joined.
std::size_t bridgeEnd(const Ring& ring, const std::vector<Ring>& holes, std::size_t which,
                      std::size_t h) {
  const Ring& hole = holes[which];
  const Vec2 from = hole[h].point;
  const std::vector<std::size_t> candidates = byDistance(ring, from);
  std::optional<std::size_t> second;  // joined at least without turning outside
  for (const std::size_t r : candidates) {
    const Vec2 to = ring[r].point;
    if (to == from) {
      if (leadsInside(ring, r, hole[nextIn(hole, h)].point) ||
          leadsInside(ring, r, hole[previousIn(hole, h)].point)) {
        return r;
      }
      continue;
    }
    if (!leadsInside(ring, r, from) || !leadsInside(hole, h, to)) continue;
    if (!second) second = r;
    const auto isBlocked = [&](const Ring& other) { return blocks(other, from, to); };
    if (!isBlocked(ring) &&
        std::none_of(holes.begin() + static_cast<std::ptrdiff_t>(which), holes.end(), isBlocked)) {
      return r;
    }
  }
  return second.value_or(candidates.front());
}

/// `ring` with the hole let in after its corner r.
Ring letIn(const Ring& ring, std::size_t r, const Ring& hole, std::size_t h, std::int32_t bridge) {
  Ring result;
  result.reserve(ring.size() + hole.size() + 2);
  result.insert(result.end(), ring.begin(), ring.begin() + static_cast<std::ptrdiff_t>(r));
  const bool isTouching = ring[r].point == hole[h].point;
  if (!isTouching) result.push_back({ring[r].point, ConvexPart::kInner, bridge});
  for (std::size_t i = 0; i < hole.size(); ++i) result.push_back(hole[(h + i) % hole.size()]);
  if (!isTouching) result.push_back({hole[h].point, ConvexPart::kInner, bridge});
  result.insert(result.end(), ring.begin() + static_cast<std::ptrdiff_t>(r), ring.end());
  return result;
}

}  // namespace

Ring withoutSpikes(const Ring& ring) {
  Ring kept;
  kept.reserve(ring.size());
  for (const Corner& corner : ring) {
    if (!kept.empty() && kept.back().point == corner.point) {
      kept.back() = corner;
    } else if (kept.size() > 1 && kept[kept.size() - 2].point == corner.point) {
      kept.pop_back();
      kept.back() = corner;
    } else {
      kept.push_back(corner);
    }
  }
  std::size_t low = 0;
  std::size_t high = kept.size();
  while (high - low > 2) {
    if (kept[high - 1].point == kept[low].point) {
      --high;
    } else if (kept[high - 1].point == kept[low + 1].point) {
      ++low;
      --high;
    } else if (kept[high - 2].point == kept[low].point) {
      high -= 2;
    } else {
      break;
    }
  }
  if (high - low < 3) return {};
  return {kept.begin() + static_cast<std::ptrdiff_t>(low),
          kept.begin() + static_cast<std::ptrdiff_t>(high)};
}

Ring bridged(Ring border, std::vector<Ring> holes) {
  // From the left: then no other hole hides the border from the leftmost corner.
  std::stable_sort(holes.begin(), holes.end(), [](const Ring& a, const Ring& b) {
    return a[leftmost(a)].point.x < b[leftmost(b)].point.x;
  });
  std::int32_t bridge = 0;
  for (std::size_t i = 0; i < holes.size(); ++i) {
    const std::size_t h = leftmost(holes[i]);
    border = letIn(border, bridgeEnd(border, holes, i, h), holes[i], h, bridge++);
  }
  return border;
}

}  // namespace kiri
