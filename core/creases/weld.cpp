// SPDX-License-Identifier: MIT
#include "core/creases/weld.h"

#include <cmath>

#include "core/creases/near_points.h"

namespace kiri {
namespace {

bool isFinite(Vec2 p) { return std::isfinite(p.x) && std::isfinite(p.y); }

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
    const bool isSound = isFinite(line.from) && isFinite(line.to) && line.from != line.to;
    if (isSound) {
      lines.push_back(line);
    } else {
      log.add(RepairKind::DroppedPoints, isFinite(line.from) ? line.from : Vec2{});
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
    const MapLine line{vertexOf[2 * i], vertexOf[2 * i + 1], lines[i].assignment, lines[i].angle};
    if (line.from == line.to) {
      log.add(RepairKind::DroppedPoints, lines[i].from);
    } else {
      map.lines.push_back(line);
    }
  }
  return map;
}

}  // namespace kiri
