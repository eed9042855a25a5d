// SPDX-License-Identifier: MIT
#include "core/creases/split_lines.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "core/base/text.h"
#include "core/creases/line_meetings.h"
#include "core/creases/near_points.h"
#include "core/creases/overlaps.h"
#include "core/creases/weld.h"
#include "core/geometry/tolerance.h"

namespace kiri {
namespace {

/// Rounds after which what still crosses is beyond repair: bending a line by a hair may make it
/// cross another, which is rare, and rarer each time.
constexpr int kMostRounds = 24;

/// A point at which a line is to be divided.
struct LineDivision {
  std::uint32_t line = 0;
  double along = 0;
  std::uint32_t point = 0;
  auto operator<=>(const LineDivision&) const = default;
};

void divideLines(LineMap& map, std::vector<LineDivision> divisions) {
  std::sort(divisions.begin(), divisions.end());
  std::vector<MapLine> result;
  result.reserve(map.lines.size() + divisions.size());
  std::size_t next = 0;
  for (std::uint32_t i = 0; i < map.lines.size(); ++i) {
    MapLine piece = map.lines[i];
    const std::uint32_t end = piece.to;
    for (; next < divisions.size() && divisions[next].line == i; ++next) {
      const std::uint32_t point = divisions[next].point;
      if (point == piece.from || point == end) continue;
      piece.to = point;
      result.push_back(piece);
      piece.from = point;
    }
    piece.to = end;
    result.push_back(piece);
  }
  map.lines = std::move(result);
}

std::vector<std::uint32_t> degreesOf(const LineMap& map) {
  std::vector<std::uint32_t> degrees(map.points.size(), 0);
  for (const MapLine& line : map.lines) {
    ++degrees[line.from];
    ++degrees[line.to];
  }
  return degrees;
}

/// How far beside the line a touching point lies.
double besideOf(const LineMap& map, const LineTouch& touch) {
  const MapLine& line = map.lines[touch.line];
  const Vec2 way = map.to(line) - map.from(line);
  return std::abs(cross(way, map.points[touch.point] - map.from(line))) / length(way);
}

/// Loose ends are drawn to the line beside them: along their own line where that is not far.
class LooseEnds {
 public:
  LooseEnds(LineMap& map, double within, double same)
      : map_(map), within_(within), same_(same), degrees_(degreesOf(map)) {
    ownLine_.resize(map.points.size(), 0);
    for (std::uint32_t i = 0; i < map.lines.size(); ++i)
      ownLine_[map.lines[i].from] = ownLine_[map.lines[i].to] = i;
  }

  /// Returns how far the point was moved.
  double draw(const LineTouch& touch) {
    const double beside = besideOf(map_, touch);
    if (degrees_[touch.point] != 1 || beside <= same_) return beside;
    const MapLine& line = map_.lines[touch.line];
    const Vec2 from = map_.from(line);
    const Vec2 way = map_.to(line) - from;
    const MapLine& own = map_.lines[ownLine_[touch.point]];
    Vec2& end = map_.points[touch.point];
    const Vec2 ownWay = map_.to(own) - map_.from(own);
    Vec2 target = lerp(from, map_.to(line), touch.along);
    const double slant = cross(ownWay, way);
    if (std::abs(slant) > kParallel * length(ownWay) * length(way)) {
      const Vec2 meeting = end + ownWay * (cross(from - end, way) / slant);
      const double along = dot(meeting - from, way) / dot(way, way);
      if (distance(meeting, end) <= 2 * within_ && along > 0 && along < 1) target = meeting;
    }
    const double moved = distance(end, target);
    end = target;
    degrees_[touch.point] = 0;  // one line is enough
    return moved;
  }

