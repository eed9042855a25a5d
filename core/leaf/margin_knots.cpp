// Where tips and sinuses lie in the folded leaf.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include "core/base/text.h"
#include "core/geometry/rigid.h"
#include "core/geometry/tolerance.h"
#include "core/leaf/folded_half.h"
#include "core/leaf/margin.h"

namespace kiri {
namespace {

Error badKnot(std::string message) { return {ErrorCode::BadValue, std::move(message)}; }

/// One curve cuts all: along it lengths must fall as folded directions rise.
Status checkFalling(std::vector<MarginKnot> knots) {
  std::stable_sort(knots.begin(), knots.end(),
                   [](const MarginKnot& a, const MarginKnot& b) { return a.folded < b.folded; });
  for (std::size_t i = 1; i < knots.size(); ++i) {
    const MarginKnot& before = knots[i - 1];
    const MarginKnot& after = knots[i];
    const bool isSameWay = after.folded - before.folded <= kSameAngle;
    const double fall = before.length - after.length;
    if (isSameWay ? std::abs(fall) <= kParallel : fall > kParallel) continue;
    return badKnot("no single margin cuts both " + told(before) + " and " + told(after) +
                   ": it must come nearer to the petiole from one to the next; change a length, or "
                   "the angles before them");
  }
  return std::monostate{};
}

MarginKnot knotAt(std::string name, Vec2 place) {
  return {std::move(name), angleDegrees(place.y, place.x), length(place)};
}

/// The knots between which a place must lie: where the rays before and after it are cut.
Status checkPlace(const MarginKnot& place, const std::vector<MarginKnot>& rays) {
  const MarginKnot* before = nullptr;
  const MarginKnot* after = nullptr;
  for (const MarginKnot& ray : rays) {
    const bool isBefore = ray.folded <= place.folded + kSameAngle;
    const bool isAfter = ray.folded >= place.folded - kSameAngle;
    if (isBefore && (before == nullptr || ray.length < before->length)) before = &ray;
    if (isAfter && (after == nullptr || ray.length > after->length)) after = &ray;
  }
  // Where secondary lobes turn the ends of veins away there may be no ray on one side.
  if (before == nullptr || after == nullptr) return std::monostate{};
  if (place.length < before->length && place.length > after->length) return std::monostate{};
  return badKnot("no single margin passes the " + place.name + ": folded it lies at " +
                 text(place.folded) + " degrees, between the " + before->name + " and the " +
                 after->name + ", and the margin falls from " + text(before->length) + " to " +
                 text(after->length) + " there; give it a length in between");
}

/// The margin comes nearer to the petiole all the way.
Status checkPlaces(const std::vector<MarginKnot>& places, const std::vector<MarginKnot>& rays) {
  for (std::size_t i = 0; i < places.size(); ++i) {
    if (Status status = checkPlace(places[i], rays); !status) return status;
    for (std::size_t k = 0; k < i; ++k) {
      if (places[k].length != places[i].length) continue;
      return badKnot("the " + places[k].name + " and the " + places[i].name +
                     " are equally far from the petiole when folded, but the margin comes nearer " +
                     "to it all the way; leave one of them out or change its length");
    }
  }
  return std::monostate{};
}

}  // namespace

std::string told(const MarginKnot& knot) {
  return "the " + knot.name + " (folded it lies at " + text(knot.folded) + " degrees, " +
         text(knot.length) + " from the petiole)";
}

Result<std::vector<MarginKnot>> marginKnots(const LeafRecipe& recipe, const FoldedHalf& half) {
  std::vector<MarginKnot> knots;
  std::vector<MarginKnot> rays;  // those that lie on a crease from the petiole
  for (std::size_t i = 0; i < half.creases().size(); ++i) {
    const LeafCrease& crease = half.creases()[i];
    knots.push_back(knotAt(crease.name, half.foldedEnd(i)));
    if (crease.from == Vec2{0, 0}) rays.push_back(knots.back());
  }
  if (Status status = checkFalling(rays); !status) return status.error();
  std::vector<MarginKnot> places;
  const Vec2 base = half.creases().back().end;
  const double baseAngle = angleDegrees(base.y, base.x);
  for (const LeafRay& place : recipe.margin) {
    const std::string name =
        "place of the margin at " + text(place.angle) + " degrees, " + text(place.length);
    if (place.angle > baseAngle + kSameAngle) {
      return badKnot("the " + name + ", lies beyond the basal edge (" + text(baseAngle) +
                     " degrees); leave it out");
    }
    places.push_back(knotAt(name, half.folded(polarPlace(place.angle, place.length))));
  }
  if (Status status = checkPlaces(places, rays); !status) return status.error();
  knots.insert(knots.end(), places.begin(), places.end());
  return knots;
}

}  // namespace kiri
