// SPDX-License-Identifier: MIT
#include "core/creases/overlaps.h"

#include <algorithm>
#include <compare>

namespace kiri {
namespace {

int rankOf(Assignment assignment) {
  switch (assignment) {
    case Assignment::Border:
      return 0;
    case Assignment::Cut:
      return 1;
    case Assignment::Mountain:
    case Assignment::Valley:
      return 2;
    case Assignment::Unassigned:
      return 3;
    case Assignment::Flat:
      return 4;
    case Assignment::Join:
      return 5;
  }
  return 6;
}

/// Whether two lines mean the same.
bool areAlike(const MapLine& a, const MapLine& b) {
  return a.assignment == b.assignment && a.angle == b.angle;
}

/// The lines that end at each point, two at most; more are only counted.
struct PointEnds {
  std::uint32_t count = 0;
  std::uint32_t lines[2] = {0, 0};
};

std::vector<PointEnds> endsAt(const LineMap& map) {
  std::vector<PointEnds> ends(map.points.size());
  for (std::uint32_t i = 0; i < map.lines.size(); ++i) {
    for (const std::uint32_t p : {map.lines[i].from, map.lines[i].to}) {
      if (ends[p].count < 2) ends[p].lines[ends[p].count] = i;
      ++ends[p].count;
    }
  }
  return ends;
}

}  // namespace

void dropOverlaps(LineMap& map, RepairLog& log) {
  struct Keyed {
    std::uint32_t low = 0;
    std::uint32_t high = 0;
    std::uint32_t line = 0;
    auto operator<=>(const Keyed&) const = default;
  };
  std::vector<Keyed> keyed;
  keyed.reserve(map.lines.size());
  for (std::uint32_t i = 0; i < map.lines.size(); ++i) {
    const MapLine& line = map.lines[i];
    keyed.push_back({std::min(line.from, line.to), std::max(line.from, line.to), i});
  }
  std::sort(keyed.begin(), keyed.end());
  std::vector<bool> isDropped(map.lines.size(), false);
  for (std::size_t first = 0; first < keyed.size();) {
    const std::uint32_t kept = keyed[first].line;
    MapLine best = map.lines[kept];
    std::size_t i = first + 1;
    for (;
         i < keyed.size() && keyed[i].low == keyed[first].low && keyed[i].high == keyed[first].high;
         ++i) {
      const MapLine& other = map.lines[keyed[i].line];
      const Vec2 middle = lerp(map.from(other), map.to(other), 0.5);
      const bool isConflict = other.assignment != best.assignment;
      log.add(isConflict ? RepairKind::Conflicts : RepairKind::DroppedDuplicates, middle);
      if (rankOf(other.assignment) < rankOf(best.assignment)) best = other;
      isDropped[keyed[i].line] = true;
    }
    map.lines[kept] = best;
    first = i;
  }
  std::size_t used = 0;
  for (std::size_t i = 0; i < map.lines.size(); ++i) {
    if (!isDropped[i]) map.lines[used++] = map.lines[i];
  }
  map.lines.resize(used);
}

bool joinPieces(LineMap& map, const std::vector<bool>& parted, RepairLog& log) {
  const std::vector<PointEnds> ends = endsAt(map);
  // Pieces of a line run one way: where one ends the next begins.
  const auto isLeftOver = [&](std::uint32_t p) {
    if (!parted[p] || ends[p].count != 2) return false;
    const MapLine& a = map.lines[ends[p].lines[0]];
    const MapLine& b = map.lines[ends[p].lines[1]];
    return a.drawn == b.drawn && a.drawn != MapLine::kNotDrawn && areAlike(a, b) &&
           (a.to == b.from || b.to == a.from);
  };
  std::vector<bool> isGone(map.lines.size(), false);
  for (std::uint32_t i = 0; i < map.lines.size(); ++i) {
    if (isGone[i]) continue;
    for (const bool isForward : {true, false}) {
      std::uint32_t last = i;
      for (std::uint32_t p = isForward ? map.lines[i].to : map.lines[i].from; isLeftOver(p);) {
        const std::uint32_t next = ends[p].lines[0] == last ? ends[p].lines[1] : ends[p].lines[0];
        if (isGone[next] || next == i) break;
        log.add(RepairKind::JoinedPieces, map.points[p]);
        isGone[next] = true;
        last = next;
        p = isForward ? map.lines[next].to : map.lines[next].from;
        (isForward ? map.lines[i].to : map.lines[i].from) = p;
      }
    }
  }
  std::size_t used = 0;
  for (std::size_t i = 0; i < map.lines.size(); ++i) {
    if (!isGone[i]) map.lines[used++] = map.lines[i];
  }
  const bool isAny = used < map.lines.size();
  map.lines.resize(used);
  return isAny;
}

}  // namespace kiri
