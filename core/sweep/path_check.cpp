// Between moments facets are certified apart, or moments between are looked at.
// SPDX-License-Identifier: MIT
#include "core/sweep/path_check.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

#include "core/geometry/convex.h"
#include "core/layers/plane_view.h"
#include "core/sweep/facet_shapes.h"
#include "core/sweep/found.h"
#include "core/sweep/plate.h"

namespace kiri {
namespace {

constexpr double kStray = 1.25;     // of its way, that a point may stray between two moments
constexpr double kMostTurn = 0.85;  // cosine of the turn beyond which this is not trusted
constexpr int kEndLevels = 10;      // halvings of the first and last moments for facets in contact
constexpr int kMostLevels = 24;     // halvings of any moment
constexpr int kMostLooks = 150;     // at one pair between two given moments
constexpr std::size_t kMostPosed = 12;  // moments looked at for each that was given
constexpr int kMostDivisions = 24;      // of a facet into strips, halving the way of the slow one
constexpr int kFastDivisions = 2;       // of the fast one
constexpr int kBracketing = 30;         // halvings that bracket the first crossing

using Pair = std::pair<FacetId, FacetId>;

Rigid inverseOf(const Rigid& r) {
  Rigid back{{r.x.x, r.y.x, r.z.x}, {r.x.y, r.y.y, r.z.y}, {r.x.z, r.y.z, r.z.z}, {}};
  back.origin = -back.direction(r.origin);
  return back;
}

struct Box3 {
  Vec3 low{HUGE_VAL, HUGE_VAL, HUGE_VAL};
  Vec3 high{-HUGE_VAL, -HUGE_VAL, -HUGE_VAL};

  void add(Vec3 p) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
  }
  bool meets(const Box3& o) const {
    return low.x <= o.high.x && o.low.x <= high.x && low.y <= o.high.y && o.low.y <= high.y &&
           low.z <= o.high.z && o.low.z <= high.z;
  }
};

struct Meeting {
  double part = 0;
  Pair pair;
  Vec3 place;
};

class PathChecker {
 public:
  PathChecker(const FoldedState& start, const PosesAt& posesAt)
      : start_(start),
        posesAt_(posesAt),
        pieces_(start.pattern),
        hulls_(start.pattern, FacetDetail::Hull),
        deep_(kDoubtful * start.tolerance().match()) {}

  PathReport run(const std::vector<double>& moments, const Progress& progress) {
    end_ = moments.back();
    mostPosed_ = kMostPosed * moments.size();
    for (std::size_t i = 0; i + 1 < moments.size() && !certain_; ++i) {
      if (!goesOn(progress, moments[i])) {
        doubt({moments[i], {FacetId(std::size_t{0}), FacetId(std::size_t{0})}, {}});
        break;
      }
      known_.erase(known_.begin(), known_.lower_bound(moments[i]));
      for (const Pair& pair : nearPairs(moments[i], moments[i + 1])) {
        if (!areHullsApart(pair, moments[i], moments[i + 1])) {
          looks_ = 0;
          look(pair, moments[i], moments[i + 1], 0);
        }
      }
    }
    const std::optional<Meeting>& met = certain_ ? certain_ : doubtful_;
    if (!met) return {};
    return {certain_ ? SweepVerdict::Collides : SweepVerdict::Undecided, met->part, met->pair.first,
            met->pair.second, met->place};
  }

 private:
  /// Poses of one facet in the frame of another, before and after.
  struct Relative {
    Rigid before;
    Rigid after;

    /// No greater turn than one along which a way is nearly straight.
    bool isSmall() const {
      const double trace = dot(before.x, after.x) + dot(before.y, after.y) + dot(before.z, after.z);
      return (trace - 1) / 2 >= kMostTurn;
    }
    double wayOf(Vec2 p) const { return distance(before.apply(p), after.apply(p)); }
    double wayOf(const std::vector<Vec2>& piece) const {
      double way = 0;
      for (const Vec2 p : piece) way = std::max(way, wayOf(p));
      return way;
    }
    std::pair<std::vector<Vec2>, std::vector<Vec2>> divided(const std::vector<Vec2>& piece,
                                                            double eps) const;
  };
  /// What is known of a pair between two moments.
  struct Nearness {
    bool isApart = true;
    double way = 0;            ///< the longest of a point of one in the frame of the other, mm
    double before = HUGE_VAL;  ///< distance, or a lower bound where that is enough
    double after = HUGE_VAL;
  };

