// SPDX-License-Identifier: MIT
#include "core/creases/repair.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "core/base/text.h"
#include "core/creases/build_pattern.h"
#include "core/creases/map_faces.h"
#include "core/creases/map_paper.h"
#include "core/creases/merge_distance.h"
#include "core/creases/outline.h"
#include "core/creases/overlaps.h"
#include "core/creases/repair_log.h"
#include "core/creases/split_lines.h"
#include "core/creases/weld.h"
#include "core/geometry/bounds.h"
#include "core/geometry/tolerance.h"

namespace kiri {
namespace {

/// What is merged at least where anything is, as a part of what rounding explains.
constexpr double kFinestTimes = 32;

/// The faces of a line map and which of them are paper.
struct PaperMap {
  MapFaces faces;
  std::vector<bool> isPaper;
  std::vector<std::uint32_t> misfits;  ///< faces of the drawing that are not followed

  bool hasPaper() const { return std::find(isPaper.begin(), isPaper.end(), true) != isPaper.end(); }
};

Result<RepairScale> scaleOf(const std::vector<DrawnCrease>& lines, const RepairOptions& options,
                            const Progress& progress) {
  Box box{lines.front().from, lines.front().from};
  for (const DrawnCrease& line : lines) box = joined(joined(box, line.from), line.to);
  RepairScale scale;
  scale.size = distance(box.low, box.high);
  // Far away from zero doubles are coarser than the kernel's tolerance.
  const double farAway = std::max(length(box.low), length(box.high));
  scale.same = std::max(Tolerance(scale.size).length(),
                        8 * std::numeric_limits<double>::epsilon() * farAway);
  scale.within = std::max(scale.same, options.merge);
  if (options.merge > 0) return scale;
  const Result<double> found = mergeDistanceOf(lines, scale, progress);
  if (!found) return found.error();
  scale.within = *found;
  return scale;
}

/// One drawing on its way to a pattern.
class DrawingRepair {
 public:
  DrawingRepair(const CreaseDrawing& drawing, const RepairScale& scale, RepairLog& log,
                const Progress& progress)
      : drawing_(drawing), scale_(scale), log_(log), progress_(progress) {}

  /// Lines that meet at their ends only, faces on both sides of each, paper on one at least.
  Status run(const std::vector<DrawnCrease>& lines) {
    map_ = weld(lines, scale_, log_);
    dropOverlaps(map_, log_);
    if (Status split = splitLines(map_, scale_, log_, progress_); !split) return split;
    findPaper();
    if (!paper_.hasPaper()) {
      if (Status outlined = addOutline(); !outlined) return outlined;
    }
    // What is left out may let lines be straight again that then meet others: look again.
    for (bool isClean = false; !isClean;) {
      const Result<bool> dropped = dropUseless();
      if (!dropped) return dropped.error();
      isClean = !*dropped;
    }
    for (const std::uint32_t face : paper_.misfits) tellMisfit(face);
    return std::monostate{};
  }

  const LineMap& map() const { return map_; }
  const PaperMap& paper() const { return paper_; }

 private:
  /// Paper is where the drawing's faces are, else what borders enclose, else cuts, else all that
  /// lines enclose if they show their own outline.
  void findPaper() {
    paper_ = {};
    paper_.faces = facesOf(map_);
    if (!drawing_.faces.empty()) {
      PaperOfFaces drawn = paperOfFaces(map_, paper_.faces, drawing_.faces, scale_.within);
      paper_.isPaper = std::move(drawn.isPaper);
      paper_.misfits = std::move(drawn.misfits);
      if (paper_.misfits.empty()) return;
    }
    for (const Assignment rim : {Assignment::Border, Assignment::Cut}) {
      paper_.isPaper = paperWithin(map_, paper_.faces, rim);
      if (paper_.hasPaper()) return;
    }
    if (!showOutline(paper_.faces, map_.lines.size())) return;
    paper_.isPaper.assign(paper_.faces.count(), true);
    paper_.isPaper[0] = false;
  }

  Status addOutline() {
    for (const MapLine& side : hullOf(map_)) {
      log_.add(RepairKind::AddedBorder, lerp(map_.from(side), map_.to(side), 0.5));
      map_.lines.push_back(side);
    }
    // What lies on the hull becomes part of it: that is told above.
    RepairLog ignored;
    dropOverlaps(map_, ignored);
    if (Status split = splitLines(map_, scale_, ignored, progress_); !split) return split;
    findPaper();
    if (paper_.hasPaper()) return std::monostate{};
    return Error{ErrorCode::BadFile,
                 "the " + std::to_string(map_.lines.size()) +
                     " lines of the crease pattern enclose no paper; draw a closed border"};
  }