 private:
  LineMap& map_;
  double within_;
  double same_;
  std::vector<std::uint32_t> degrees_;
  std::vector<std::uint32_t> ownLine_;
};

void divideAtTouches(LineMap& map, const std::vector<LineTouch>& touches, const RepairScale& scale,
                     RepairLog& log) {
  LooseEnds looseEnds(map, scale.within, scale.same);
  std::vector<LineDivision> divisions;
  divisions.reserve(touches.size());
  std::vector<double> moved(map.points.size(), -1);
  for (const LineTouch& touch : touches) {
    const double distance = looseEnds.draw(touch);
    moved[touch.point] = std::max(moved[touch.point], distance);
    divisions.push_back({touch.line, touch.along, touch.point});
  }
  for (std::size_t p = 0; p < moved.size(); ++p) {
    if (moved[p] < 0) continue;
    const bool isBeside = moved[p] > scale.same;
    log.add(isBeside ? RepairKind::MovedToEdge : RepairKind::SplitCrossings, map.points[p],
            isBeside ? moved[p] : 0);
  }
  divideLines(map, std::move(divisions));
}

double alongOf(const LineMap& map, const MapLine& line, Vec2 p) {
  const Vec2 way = map.to(line) - map.from(line);
  return std::clamp(dot(p - map.from(line), way) / dot(way, way), 0.0, 1.0);
}

/// The end of one of two lines that lies where they cross, if there is one.
std::optional<std::uint32_t> endNear(const LineMap& map, const LineCrossing& crossing,
                                     double within) {
  for (const std::uint32_t i : {crossing.first, crossing.second}) {
    for (const std::uint32_t end : {map.lines[i].from, map.lines[i].to}) {
      if (distance(map.points[end], crossing.place) <= within) return end;
    }
  }
  return std::nullopt;
}

void divideAtCrossings(LineMap& map, const std::vector<LineCrossing>& crossings,
                       const RepairScale& scale, RepairLog& log) {
  NearPoints added(map.points.empty() ? Vec2{} : map.points.front(), scale.within);
  const std::size_t before = map.points.size();
  std::vector<LineDivision> divisions;
  divisions.reserve(2 * crossings.size());
  for (const LineCrossing& crossing : crossings) {
    std::optional<std::uint32_t> point = endNear(map, crossing, scale.same);
    if (!point) {
      const std::optional<std::uint32_t> known = added.nearest(crossing.place);
      point = static_cast<std::uint32_t>(before + (known ? *known : added.add(crossing.place)));
      if (!known) {
        map.points.push_back(crossing.place);
        log.add(RepairKind::SplitCrossings, crossing.place);
      }
    }
    for (const std::uint32_t line : {crossing.first, crossing.second})
      divisions.push_back({line, alongOf(map, map.lines[line], map.points[*point]), *point});
  }
  divideLines(map, std::move(divisions));
}

}  // namespace

Status splitLines(LineMap& map, const RepairScale& scale, RepairLog& log,
                  const Progress& progress) {
  for (int round = 0; round < kMostRounds; ++round) {
    // Should bending go on making crossings, it bends by rounding only at the end.
    const double within = round < kMostRounds / 2 ? scale.within : scale.same;
    Result<LineMeetings> found = meetingsOf(map, within, progress);
    if (!found) return found.error();
    if (!found->touches.empty()) {
      divideAtTouches(map, found->touches, {scale.size, scale.same, within}, log);
    } else if (!found->crossings.empty()) {
      divideAtCrossings(map, found->crossings, {scale.size, scale.same, within}, log);
    } else if (!mergeSamePoints(map, scale.same)) {
      return std::monostate{};
    }
    dropOverlaps(map, log);
  }
  const Result<LineMeetings> left = meetingsOf(map, scale.same, progress);
  if (!left) return left.error();
  const Vec2 place = left->crossings.empty() ? Vec2{} : left->crossings.front().place;
  return Error{ErrorCode::BadFile,
               "lines near " + text(place) +
                   " lie so close together that they cannot be told apart; draw that place again",
               {{place}, {}, {}}};
}

}  // namespace kiri
