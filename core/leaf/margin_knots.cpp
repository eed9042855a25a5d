// Where tips and sinuses lie in the folded leaf.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include "core/base/text.h"
#include "core/geometry/rigid.h"
#include "core/geometry/tolerance.h"
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

/// A place that is seen from the junction at `angle` from the outer mid-vein, as the petiole sees
/// it when the outer mid-lobe is turned by `turn` about the junction.
MarginKnot seenFromPetiole(std::string name, double at, double angle, double turn,
                           double distance) {
  const CosSin w = cosSinDegrees(angle + turn);
  const Vec2 place = Vec2{0, at} + Vec2{w.sin, w.cos} * distance;
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

}  // namespace

Result<std::vector<MarginKnot>> marginKnots(const LeafRecipe& recipe,
                                            const std::vector<FanRay>& fan) {
  std::vector<MarginKnot> knots;
  for (const FanRay& ray : fan) knots.push_back({ray.name, ray.folded, ray.length});
  if (recipe.secondary) {
    const SecondaryLobes& lobes = *recipe.secondary;
    if (Status status = checkSecondary(lobes); !status) return status.error();
    const double a1 = lobes.antiVein.angle;
    const double a2 = lobes.vein.angle;
    const double turn = 2 * (a2 - a1);
    knots.front() = seenFromPetiole("mid-vein", lobes.at, 0, turn, 1 - lobes.at);
    knots.push_back(
        seenFromPetiole("secondary vein", lobes.at, 2 * a1 - a2, turn, lobes.vein.length));
    knots.push_back(
        seenFromPetiole("secondary anti-vein", lobes.at, a1, turn, lobes.antiVein.length));
  }
  if (Status status = checkFalling(knots); !status) return status.error();
  return knots;
}

}  // namespace kiri
