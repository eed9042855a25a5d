// SPDX-License-Identifier: MIT
#include "core/creases/weld.h"

#include <cmath>
#include <limits>

#include "core/creases/near_points.h"

namespace kiri {
namespace {

/// Squares and products of larger or smaller numbers leave the range of doubles.
constexpr double kLargest = static_cast<double>(std::numeric_limits<float>::max());
constexpr double kSmallest = static_cast<double>(std::numeric_limits<float>::min());

bool isSound(Vec2 p) { return std::abs(p.x) <= kLargest && std::abs(p.y) <= kLargest; }

/// The middle of the ends that joined a vertex; the place itself where they are all there.
class MeanPlace {
 public:
  void add(Vec2 offset) {
    sum_ = sum_ + offset;
    ++count_;
    isMoved_ = isMoved_ || offset != Vec2{};
  }
  Vec2 from(Vec2 first) const {
    return isMoved_ ? first + sum_ / static_cast<double>(count_) : first;
  }

 private:
  Vec2 sum_;
  std::size_t count_ = 0;
  bool isMoved_ = false;
};

}  // namespace

std::vector<DrawnCrease> soundLines(const CreaseDrawing& drawing, RepairLog& log) {
  std::vector<DrawnCrease> lines;
  lines.reserve(drawing.lines.size());
  for (const DrawnCrease& line : drawing.lines) {
    const bool areSound = isSound(line.from) && isSound(line.to);
    if (areSound && distance(line.from, line.to) > kSmallest) {
      lines.push_back(line);
    } else {
      log.add(RepairKind::DroppedPoints, isSound(line.from) ? line.from : Vec2{});
    }
  }
  return lines;
}

LineMap weld(const std::vector<DrawnCrease>& lines, const RepairScale& scale, RepairLog& log) {
  NearPoints vertices(lines.empty() ? Vec2{} : lines.front().from, scale.within);
  std::vector<std::uint32_t> vertexOf;
  vertexOf.reserve(2 * lines.size());
  std::vector<MeanPlace> means;
  for (std::size_t i = 0; i < 2 * lines.size(); ++i) {
    const Vec2 end = i % 2 == 0 ? lines[i / 2].from : lines[i / 2].to;
    const std::optional<std::uint32_t> known = vertices.nearest(end);
    const std::uint32_t vertex = known ? *known : vertices.add(end);
    if (!known) means.emplace_back();
    means[vertex].add(end - vertices.points()[vertex]);
    vertexOf.push_back(vertex);
  }
  LineMap map;
  map.points = vertices.points();
  for (std::size_t v = 0; v < map.points.size(); ++v) map.points[v] = means[v].from(map.points[v]);
  for (std::size_t i = 0; i < vertexOf.size(); ++i) {
    const Vec2 end = i % 2 == 0 ? lines[i / 2].from : lines[i / 2].to;
    const double moved = distance(end, map.points[vertexOf[i]]);
    if (moved > scale.same) log.add(RepairKind::MergedVertices, end, moved);
  }
  map.lines.reserve(lines.size());
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const MapLine line{vertexOf[2 * i], vertexOf[2 * i + 1], lines[i].assignment, lines[i].angle,
                       static_cast<std::uint32_t>(i)};
    if (line.from == line.to) {
      log.add(RepairKind::DroppedPoints, lines[i].from);
    } else {
      map.lines.push_back(line);
    }
  }
  return map;
}

bool mergeSamePoints(LineMap& map, double same) {
  NearPoints kept(map.points.empty() ? Vec2{} : map.points.front(), same);
  std::vector<std::uint32_t> keptAs;
  keptAs.reserve(map.points.size());
  bool isAny = false;
  for (const Vec2 p : map.points) {
    const std::optional<std::uint32_t> known = kept.nearest(p);
    keptAs.push_back(known ? *known : kept.add(p));
    isAny = isAny || known;
  }
  if (!isAny) return false;
  std::vector<MapLine> lines;
  for (MapLine line : map.lines) {
    line.from = keptAs[line.from];
    line.to = keptAs[line.to];
    if (line.from != line.to) lines.push_back(line);
  }
  map.points = kept.points();
  map.lines = std::move(lines);
  return true;
}

}  // namespace kiri
