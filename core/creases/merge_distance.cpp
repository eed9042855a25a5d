// SPDX-License-Identifier: MIT
#include "core/creases/merge_distance.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "core/creases/line_meetings.h"
#include "core/creases/overlaps.h"
#include "core/creases/repair_log.h"
#include "core/creases/weld.h"

namespace kiri {
namespace {

/// Farther than this part of the sheet nothing is merged.
constexpr double kFarthestPart = 1.0 / 300;
/// Where anything is merged, all that is nearer than this many times the kernel's tolerance is:
/// slivers just wider than it make no facets.
constexpr double kLeastTimes = 32;
/// Gaps count up to this many times that distance: beyond it all drawings are empty.
constexpr double kSeenPart = 3;
/// What is merged is shorter than this part of a true line.
constexpr double kPartOfTrueLine = 1.0 / 3;
/// Where no loose end tells anything.
constexpr double kPartOfShortest = 1.0 / 8;
/// Of the lines that a distance would swallow there may be this part of the loose ends it joins.
constexpr double kSwallowedPart = 1.0 / 4;

/// True by point: one line ends there alone. Cuts may: they are slits.
std::vector<bool> looseEnds(const LineMap& map) {
  std::vector<std::uint32_t> degrees(map.points.size(), 0);
  std::vector<bool> isLoose(map.points.size(), false);
  for (const MapLine& line : map.lines) {
    for (const std::uint32_t p : {line.from, line.to}) {
      ++degrees[p];
      isLoose[p] = degrees[p] == 1 && line.assignment != Assignment::Cut;
    }
  }
  return isLoose;
}

std::size_t countUpTo(const std::vector<double>& sorted, double limit) {
  return static_cast<std::size_t>(std::upper_bound(sorted.begin(), sorted.end(), limit) -
                                  sorted.begin());
}

/// Lengths by size, sixteen classes to the octave: enough to see where none are.
class LengthClasses {
 public:
  explicit LengthClasses(double least) : least_(least) {}

  void add(double length) {
    const double octaves = std::log2(std::max(length / least_, 1.0));
    const std::size_t index = static_cast<std::size_t>(octaves * kPerOctave);
    if (index >= classes_.size()) classes_.resize(index + 1);
    LengthClass& c = classes_[index];
    c.low = c.isUsed ? std::min(c.low, length) : length;
    c.high = c.isUsed ? std::max(c.high, length) : length;
    c.isUsed = true;
  }

  /// Calls visit(low, high) for neighbouring lengths with nothing between, from short to long.
  template <class Visit>
  void visitGaps(Visit visit) const {
    const LengthClass* before = nullptr;
    for (const LengthClass& c : classes_) {
      if (!c.isUsed) continue;
      if (before != nullptr) visit(before->high, c.low);
      before = &c;
    }
  }

 private:
  static constexpr double kPerOctave = 16;
  struct LengthClass {
    double low = 0;
    double high = 0;
    bool isUsed = false;
  };
  double least_;
  std::vector<LengthClass> classes_;
};

/// What a drawing shows of its own precision.
struct DrawnPrecision {
  std::vector<double> misses;   ///< of loose ends: how far from the next line, sorted
  std::vector<double> lengths;  ///< of lines, sorted
  LengthClasses all;            ///< both, and all other distances of points from lines
  bool isAnyMiss = false;       ///< even one too small to be among the misses
};

/// The distances of points from lines up to `farthest`, which becomes less where there are too many
/// of them.
Status addDistances(DrawnPrecision& precision, const LineMap& map, const RepairScale& scale,
                    double& farthest, const Progress& progress) {
  constexpr double kNarrower = 64;
  const double least = kLeastTimes * scale.same;
  const std::vector<bool> isLoose = looseEnds(map);
  for (; farthest > scale.same; farthest /= kNarrower) {
    precision.all = LengthClasses(least);
    std::vector<double> nearest(map.points.size(), 2 * farthest);
    const auto see = [&](std::uint32_t point, double distance) {
      nearest[point] = std::min(nearest[point], distance);
      if (distance > least) precision.all.add(distance);
    };
    const Result<bool> areAllSeen = visitNearPairs(map, farthest, see, progress);
    if (!areAllSeen) return areAllSeen.error();
    if (!*areAllSeen) continue;
    for (std::size_t p = 0; p < nearest.size(); ++p) {
      if (!isLoose[p] || nearest[p] <= scale.same || nearest[p] > farthest) continue;
      precision.isAnyMiss = true;
      if (nearest[p] > least) precision.misses.push_back(nearest[p]);
    }
    break;
  }
  std::sort(precision.misses.begin(), precision.misses.end());
  return std::monostate{};
}

void addLengths(DrawnPrecision& precision, const LineMap& map, const RepairScale& scale) {
  for (const MapLine& line : map.lines) {
    const double length = distance(map.from(line), map.to(line));
    if (length <= kLeastTimes * scale.same) continue;
    precision.lengths.push_back(length);
    precision.all.add(length);
  }
  precision.all.add(4 * scale.size);
  std::sort(precision.lengths.begin(), precision.lengths.end());
}

/// The middle of a gap above half of the misses: wide by ratio, with few lines below.
double gapAbove(const DrawnPrecision& precision, double farthest) {
  const double median = precision.misses[(precision.misses.size() - 1) / 2];
  double best = median;
  double most = 0;
  precision.all.visitGaps([&](double low, double high) {
    const double ratio = std::min(high, kSeenPart * farthest) / low;
    if (low < median || low > farthest || ratio <= 1) return;
    const double inGap = std::max(low, std::min(std::sqrt(low * high), high * kPartOfTrueLine));
    const double middle = std::min(inGap, farthest);
    const double swallowed = static_cast<double>(countUpTo(precision.lengths, middle));
    const double joined = static_cast<double>(countUpTo(precision.misses, middle));
    const double worth = ratio / ((1 + swallowed) * (1 + swallowed));
    if (swallowed > kSwallowedPart * joined || worth <= most) return;
    most = worth;
    best = middle;
  });
  return best;
}

}  // namespace

Result<double> mergeDistanceOf(const std::vector<DrawnCrease>& lines, const RepairScale& scale,
                               const Progress& progress) {
  RepairLog ignored;
  LineMap map = weld(lines, {scale.size, scale.same, scale.same}, ignored);
  dropOverlaps(map, ignored);
  if (map.lines.empty()) return scale.same;
  double farthest = kFarthestPart * scale.size;
  const double least = kLeastTimes * scale.same;
  DrawnPrecision precision{{}, {}, LengthClasses(least), false};
  const Status added = addDistances(precision, map, scale, farthest, progress);
  if (!added) return added.error();
  addLengths(precision, map, scale);
  if (!precision.misses.empty()) return std::max(gapAbove(precision, farthest), least);
  if (!precision.isAnyMiss) {
    const Result<LineMeetings> meetings = meetingsOf(map, scale.same, progress);
    if (!meetings) return meetings.error();
    if (meetings->touches.empty() && meetings->crossings.empty()) return scale.same;
  }
  if (precision.lengths.empty()) return least;
  const double shortest = precision.lengths.front();
  const double between = std::min(std::sqrt(scale.same * shortest), shortest * kPartOfShortest);
  return std::max(least, std::min(between, farthest));
}

}  // namespace kiri
