// Zig-zag of the polar angle.
// SPDX-License-Identifier: MIT
#include "core/leaf/fan.h"

#include <array>
#include <cmath>

#include "core/base/text.h"
#include "core/geometry/tolerance.h"

namespace kiri {
namespace {

constexpr double kHalfTurn = 180;
constexpr double kRightAngle = 90;

std::string ordinal(std::size_t n) {
  static const std::array<const char*, 8> kNames = {"first", "second", "third",   "fourth",
                                                    "fifth", "sixth",  "seventh", "eighth"};
  return n < kNames.size() ? kNames[n] : std::to_string(n + 1) + "th";
}

std::string described(const FanRay& ray) {
  return "the " + ray.name + " (" + text(ray.angle) + " degrees)";
}

Error badRay(std::string message) { return {ErrorCode::BadValue, std::move(message)}; }

std::vector<FanRay> raysOf(const LeafRecipe& recipe) {
  std::vector<FanRay> fan = {{RayKind::Vein, "mid-vein", 0, 0, 1}};
  for (std::size_t i = 0; i < recipe.veins.size(); ++i) {
    fan.push_back({RayKind::AntiVein, ordinal(i) + " anti-vein", recipe.antiVeins[i].angle, 0,
                   recipe.antiVeins[i].length});
    // The mid-vein is the first vein.
    fan.push_back({RayKind::Vein, ordinal(i + 1) + " vein", recipe.veins[i].angle, 0,
                   recipe.veins[i].length});
  }
  fan.push_back({RayKind::BasalEdge, "basal edge", recipe.base.angle, 0, recipe.base.length});
  return fan;
}

Status checkRays(const LeafRecipe& recipe, const std::vector<FanRay>& fan) {
  for (std::size_t i = 0; i < fan.size(); ++i) {
    if (!(std::isfinite(fan[i].length) && fan[i].length > 0)) {
      return badRay(described(fan[i]) + " needs a length above 0, as part of the mid-vein's");
    }
    if (i > 0 && !(fan[i].angle > fan[i - 1].angle)) {
      return badRay("the angles overlap: " + described(fan[i]) + " must lie farther from the " +
                    "mid-vein than " + described(fan[i - 1]));
    }
  }
  const double base = fan.back().angle;
  if (recipe.petiole == Petiole::OnEdge && base != kRightAngle) {
    return badRay(
        "with the petiole on the edge of the sheet the basal edge is at 90 degrees, not " +
        text(base) + "; put the petiole inside for a leaf that reaches below it");
  }
  if (!(base < kHalfTurn)) {
    return badRay("the basal edge must stay below 180 degrees, or the two halves overlap");
  }
  return std::monostate{};
}

/// Where the flap would lie that a ray ends: the anti-vein before it is too near to the mid-vein.
Status checkFolded(const std::vector<FanRay>& fan) {
  for (std::size_t i = 1; i < fan.size(); ++i) {
    if (fan[i].folded >= -kSameAngle) continue;
    return badRay(described(fan[i]) + " would be folded " + text(-fan[i].folded) +
                  " degrees past the mid-vein, into the other half; move " + described(fan[i - 1]) +
                  " outward, or " + described(fan[i]) + " inward");
  }
  return std::monostate{};
}

}  // namespace

Result<std::vector<FanRay>> fanOf(const LeafRecipe& recipe) {
  if (recipe.veins.size() != recipe.antiVeins.size()) {
    return badRay("there must be one anti-vein before each vein beside the mid-vein: " +
                  std::to_string(recipe.veins.size()) + " veins, but " +
                  std::to_string(recipe.antiVeins.size()) + " anti-veins");
  }
  std::vector<FanRay> fan = raysOf(recipe);
  double way = 1;
  for (std::size_t i = 1; i < fan.size(); ++i) {
    fan[i].folded = fan[i - 1].folded + way * (fan[i].angle - fan[i - 1].angle);
    way = -way;
  }
  if (Status status = checkRays(recipe, fan); !status) return status.error();
  if (Status status = checkFolded(fan); !status) return status.error();
  return fan;
}

}  // namespace kiri
