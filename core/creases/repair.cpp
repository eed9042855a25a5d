// SPDX-License-Identifier: MIT
#include "core/creases/repair.h"

#include <algorithm>
#include <cmath>

#include "core/base/text.h"
#include "core/creases/build_pattern.h"
#include "core/creases/map_faces.h"
#include "core/creases/map_paper.h"
#include "core/creases/outline.h"
#include "core/creases/repair_log.h"
#include "core/creases/split_lines.h"
#include "core/creases/weld.h"
#include "core/geometry/tolerance.h"

namespace kiri {
namespace {

/// The faces of a line map and which of them are paper.
struct PaperMap {
  MapFaces faces;
  std::vector<bool> isPaper;

  bool hasPaper() const { return std::find(isPaper.begin(), isPaper.end(), true) != isPaper.end(); }
};

RepairScale scaleOf(const std::vector<DrawnCrease>& lines, const RepairOptions& options) {
  Vec2 low = lines.front().from;
  Vec2 high = low;
  for (const DrawnCrease& line : lines) {
    for (const Vec2 p : {line.from, line.to}) {
      low = {std::min(low.x, p.x), std::min(low.y, p.y)};
      high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    }
  }
  RepairScale scale;
  scale.size = distance(low, high);
  scale.same = Tolerance(scale.size).length();
  scale.within = options.merge > 0 ? options.merge : scale.same;
  return scale;
}

/// Where the paper is, as the drawing's faces say, or its borders; where neither says anything, all
/// that lines enclose, if they show their own outline.
PaperMap paperMapOf(const LineMap& map, const CreaseDrawing& drawing, const RepairScale& scale) {
  PaperMap paper;
  paper.faces = facesOf(map);
  if (!drawing.faces.empty()) {
    PaperOfFaces drawn = paperOfFaces(map, paper.faces, drawing.faces, scale.within);
    paper.isPaper = std::move(drawn.isPaper);
    if (drawn.misfits.empty()) return paper;
  }
  paper.isPaper = paperWithin(map, paper.faces);
  if (paper.hasPaper() || !showOutline(paper.faces, map.lines.size())) return paper;
  paper.isPaper.assign(paper.faces.count(), true);
  paper.isPaper[0] = false;
  return paper;
}

/// The map divided along its lines, with paper; an outline is added where there is none.
Result<PaperMap> settle(LineMap& map, const CreaseDrawing& drawing, const RepairScale& scale,
                        RepairLog& log, const Progress& progress) {
  if (const Status split = splitLines(map, scale, log, progress); !split) return split.error();
  PaperMap paper = paperMapOf(map, drawing, scale);
  if (paper.hasPaper()) return paper;
  const std::vector<MapLine> hull = hullOf(map);
  for (const MapLine& side : hull) {
    log.add(RepairKind::AddedBorder, lerp(map.from(side), map.to(side), 0.5));
    map.lines.push_back(side);
  }
  dropOverlaps(map, log);
  if (const Status split = splitLines(map, scale, log, progress); !split) return split.error();
  return paperMapOf(map, drawing, scale);
}

/// Creases with one face on both sides do not divide it. Returns whether there were any.
bool dropDangling(LineMap& map, const PaperMap& paper, RepairLog& log) {
  std::vector<MapLine> kept;
  for (std::size_t i = 0; i < map.lines.size(); ++i) {
    const MapLine& line = map.lines[i];
    const bool isSlit = line.assignment == Assignment::Border || line.assignment == Assignment::Cut;
    const std::uint32_t face = paper.faces.left(i);
    if (isSlit || face != paper.faces.right(i) || !paper.isPaper[face]) {
      kept.push_back(line);
    } else {
      log.add(RepairKind::DroppedDangling, lerp(map.from(line), map.to(line), 0.5));
    }
  }
  const bool isAny = kept.size() < map.lines.size();
  map.lines = std::move(kept);
  return isAny;
}

}  // namespace

Result<RepairedPattern> patternOf(const CreaseDrawing& drawing, const RepairOptions& options,
                                  const Progress& progress) {
  RepairLog log;
  const std::vector<DrawnCrease> lines = soundLines(drawing, log);
  if (lines.empty())
    return Error{ErrorCode::BadFile, "the crease pattern has no lines; draw a border and creases"};
  const RepairScale scale = scaleOf(lines, options);
  LineMap map = weld(lines, scale, log);
  dropOverlaps(map, log);
  Result<PaperMap> settled = settle(map, drawing, scale, log, progress);
  if (!settled) return settled.error();
  PaperMap& paper = *settled;
  if (dropDangling(map, paper, log)) paper = paperMapOf(map, drawing, scale);
  if (!paper.hasPaper())
    return Error{ErrorCode::BadFile,
                 "the lines of the crease pattern enclose no paper; draw a closed border"};
  RepairedPattern result{buildPattern(map, paper.faces, paper.isPaper, options.scale, log), {}, 0};
  result.repairs = log.repairs();
  result.mergedWithin = scale.within;
  return result;
}

}  // namespace kiri