  const std::vector<Rigid>& at(double part) {
    const auto known = known_.find(part);
    if (known != known_.end()) return known->second;
    ++posed_;
    return known_.emplace(part, part == 0 ? start_.poses : posesAt_(part)).first->second;
  }

  void doubt(const Meeting& meeting) {
    if (!doubtful_ || meeting.part < doubtful_->part) doubtful_ = meeting;
  }

  std::vector<Plate> platesOf(const Pieces& pieces, FacetId facet, double part) {
    std::vector<Plate> plates;
    for (const std::vector<Vec2>& piece : pieces)
      plates.push_back(plateOf(piece, at(part)[facet.index]));
    return plates;
  }

  std::vector<Pair> nearPairs(double from, double to);
  bool areHullsApart(const Pair& pair, double from, double to);
  double depthAt(const Pair& pair, double part, Vec3& place);
  Relative relative(const Pair& pair, double from, double to);
  Nearness nearness(const Pair& pair, double from, double to);
  static double distanceTo(const std::vector<Plate>& others, const std::vector<Vec2>& piece,
                           const Rigid& pose, double enough);
  void look(const Pair& pair, double from, double to, int level);
  void bracket(const Pair& pair, double from, double to);
  void lookAtStart(const Pair& pair, double after);
  bool lieOnEachOther(const Pair& pair, double part);
  void doubtAt(const Pair& pair, double part) {
    doubt({part, pair, at(part)[pair.first.index].apply(shapes_->piecesOf(pair.first)[0][0])});
  }

  const FoldedState& start_;
  const PosesAt& posesAt_;
  FacetShapes pieces_;
  FacetShapes hulls_;
  const FacetShapes* shapes_ = &pieces_;  ///< which of them are looked at
  double deep_;                           ///< what passes deeper is a certain crossing, mm
  std::map<double, std::vector<Rigid>> known_;
  double end_ = 1;
  std::size_t posed_ = 0;      ///< moments for which poses were asked
  std::size_t mostPosed_ = 0;  ///< beyond so many, no moments between the given ones are looked at
  int looks_ = 0;
  std::optional<Meeting> certain_;
  std::optional<Meeting> doubtful_;
};

/// Pairs that have no common hinge and may come near each other between two moments.
std::vector<Pair> PathChecker::nearPairs(double from, double to) {
  std::vector<Box3> boxes(shapes_->size());
  std::vector<std::size_t> order;
  for (std::size_t f = 0; f < boxes.size(); ++f) {
    double way = 0;
    for (const std::vector<Vec2>& piece : shapes_->piecesOf(FacetId(f))) {
      for (const Vec2 p : piece) {
        const Vec3 a = at(from)[f].apply(p);
        const Vec3 b = at(to)[f].apply(p);
        boxes[f].add(a);
        boxes[f].add(b);
        way = std::max(way, distance(a, b));
      }
    }
    const double wide = (kStray - 1) * way + deep_;
    boxes[f].add(boxes[f].low - Vec3{wide, wide, wide});
    boxes[f].add(boxes[f].high + Vec3{wide, wide, wide});
    order.push_back(f);
  }
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return boxes[a].low.x != boxes[b].low.x ? boxes[a].low.x < boxes[b].low.x : a < b;
  });
  std::vector<Pair> pairs;
  for (std::size_t i = 0; i < order.size(); ++i) {
    for (std::size_t j = i + 1; j < order.size(); ++j) {
      if (boxes[order[j]].low.x > boxes[order[i]].high.x) break;
      const FacetId a(std::min(order[i], order[j]));
      const FacetId b(std::max(order[i], order[j]));
      if (boxes[a.index].meets(boxes[b.index]) && !shapes_->shareHinge(a, b))
        pairs.push_back({a, b});
    }
  }
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

/// Facets of many pieces, as curved cuts leave them, are first looked at as a whole: where their
/// hulls pass each other, so do they.
bool PathChecker::areHullsApart(const Pair& pair, double from, double to) {
  const auto isWhole = [&](FacetId f) { return pieces_.piecesOf(f).size() == 1; };
  if (isWhole(pair.first) && isWhole(pair.second)) return false;
  const std::optional<Meeting> certain = certain_;
  const std::optional<Meeting> doubtful = std::exchange(doubtful_, std::nullopt);
  const std::size_t posed = posed_;
  looks_ = 0;
  shapes_ = &hulls_;
  Vec3 place;
  // Of hulls that cross already nothing is told: that was found before, and forgotten.
  const bool areCrossing = depthAt(pair, from, place) > start_.tolerance().match();
  if (!areCrossing) look(pair, from, to, 0);
  shapes_ = &pieces_;
  const auto partOf = [](const std::optional<Meeting>& m) { return m ? m->part : HUGE_VAL; };
  const bool isApart = !areCrossing && !doubtful_ && partOf(certain_) == partOf(certain);
  doubtful_ = doubtful;
  if (isApart) return true;
  certain_ = certain;
  posed_ = posed;
  return false;
}

