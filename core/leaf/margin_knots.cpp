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

/// A crease from the petiole, by its place in the half leaf, and where its end lies.
struct RayKnot {
  std::size_t crease = 0;
  MarginKnot knot;
};

double flatAngle(const LeafCrease& crease) { return angleDegrees(crease.end.y, crease.end.x); }

/// The nearest crease from the petiole before `crease` that is of one of the kinds.
std::size_t rayBefore(const FoldedHalf& half, std::size_t crease, bool isAntiVein) {
  while (crease > 0) {
    const LeafCrease& c = half.creases()[--crease];
    if (!c.isSecondary && (!isAntiVein || c.kind == RayKind::AntiVein)) break;
  }
  return crease;
}

/// "; move the second anti-vein inward, to less than 86 degrees": what would fold `after` nearer to
/// the mid-vein than `before`. Empty when nothing simple does, and for the mid-vein itself.
std::string moveInward(const FoldedHalf& half, const RayKnot& before, const RayKnot& after) {
  // A vein is folded back at the anti-vein before it: that one moves it by twice its own way.
  const bool isVein = half.creases()[after.crease].kind == RayKind::Vein;
  const std::size_t moved = isVein ? rayBefore(half, after.crease, true) : after.crease;
  const double way = (after.knot.folded - before.knot.folded) / (isVein ? 2 : 1);
  const double most = std::floor((flatAngle(half.creases()[moved]) - way) * 10) / 10;
  if (before.crease == 0 || moved <= before.crease ||
      most <= flatAngle(half.creases()[rayBefore(half, moved, false)]))
    return "";
  return ", or move the " + half.creases()[moved].name + " inward, to less than " + text(most) +
         " degrees";
}

std::string remedyFor(const FoldedHalf& half, const RayKnot& before, const RayKnot& after) {
  std::string shorter =
      "; give the " + after.knot.name + " a length below " + text(before.knot.length);
  if (before.crease > 0) {
    shorter += ", or the " + before.knot.name + " one above " + text(after.knot.length);
  }
  return shorter + moveInward(half, before, after);
}

/// One curve cuts all: along it lengths must fall as folded directions rise.
Status checkFalling(const FoldedHalf& half, std::vector<RayKnot> rays) {
  std::stable_sort(rays.begin(), rays.end(), [](const RayKnot& a, const RayKnot& b) {
    return a.knot.folded < b.knot.folded;
  });
  for (std::size_t i = 1; i < rays.size(); ++i) {
    const MarginKnot& before = rays[i - 1].knot;
    const MarginKnot& after = rays[i].knot;
    const bool isSameWay = after.folded - before.folded <= kSameAngle;
    const double fall = before.length - after.length;
    if (isSameWay ? std::abs(fall) <= kParallel : fall > kParallel) continue;
    const std::string both = "no single margin cuts both " + told(before) + " and " + told(after);
    if (isSameWay) {
      return badKnot(both + ": they lie the same way; give them one length, or change an angle");
    }
    return badKnot(both + ": it must come nearer to the petiole from one to the next" +
                   remedyFor(half, rays[i - 1], rays[i]));
  }
  return std::monostate{};
}

MarginKnot knotAt(std::string name, Vec2 place) {
  return {std::move(name), angleDegrees(place.y, place.x), length(place)};
}

/// The knots between which a place must lie: where the rays before and after it are cut.
Status checkPlace(const MarginKnot& place, const std::vector<RayKnot>& rays) {
  const MarginKnot* before = nullptr;
  const MarginKnot* after = nullptr;
  for (const RayKnot& rayKnot : rays) {
    const MarginKnot& ray = rayKnot.knot;
    const bool isBefore = ray.folded <= place.folded + kSameAngle;
    const bool isAfter = ray.folded >= place.folded - kSameAngle;
    if (isBefore && (before == nullptr || ray.length < before->length)) before = &ray;
    if (isAfter && (after == nullptr || ray.length > after->length)) after = &ray;
  }
  // Where secondary lobes turn the ends of veins away there may be no ray on one side.
  if (before == nullptr || after == nullptr) return std::monostate{};
  if (place.length < before->length && place.length > after->length) return std::monostate{};
  if (before == after) {
    return badKnot("no single margin passes the " + place.name + ": folded it lies on the " +
                   before->name + ", which the margin meets at " + text(before->length) +
                   "; leave it out");
  }
  return badKnot("no single margin passes the " + place.name + ": folded it lies at " +
                 text(place.folded) + " degrees, between the " + before->name + " and the " +
                 after->name + ", and the margin falls from " + text(before->length) + " to " +
                 text(after->length) + " there; give it a length in between");
}

/// The margin comes nearer to the petiole all the way.
Status checkPlaces(const std::vector<MarginKnot>& places, const std::vector<RayKnot>& rays) {
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
  std::vector<RayKnot> rays;
  for (std::size_t i = 0; i < half.creases().size(); ++i) {
    const LeafCrease& crease = half.creases()[i];
    knots.push_back(knotAt(crease.name, half.foldedEnd(i)));
    if (crease.from == Vec2{0, 0}) rays.push_back({i, knots.back()});
  }
  if (Status status = checkFalling(half, rays); !status) return status.error();
  std::vector<MarginKnot> places;
  const double baseAngle = flatAngle(half.creases().back());
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
