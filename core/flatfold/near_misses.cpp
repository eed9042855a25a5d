// One pass over all lines. SPDX-License-Identifier: MIT
#include "core/flatfold/near_misses.h"

#include <algorithm>
#include <cmath>

#include "core/flatfold/box_tree.h"
#include "core/flatfold/cluster.h"

namespace kiri {
namespace {

/// The powers of one gap: its middle, then ever farther from it.
void addFromMiddle(int low, int high, std::vector<double>& found) {
  const int middle = low + (high - low) / 2;
  const int step = std::max(1, (high - low) / 4);
  found.push_back(std::ldexp(1, middle));
  for (int by = step; middle - by >= low || middle + by <= high; by += step) {
    if (middle - by >= low) found.push_back(std::ldexp(1, middle - by));
    if (middle + by <= high) found.push_back(std::ldexp(1, middle + by));
  }
}

}  // namespace

NearMisses::NearMisses(const FoldedLines& lines, double same, double most)
    : lowest_(std::ilogb(same)) {
  counts_.assign(static_cast<std::size_t>(std::max(1, std::ilogb(most) - lowest_ + 1)), 0);
  const Clusters clusters = clustersOf(lines.points, same);
  std::vector<Box> boxes;
  for (const Vec2 p : clusters.middles) boxes.push_back({p, p});
  const BoxTree tree(std::move(boxes));
  std::vector<std::array<std::uint32_t, 2>> ends;
  for (const std::array<std::uint32_t, 2>& e : lines.ends) {
    const std::uint32_t a = clusters.of[e[0]];
    const std::uint32_t b = clusters.of[e[1]];
    if (a != b) ends.push_back({std::min(a, b), std::max(a, b)});
  }
  std::sort(ends.begin(), ends.end());
  ends.erase(std::unique(ends.begin(), ends.end()), ends.end());
  for (const std::array<std::uint32_t, 2>& e : ends) {
    const Segment2 line{clusters.middles[e[0]], clusters.middles[e[1]]};
    tree.near(line, most, [&](std::uint32_t p) {
      if (p != e[0] && p != e[1]) add(distanceTo(line, clusters.middles[p]));
    });
  }
}

void NearMisses::add(double distance) {
  if (distance <= 0) return;
  const int power = std::ilogb(distance) - lowest_;
  if (power >= 0 && static_cast<std::size_t>(power) < counts_.size())
    ++counts_[static_cast<std::size_t>(power)];
}

bool NearMisses::isFree(int power, int room) const {
  for (int p = power - room; p < power + room; ++p) {
    const int at = p - lowest_;
    if (at >= 0 && static_cast<std::size_t>(at) < counts_.size() &&
        counts_[static_cast<std::size_t>(at)] > 0)
      return false;
  }
  return true;
}

std::vector<double> NearMisses::gaps(double noise, int room) const {
  const int reach = std::ilogb(room);
  const int highest = lowest_ + static_cast<int>(counts_.size()) - 1 - reach;
  const int start = std::clamp(std::ilogb(noise), lowest_, highest + 1);
  std::vector<double> found;
  for (int power = start; power <= highest; ++power) {
    if (!isFree(power, reach)) continue;
    const int low = power;
    while (power < highest && isFree(power + 1, reach)) ++power;
    addFromMiddle(low, power, found);
  }
  for (int power = start - 1; power >= lowest_; --power) {
    if (!isFree(power, reach)) continue;
    const int high = power;
    while (power > lowest_ && isFree(power - 1, reach)) --power;
    addFromMiddle(power, high, found);
  }
  return found;
}

}  // namespace kiri
