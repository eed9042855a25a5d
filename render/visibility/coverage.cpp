// Which facet is seen on either side of every side of the planar map.
// SPDX-License-Identifier: MIT
#include "render/visibility/coverage.h"

#include <array>

#include "render/visibility/grid.h"

namespace kiri {
namespace {

constexpr std::uint32_t kNothing = SeenBeside::kNothing;

class Coverage {
 public:
  Coverage(const FacetViews& views, const std::vector<std::uint32_t>& inSight)
      : views_(views),
        isPlainStack_(views.isPlainStack()),
        eps_(views.tolerance().match()),
        grid_(makeGrid(views, inSight)) {
    hands_.assign(views.all().size(), 0);
    regions_.resize(views.all().size());
    for (const std::uint32_t f : inSight) {
      if (!views.all()[f].isConvex) regions_[f] = views.all()[f].region();
      grid_.addBox(grown(views.all()[f].box, eps_), f);
    }
  }

  SeenBeside beside(const Arrangement& map, const Side& side) {
    for (std::uint32_t u = side.firstUse; u != SideUse::kEnd; u = map.uses[u].next) {
      hands_[map.uses[u].facet] |= map.uses[u].isForward ? kLeft : kRight;
    }
    const Vec2 middle = pointAt(side.arc, 0.5);
    const Vec2 along = side.arc.isCurved ? tangentAt(side.arc, 0.5) : side.arc.end - side.arc.start;
    const Vec2 toLeft = length(along) > 0 ? perpendicular(normalized(along)) : Vec2{0, 1};
    SeenBeside seen;
    for (const std::uint32_t f : grid_.at(middle)) {
      const bool mayBeLeft = wins(f, seen.left, middle, toLeft);
      const bool mayBeRight = wins(f, seen.right, middle, -toLeft);
      if (!mayBeLeft && !mayBeRight) continue;
      unsigned hands = hands_[f];
      if (hands == 0) hands = handsInside(f, side.arc, middle, toLeft);
      // The border runs both ways: a slit has paper on both hands, the tip of a needle on neither.
      else if (hands == (kLeft | kRight))
        hands = handsNear(f, middle, toLeft);
      if (mayBeLeft && (hands & kLeft) != 0) seen.left = f;
      if (mayBeRight && (hands & kRight) != 0) seen.right = f;
      if (isPlainStack_ && seen.left != kNothing && seen.right != kNothing) break;
    }
    for (std::uint32_t u = side.firstUse; u != SideUse::kEnd; u = map.uses[u].next) {
      hands_[map.uses[u].facet] = 0;
    }
    return seen;
  }

 private:
  static constexpr unsigned kLeft = 1;
  static constexpr unsigned kRight = 2;

  static Grid makeGrid(const FacetViews& views, const std::vector<std::uint32_t>& inSight) {
    if (inSight.empty()) return Grid({}, {}, 1);
    Box box = views.all()[inSight.front()].box;
    Vec2 sum;
    for (const std::uint32_t f : inSight) {
      box = joined(box, views.all()[f].box);
      sum = sum + (views.all()[f].box.high - views.all()[f].box.low);
    }
    return Grid(box, sum / static_cast<double>(inSight.size()), inSight.size());
  }

  bool wins(std::uint32_t f, std::uint32_t best, Vec2 p, Vec2 hand) const {
    return best == kNothing || views_.isOver(views_.all()[f], views_.all()[best], p, hand);
  }

  Where locateIn(std::uint32_t f, Vec2 p, double margin) const {
    const FacetView& view = views_.all()[f];
    if (!boxesMeet(grown(view.box, margin), {p, p}, 0)) return Where::Outside;
    if (!view.isConvex) return locate(regions_[f], p, margin);
    bool isOnBorder = false;
    for (const Arc& arc : view.arcs) {
      const Vec2 d = arc.end - arc.start;
      const double area = cross(d, p - arc.start);
      const double slack = margin * length(d);
      if (area < -slack) return Where::Outside;
      isOnBorder |= area <= slack;
    }
    return isOnBorder ? Where::OnBorder : Where::Inside;
  }

  /// On which hands of a side a facet is whose border does not run along it.
  unsigned handsInside(std::uint32_t f, const Arc& arc, Vec2 middle, Vec2 toLeft) const {
    constexpr std::array<double, 4> kOtherPlaces = {0.3, 0.7, 0.1, 0.9};
    Where where = locateIn(f, middle, eps_);
    for (std::size_t i = 0; where == Where::OnBorder && i < kOtherPlaces.size(); ++i) {
      where = locateIn(f, pointAt(arc, kOtherPlaces[i]), eps_);
    }
    // A border that runs along near the side without being one with it: look more closely.
    if (where == Where::OnBorder) where = locateIn(f, middle, views_.tolerance().length());
    if (where != Where::OnBorder) return where == Where::Inside ? kLeft | kRight : 0;
    return handsNear(f, middle, toLeft);
  }

  /// Looks on either hand, farther than borders that were made one can lie apart.
  unsigned handsNear(std::uint32_t f, Vec2 middle, Vec2 toLeft) const {
    const double step = 8 * eps_;
    const bool isLeft = locateIn(f, middle + toLeft * step, 0) != Where::Outside;
    const bool isRight = locateIn(f, middle - toLeft * step, 0) != Where::Outside;
    return (isLeft ? kLeft : 0) | (isRight ? kRight : 0);
  }

  const FacetViews& views_;
  bool isPlainStack_;
  double eps_;
  Grid grid_;
  std::vector<unsigned>
      hands_;  ///< for each facet whose border runs along the side in question: where it is
  std::vector<Region> regions_;
};

}  // namespace

std::vector<SeenBeside> seenBesideSides(const FacetViews& views,
                                        const std::vector<std::uint32_t>& inSight,
                                        const Arrangement& map) {
  Coverage coverage(views, inSight);
  std::vector<SeenBeside> out;
  out.reserve(map.sides.size());
  for (const Side& side : map.sides) out.push_back(coverage.beside(map, side));
  return out;
}

}  // namespace kiri
