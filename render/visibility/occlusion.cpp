// Leaves out the facets that nothing is seen of.
// SPDX-License-Identifier: MIT
#include "render/visibility/occlusion.h"

#include <algorithm>
#include <span>
#include <utility>

#include "core/geometry/convex.h"
#include "render/visibility/grid.h"

namespace kiri {
namespace {

using Polygon = std::vector<Vec2>;

/// A kept facet, and its convex parts once something has asked for them.
struct Occluder {
  std::uint32_t number = 0;
  bool hasParts = false;
  std::vector<Polygon> parts;
  std::vector<Box> boxes;
};

Box boxOf(std::span<const Vec2> polygon) {
  Box box{polygon.front(), polygon.front()};
  for (const Vec2 p : polygon) box = joined(box, {p, p});
  return box;
}

std::vector<Polygon> partsOf(const FacetView& view, const Tolerance& tolerance) {
  std::vector<Polygon> out;
  if (view.isConvex) {
    Polygon& polygon = out.emplace_back();
    for (const Arc& arc : view.arcs) polygon.push_back(arc.start);
    return out;
  }
  for (ConvexPart& part : convexParts(view.region(), tolerance)) {
    out.push_back(std::move(part.points));
  }
  return out;
}

/// Two facets whose borders are the same but for rounding, as in stacks that were cut together.
bool haveSameOutline(const FacetView& a, const FacetView& b, double eps) {
  const std::size_t n = a.arcs.size();
  if (n != b.arcs.size() || a.loopStarts.size() != 1 || b.loopStarts.size() != 1) return false;
  for (std::size_t shift = 0; shift < n; ++shift) {
    if (distance(a.arcs[0].start, b.arcs[shift].start) > eps) continue;
    std::size_t i = 0;
    for (; i < n; ++i) {
      const Arc& p = a.arcs[i];
      const Arc& q = b.arcs[(shift + i) % n];
      if (p.isCurved != q.isCurved || distance(p.start, q.start) > eps) break;
      if (p.isCurved &&
          (distance(p.control1, q.control1) > eps || distance(p.control2, q.control2) > eps))
        break;
    }
    if (i == n) return true;
  }
  return false;
}

class Occlusion {
 public:
  explicit Occlusion(const FacetViews& views)
      : views_(views), eps_(views.tolerance().match()), grid_(makeGrid(views)) {
    stamps_.assign(views.all().size(), 0);
  }

  std::vector<std::uint32_t> run() {
    const auto& all = views_.all();
    std::vector<std::uint32_t> kept;
    for (std::uint32_t i = 0; i < all.size(); ++i) {
      if (isHidden(i)) continue;
      kept.push_back(i);
      grid_.addBox(all[i].box, static_cast<std::uint32_t>(occluders_.size()));
      occluders_.push_back({i, false, {}, {}});
    }
    return kept;
  }

 private:
  static Grid makeGrid(const FacetViews& views) {
    const auto& all = views.all();
    if (all.empty()) return Grid({}, {}, 1);
    Box box = all.front().box;
    Vec2 sum;
    for (const FacetView& view : all) {
      box = joined(box, view.box);
      sum = sum + (view.box.high - view.box.low);
    }
    return Grid(box, sum / static_cast<double>(all.size()), all.size());
  }

  /// True when `a` is over `b` at every corner of the place where both are.
  bool isOverAll(const FacetView& a, const FacetView& b, std::span<const Vec2> place) const {
    if (a.set == b.set) return views_.isOver(a, b, {}, {});
    const double slack = views_.depthTolerance(a, b);
    bool isAhead = false;
    for (const Vec2 p : place) {
      const double ahead = a.depthAt(p) - b.depthAt(p);
      if (ahead < -slack) return false;
      if (ahead > slack) isAhead = true;
    }
    return isAhead;
  }

  bool mayHide(const Occluder& occluder, const FacetView& facet) const {
    const FacetView& over = views_.all()[occluder.number];
    if (!boxesMeet(over.box, facet.box, eps_)) return false;
    return over.set != facet.set || views_.isOver(over, facet, {}, {});
  }

  void collect(std::uint32_t number) {
    const FacetView& facet = views_.all()[number];
    near_.clear();
    ++stamp_;
    grid_.visit(facet.box, [&](std::uint32_t o) {
      if (stamps_[o] == stamp_) return;
      stamps_[o] = stamp_;
      if (mayHide(occluders_[o], facet)) near_.push_back(&occluders_[o]);
    });
    exceptions_.clear();
    for (const std::uint32_t over : views_.exceptionsOver(number)) {
      exceptions_.push_back({over, false, {}, {}});
    }
    for (Occluder& occluder : exceptions_) {
      if (mayHide(occluder, facet)) near_.push_back(&occluder);
    }
  }