double PathChecker::depthAt(const Pair& pair, double part, Vec3& place) {
  const auto& [first, second] = shapes_->pairOf(pair.first, pair.second);
  const std::vector<Plate> others = platesOf(second, pair.second, part);
  double deepest = 0;
  for (const Plate& plate : platesOf(first, pair.first, part)) {
    for (const Plate& other : others) {
      Vec3 here;
      const double depth = crossingDepth(plate, other, here);
      if (depth <= deepest) continue;
      deepest = depth;
      place = here;
    }
  }
  return deepest;
}

/// The piece in two across the direction in which ways differ most: what moves less, what more.
std::pair<std::vector<Vec2>, std::vector<Vec2>> PathChecker::Relative::divided(
    const std::vector<Vec2>& piece, double eps) const {
  const Vec3 alongX = after.x - before.x;
  const Vec3 alongY = after.y - before.y;
  const double p = dot(alongX, alongX);
  const double q = dot(alongX, alongY);
  const double r = dot(alongY, alongY);
  const double most = (p + r + std::sqrt((p - r) * (p - r) + 4 * q * q)) / 2;
  const Vec2 direction = p > r ? Vec2{most - r, q} : Vec2{q, most - p};
  if (length(direction) == 0) return {};
  const Vec2 u = normalized(direction);
  const auto [least, greatest] = std::minmax_element(
      piece.begin(), piece.end(), [&](Vec2 a, Vec2 b) { return wayOf(a) < wayOf(b); });
  const double from = dot(u, *least);
  const double to = dot(u, *greatest);
  const Vec2 a = u * ((from + to) / 2);
  const Vec2 b = a + (to > from ? perpendicular(u) : -perpendicular(u));
  return {clipLeft(piece, a, b, eps), clipLeft(piece, b, a, eps)};
}

/// How the first facet of a pair moves in the frame of the second between two moments.
PathChecker::Relative PathChecker::relative(const Pair& pair, double from, double to) {
  return {compose(inverseOf(at(from)[pair.second.index]), at(from)[pair.first.index]),
          compose(inverseOf(at(to)[pair.second.index]), at(to)[pair.first.index])};
}

double PathChecker::distanceTo(const std::vector<Plate>& others, const std::vector<Vec2>& piece,
                               const Rigid& pose, double enough) {
  const Plate plate = plateOf(piece, pose);
  double least = HUGE_VAL;
  for (const Plate& other : others)
    least = std::min(least, distanceBetween(plate, other, std::min(enough, least)));
  return least;
}

/// Whether the pair is apart all the time between two moments, or moves alike. What moves little
/// may be near, what moves far is perhaps far away: a facet that touches another in an axis is cut
/// into strips along it, each looked at alone.
PathChecker::Nearness PathChecker::nearness(const Pair& pair, double from, double to) {
  const auto& [first, second] = shapes_->pairOf(pair.first, pair.second);
  const Relative motion = relative(pair, from, to);
  const std::vector<Plate> otherBefore = platesOf(second, pair.second, from);
  const std::vector<Plate> otherAfter = platesOf(second, pair.second, to);
  struct Strip {
    std::vector<Vec2> piece;
    int divisions;
  };
  std::vector<Strip> strips;
  for (const std::vector<Vec2>& piece : first) strips.push_back({piece, kMostDivisions});
  Nearness result;
  while (!strips.empty()) {
    const Strip strip = std::move(strips.back());
    strips.pop_back();
    const bool isWhole = strip.divisions == kMostDivisions;
    const double way = motion.wayOf(strip.piece);
    if (isWhole) result.way = std::max(result.way, way);
    if (way <= start_.tolerance().match()) continue;
    const double enough = motion.isSmall() ? kStray * way : HUGE_VAL;
    const double before = distanceTo(otherBefore, strip.piece, at(from)[pair.first.index], enough);
    const double after =
        before > enough ? before
                        : distanceTo(otherAfter, strip.piece, at(to)[pair.first.index], enough);
    if (isWhole) {
      result.before = std::min(result.before, before);
      result.after = std::min(result.after, after);
    }
    if (before > enough || before + after > enough) continue;
    auto [slow, fast] = motion.divided(strip.piece, start_.tolerance().length());
    if (!motion.isSmall() || strip.divisions == 0 || slow.empty() || fast.empty()) {
      result.isApart = false;
      if (isWhole) continue;
      return result;
    }
    // If strips help, the fast one is soon apart: it comes first.
    strips.push_back({std::move(slow), strip.divisions - 1});
    strips.push_back({std::move(fast), std::min(strip.divisions - 1, kFastDivisions)});
  }
  return result;
}

