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

constexpr double kHalfCircle = 180;

Error badKnot(std::string message) { return {ErrorCode::BadValue, std::move(message)}; }

std::string toldKnot(const MarginKnot& knot) {
  return "the " + knot.name + " (folded it lies at " + text(knot.folded) + " degrees, " +
         text(knot.length) + " from the petiole)";
}

/// One curve cuts all: along it lengths must fall as folded directions rise.
Status checkFalling(std::vector<MarginKnot> knots) {
  std::stable_sort(knots.begin(), knots.end(),
                   [](const MarginKnot& a, const MarginKnot& b) { return a.folded < b.folded; });
  for (std::size_t i = 1; i < knots.size(); ++i) {
    const MarginKnot& before = knots[i - 1];
    const MarginKnot& after = knots[i];
    const bool isSameWay = after.folded - before.folded <= kSameAngle;
    if (isSameWay ? after.length == before.length : after.length < before.length) continue;
    return badKnot("no single margin cuts both " + toldKnot(before) + " and " + toldKnot(after) +
                   ": it must come nearer to the petiole from one to the next; change a length, or "
                   "the angles before them");
  }
  return std::monostate{};
}

MarginKnot knotAt(std::string name, Vec2 place) {
  return {std::move(name), angleDegrees(place.y, place.x), length(place)};
}

Status checkSecondary(const SecondaryLobes& lobes) {
  const double a1 = lobes.antiVein.angle;
  const double a2 = lobes.vein.angle;
  if (!(lobes.at > 0 && lobes.at < 1)) {
    return badKnot("secondary lobes leave the mid-vein between petiole (0) and tip (1), not at " +
                   text(lobes.at));
  }
  if (!(a1 > 0 && a2 > a1 && a2 < kHalfCircle / 2)) {
    return badKnot("the angles of secondary anti-vein (" + text(a1) + ") and vein (" + text(a2) +
                   ") must rise from the mid-vein and stay below 90 degrees");
  }
  if (a2 > 2 * a1 + kSameAngle) {
    return badKnot("the secondary vein (" + text(a2) + " degrees) would be folded past the " +
                   "mid-vein; move its anti-vein (" + text(a1) + ") outward, to " + text(a2 / 2) +
                   " degrees or more");
  }
  const double outer = 1 - lobes.at;
  const bool isFalling = lobes.vein.length < outer && lobes.antiVein.length < lobes.vein.length;
  if (isFalling && lobes.antiVein.length > 0) return std::monostate{};
  return badKnot("from the junction on the outer mid-vein (" + text(outer) + "), the secondary " +
                 "vein (" + text(lobes.vein.length) + ") and its anti-vein (" +
                 text(lobes.antiVein.length) + ") must be shorter from one to the next");
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
  if (before == nullptr || after == nullptr) {
    return badKnot("the " + place.name + " lies beyond the folded leaf, at " + text(place.folded) +
                   " degrees; leave it out");
  }
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

Result<std::vector<MarginKnot>> marginKnots(const LeafRecipe& recipe,
                                            const std::vector<FanRay>& fan) {
  if (recipe.secondary) {
    if (Status status = checkSecondary(*recipe.secondary); !status) return status.error();
  }
  const FoldedHalf half(recipe, fan);
  std::vector<MarginKnot> knots;
  for (const FanRay& ray : fan) {
    const bool isTurned = recipe.secondary && ray.angle == 0;
    knots.push_back(isTurned ? knotAt(ray.name, half.folded(ray.angle, ray.length))
                             : MarginKnot{ray.name, ray.folded, ray.length});
  }
  if (recipe.secondary) {
    const SecondaryLobes& lobes = *recipe.secondary;
    const auto add = [&](const char* name, const LeafRay& ray) {
      knots.push_back(knotAt(name, half.folded(half.fromJunction(ray.angle, ray.length))));
    };
    add("secondary vein", lobes.vein);
    add("secondary anti-vein", lobes.antiVein);
  }
  if (Status status = checkFalling(knots); !status) return status.error();
  std::vector<MarginKnot> places;
  for (const LeafRay& place : recipe.margin) {
    const std::string name =
        "place of the margin at " + text(place.angle) + " degrees, " + text(place.length);
    if (place.angle > fan.back().angle) {
      return badKnot("the " + name + ", lies beyond the basal edge (" + text(fan.back().angle) +
                     " degrees); leave it out");
    }
    places.push_back(knotAt(name, half.folded(place.angle, place.length)));
  }
  if (Status status = checkPlaces(places, knots); !status) return status.error();
  knots.insert(knots.end(), places.begin(), places.end());
  return knots;
}

}  // namespace kiri