  /// One occluder alone covers the facet: the usual end of a layer deep in a stack.
  bool isInside(const FacetView& facet, const FacetView& over) const {
    if (over.set != facet.set || !boxesMeet(grown(over.box, eps_), facet.box, 0)) return false;
    const Box b = grown(over.box, eps_);
    if (facet.box.low.x < b.low.x || facet.box.low.y < b.low.y || facet.box.high.x > b.high.x ||
        facet.box.high.y > b.high.y) {
      return false;
    }
    if (!over.isConvex) return haveSameOutline(facet, over, eps_);
    for (const Arc& side : over.arcs) {
      if (distance(side.start, side.end) <= eps_) continue;
      const Vec2 d = normalized(side.end - side.start);
      for (const Arc& arc : facet.arcs) {
        if (cross(d, arc.start - side.start) < -eps_) return false;
        if (arc.isCurved && (cross(d, arc.control1 - side.start) < -eps_ ||
                             cross(d, arc.control2 - side.start) < -eps_)) {
          return false;
        }
      }
    }
    return true;
  }

  bool isHidden(std::uint32_t number) {
    const FacetView& facet = views_.all()[number];
    collect(number);
    if (near_.empty()) return false;
    for (const Occluder* occluder : near_) {
      if (isInside(facet, views_.all()[occluder->number])) return true;
    }
    largestFirst(facet);
    for (const Polygon& part : partsOf(facet, views_.tolerance())) {
      if (isPartSeen(facet, part, 0)) return false;
    }
    return true;
  }

  /// Large overlaps first: what is hidden is then found out in few cuts.
  void largestFirst(const FacetView& facet) {
    std::vector<std::pair<double, std::size_t>> order;
    for (std::size_t i = 0; i < near_.size(); ++i) {
      const Box& box = views_.all()[near_[i]->number].box;
      const double width =
          std::min(box.high.x, facet.box.high.x) - std::max(box.low.x, facet.box.low.x);
      const double height =
          std::min(box.high.y, facet.box.high.y) - std::max(box.low.y, facet.box.low.y);
      order.emplace_back(-width * height, i);
    }
    std::sort(order.begin(), order.end());
    std::vector<Occluder*> sorted;
    for (const auto& [area, i] : order) sorted.push_back(near_[i]);
    near_ = std::move(sorted);
  }

  /// Takes one occluder after the other off the polygon, and stops as soon as one fragment survives
  /// them all.
  bool isPartSeen(const FacetView& facet, const Polygon& polygon, std::size_t next) {
    const Box box = boxOf(polygon);
    for (std::size_t i = next; i < near_.size(); ++i) {
      Occluder& occluder = *near_[i];
      const FacetView& over = views_.all()[occluder.number];
      if (!boxesMeet(over.box, box, eps_)) continue;
      prepare(occluder);
      for (std::size_t k = 0; k < occluder.parts.size(); ++k) {
        if (!boxesMeet(occluder.boxes[k], box, eps_)) continue;
        const Polygon common = intersection(polygon, occluder.parts[k], eps_);
        if (common.empty() || !isOverAll(over, facet, common)) continue;
        return isRestSeen(facet, polygon, occluder.parts[k], i);
      }
    }
    return true;
  }

  bool isRestSeen(const FacetView& facet, const Polygon& polygon, const Polygon& over,
                  std::size_t next) {
    Polygon inside = polygon;
    for (std::size_t i = 0; i < over.size() && !inside.empty(); ++i) {
      const Vec2 a = over[i];
      const Vec2 b = over[(i + 1) % over.size()];
      if (distance(a, b) <= eps_) continue;
      const Polygon outside = clipLeft(inside, b, a, eps_);
      if (!outside.empty() && isWide(outside) && isPartSeen(facet, outside, next)) return true;
      inside = clipLeft(inside, a, b, eps_);
    }
    return false;
  }

  bool isWide(const Polygon& polygon) const {
    double around = 0;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      around += distance(polygon[i], polygon[(i + 1) % polygon.size()]);
    }
    return signedArea(polygon) > eps_ * around;
  }

  void prepare(Occluder& occluder) const {
    if (occluder.hasParts) return;
    occluder.hasParts = true;
    occluder.parts = partsOf(views_.all()[occluder.number], views_.tolerance());
    for (const Polygon& part : occluder.parts) occluder.boxes.push_back(boxOf(part));
  }

  const FacetViews& views_;
  double eps_;
  Grid grid_;
  std::vector<Occluder> occluders_;
  std::vector<Occluder> exceptions_;
  std::vector<Occluder*> near_;
  std::vector<std::uint32_t> stamps_;  ///< for each occluder: the last question it was met in
  std::uint32_t stamp_ = 0;
};

}  // namespace

std::vector<std::uint32_t> facetsInSight(const FacetViews& views) { return Occlusion(views).run(); }

}  // namespace kiri