void PathChecker::look(const Pair& pair, double from, double to, int level) {
  if (certain_ && certain_->part <= from) return;
  const double touch = start_.tolerance().match();
  Vec3 place;
  const double depth = depthAt(pair, to, place);
  if (depth > deep_) return bracket(pair, from, to);
  const Nearness near = nearness(pair, from, to);
  if (near.way <= touch) {
    // They move alike, or have come as near to the moment of a touch as matters: then only what
    // lies flat on the other could slip through unseen.
    if (level > 0 && lieOnEachOther(pair, to)) doubtAt(pair, from);
    return;
  }
  if (near.isApart && depth <= touch) return;
  if (level >= kEndLevels && from == 0 && near.before <= touch) return lookAtStart(pair, to);
  if (level >= kEndLevels && to == end_ && near.after <= touch) return;
  if (depth > touch || level >= kMostLevels || posed_ > mostPosed_ || ++looks_ > kMostLooks) {
    doubtAt(pair, from);
    return;
  }
  const double middle = (from + to) / 2;
  look(pair, from, middle, level + 1);
  look(pair, middle, to, level + 1);
}

bool PathChecker::lieOnEachOther(const Pair& pair, double part) {
  const Rigid& ground = at(part)[pair.second.index];
  for (const std::vector<Vec2>& piece : shapes_->piecesOf(pair.first)) {
    for (const Vec2 p : piece) {
      const Vec3 there = at(part)[pair.first.index].apply(p);
      if (std::abs(dot(ground.normal(), there - ground.origin)) > deep_) return false;
    }
  }
  return PlaneView(start_.pattern, at(part), ground).doOverlap(pair.first, pair.second);
}

/// The first moment at which the pair is seen to cross, knowing that it does at `to`.
void PathChecker::bracket(const Pair& pair, double from, double to) {
  Vec3 place;
  if (depthAt(pair, from, place) > deep_) return;  // it did so already at the start
  for (int i = 0; i < kBracketing; ++i) {
    const double middle = (from + to) / 2;
    (depthAt(pair, middle, place) > deep_ ? to : from) = middle;
  }
  depthAt(pair, to, place);
  if (!certain_ || to < certain_->part) certain_ = Meeting{to, pair, place};
}

/// Facets that lie on each other at the start must leave to the side on which they lie.
void PathChecker::lookAtStart(const Pair& pair, double after) {
  const auto [a, b] = pair;
  if (!start_.layers.areCoplanar(a, b)) return;
  const LayerSet& set = start_.layers.sets()[start_.layers.setOf(a)];
  const Rigid& ground = start_.poseOf(b);
  PlaneView view(start_.pattern, start_.poses, ground);
  const bool isFrontUp = dot(ground.normal(), set.normal) > 0;
  const double side = start_.layers.isAbove(a, b) == isFrontUp ? 1 : -1;
  double worst = 0;
  Vec3 place;
  for (const FootprintPart& above : view.footprint(a).parts) {
    for (const FootprintPart& below : view.footprint(b).parts) {
      if (!overlap(above.points, below.points, start_.tolerance().fat())) continue;
      for (const Vec2 p : intersection(above.points, below.points, start_.tolerance().length())) {
        const Vec2 onA = start_.poseOf(a).pullBack(ground.apply(p));
        const Rigid& then = at(after)[b.index];
        const Vec3 there = at(after)[a.index].apply(onA);
        const double height = side * dot(then.normal(), there - then.origin);
        if (height >= worst) continue;
        worst = height;
        place = there;
      }
    }
  }
  if (-worst > deep_) {
    if (!certain_ || certain_->part > 0) certain_ = Meeting{0, pair, place};
  } else if (-worst > start_.tolerance().match()) {
    doubt({0, pair, place});
  }
}

}  // namespace

PathReport checkPath(const FoldedState& start, const PosesAt& posesAt,
                     const std::vector<double>& moments, const Progress& progress) {
  return PathChecker(start, posesAt).run(moments, progress);
}

}  // namespace kiri