  /// Leaves out creases with one face on both sides, which divide nothing, and lines without paper.
  /// Returns whether there were any.
  Result<bool> dropUseless() {
    std::vector<bool> parted(map_.points.size(), false);
    std::vector<MapLine> kept;
    for (std::size_t i = 0; i < map_.lines.size(); ++i) {
      const MapLine& line = map_.lines[i];
      const std::uint32_t left = paper_.faces.left(i);
      const std::uint32_t right = paper_.faces.right(i);
      const bool isSlit =
          line.assignment == Assignment::Border || line.assignment == Assignment::Cut;
      const bool hasPaper = paper_.isPaper[left] || paper_.isPaper[right];
      if (hasPaper && (left != right || isSlit)) {
        kept.push_back(line);
        continue;
      }
      parted[line.from] = parted[line.to] = true;
      log_.add(hasPaper ? RepairKind::DroppedDangling : RepairKind::DroppedOutside,
               lerp(map_.from(line), map_.to(line), 0.5));
    }
    if (kept.size() == map_.lines.size()) return false;
    map_.lines = std::move(kept);
    if (joinPieces(map_, parted, log_)) {
      // A line that was bent a hair at what is gone now is straight again.
      RepairLog ignored;
      if (const Status split = splitLines(map_, scale_, ignored, progress_); !split)
        return split.error();
    }
    findPaper();
    return true;
  }

  void tellMisfit(std::uint32_t face) {
    Vec2 sum;
    double count = 0;
    for (const Vec2 corner : drawing_.faces[face]) {
      if (!std::isfinite(corner.x) || !std::isfinite(corner.y)) continue;
      sum = sum + corner;
      ++count;
    }
    log_.add(RepairKind::IgnoredFaces, count > 0 ? sum / count : Vec2{});
  }

  const CreaseDrawing& drawing_;
  const RepairScale& scale_;
  RepairLog& log_;
  const Progress& progress_;
  LineMap map_;
  PaperMap paper_;
};

/// `log`: what was told of the lines before.
Result<RepairedPattern> repairedAt(const RepairScale& scale, const CreaseDrawing& drawing,
                                   const std::vector<DrawnCrease>& lines,
                                   const RepairOptions& options, RepairLog log,
                                   const Progress& progress) {
  DrawingRepair repair(drawing, scale, log, progress);
  if (const Status done = repair.run(lines); !done) return done.error();
  const PaperMap& paper = repair.paper();
  if (repair.map().lines.empty() || !paper.hasPaper()) {
    return Error{ErrorCode::BadFile,
                 "the lines of the crease pattern enclose no paper once they are mended; draw a "
                 "closed border"};
  }
  RepairedPattern result{
      buildPattern(repair.map(), paper.faces, paper.isPaper, options.scale, log), {}, 0};
  result.repairs = log.repairs();
  result.mergedWithin = scale.within;
  return result;
}

}  // namespace

Result<RepairedPattern> patternOf(const CreaseDrawing& drawing, const RepairOptions& options,
                                  const Progress& progress) {
  if (!(options.scale > 0) || !std::isfinite(options.scale))
    return Error{ErrorCode::BadValue, "the size of a unit, " + text(options.scale) +
                                          " mm, is not a positive number; give one"};
  RepairLog log;
  const std::vector<DrawnCrease> lines = soundLines(drawing, log);
  if (lines.empty())
    return Error{ErrorCode::BadFile, "the crease pattern has no lines; draw a border and creases"};
  const Result<RepairScale> scale = scaleOf(lines, options, progress);
  if (!scale) return scale.error();
  Result<RepairedPattern> result = repairedAt(*scale, drawing, lines, options, log, progress);
  // A tangle that merging far makes worse may come apart when only rounding is mended.
  if (result || result.error().code != ErrorCode::BadFile || options.merge > 0) return result;
  RepairScale finer = *scale;
  finer.within = std::min(scale->within, kFinestTimes * scale->same);
  if (finer.within == scale->within) return result;
  Result<RepairedPattern> again = repairedAt(finer, drawing, lines, options, log, progress);
  return again ? std::move(again) : std::move(result);
}

}  // namespace kiri
