// What can go wrong with secondary lobes, each with its sentence.
// SPDX-License-Identifier: MIT
#include "core/leaf/secondary_lobes.h"

#include <algorithm>
#include <cmath>

#include "core/base/text.h"
#include "core/geometry/tolerance.h"
#include "core/leaf/folded_half.h"

namespace kiri {
namespace {

constexpr double kQuarterTurn = 90;
/// Junctions nearer to the ends of a vein leave paper too small for a fold.
constexpr double kLeastPart = 0.01;

Error badLobe(std::string message) { return {ErrorCode::BadValue, std::move(message)}; }

Status checkAngles(const SecondaryLobes& pair, const std::string& of) {
  const double a1 = pair.antiVein.angle;
  const double a2 = pair.vein.angle;
  if (!(pair.at >= kLeastPart && pair.at <= 1 - kLeastPart)) {
    return badLobe(
        "secondary lobes leave a vein between petiole (0) and tip (1), not nearer to "
        "either than " +
        text(kLeastPart) + "; those of " + of + " not at " + text(pair.at));
  }
  if (a2 > 0 && a1 > a2) {
    return badLobe("the secondary anti-vein of " + of + " (" + text(a1) +
                   " degrees) stands behind " + "its vein (" + text(a2) +
                   "): no crease would end in the sinus between the two " +
                   "tips; give it a smaller angle than the vein");
  }
  if (!(a1 > 0 && a2 > a1 && a2 < kQuarterTurn)) {
    return badLobe("the angles of secondary anti-vein (" + text(a1) + ") and vein (" + text(a2) +
                   ") of " + of + " must rise from its vein and stay below 90 degrees");
  }
  if (a2 <= 2 * a1 + kSameAngle) return std::monostate{};
  return badLobe("the secondary vein of " + of + " (" + text(a2) + " degrees) would be folded " +
                 "past the vein that it leaves; move its anti-vein (" + text(a1) +
                 ") outward, to " + text(a2 / 2) + " degrees or more");
}

Status checkLengths(const SecondaryLobes& pair, double veinLength, const std::string& of) {
  const double outer = (1 - pair.at) * veinLength;
  const double vein = pair.vein.length;
  const double antiVein = pair.antiVein.length;
  if (antiVein > 0 && antiVein < vein && vein < outer) return std::monostate{};
  return badLobe("from the junction on " + of + ", the outer part of its vein (" + text(outer) +
                 "), the secondary vein (" + text(vein) + ") and its anti-vein (" + text(antiVein) +
                 ") must be shorter from one to the next");
}

/// The ends of a pair must stay in the sectors of its vein, and in front of the pair below it.
Status checkWithin(const LeafRecipe& recipe, const std::vector<FanRay>& fan,
                   const SecondaryLobes& pair, const SecondaryLobes* below) {
  const std::string of = lobeName(recipe, pair);
  const std::size_t ray = 2 * pair.lobe;
  const double length = fan[ray].length;
  const Vec2 end = Vec2{0, pair.at * length} + polarPlace(pair.vein.angle, pair.vein.length);
  const double seen = angleDegrees(end.y, end.x);
  for (const std::size_t next : {ray - 1, ray + 1}) {
    if (next >= fan.size() || seen < std::abs(fan[next].angle - fan[ray].angle)) continue;
    return badLobe("the secondary vein of " + of + " reaches " + text(seen) +
                   " degrees beside its " + "vein, beyond the " + fan[next].name + ", which is " +
                   text(std::abs(fan[next].angle - fan[ray].angle)) +
                   " beside it; make it shorter or steeper, or let it leave the vein farther out");
  }
  if (below == nullptr) return std::monostate{};
  if (below->at == pair.at) {
    return badLobe("two pairs of secondary lobes leave one vein at the same place, " +
                   text(pair.at) + " of its length; move one of them");
  }
  const Vec2 fromBelow = end - Vec2{0, below->at * length};
  if (angleDegrees(fromBelow.y, fromBelow.x) < below->antiVein.angle) return std::monostate{};
  return badLobe("the secondary vein of " + of + " meets the secondary anti-vein of " +
                 lobeName(recipe, *below) + "; make it shorter or steeper");
}

Status checkTear(const LeafRecipe& recipe) {
  if (!isTorn(recipe)) return std::monostate{};
  for (const SecondaryLobes& pair : recipe.secondary) {
    if (pair.lobe == 0) continue;
    return badLobe("secondary lobes of " + lobeName(recipe, pair) + " cannot be folded with a " +
                   "tear: it runs along the mid-vein and frees the mid-lobe only; leave out " +
                   "\"torn\", for all creases can be folded at once");
  }
  if (recipe.secondary.size() == 1) return std::monostate{};
  return badLobe("with a tear only one pair of secondary lobes can be folded, but there are " +
                 std::to_string(recipe.secondary.size()) +
                 "; leave out \"torn\", for all creases can be folded at once");
}

}  // namespace

std::vector<const SecondaryLobes*> pairsOfLobe(const LeafRecipe& recipe, std::size_t lobe) {
  std::vector<const SecondaryLobes*> pairs;
  for (const SecondaryLobes& pair : recipe.secondary) {
    if (pair.lobe == lobe) pairs.push_back(&pair);
  }
  std::stable_sort(pairs.begin(), pairs.end(),
                   [](const SecondaryLobes* a, const SecondaryLobes* b) { return a->at < b->at; });
  return pairs;
}

std::string lobeName(const LeafRecipe& recipe, const SecondaryLobes& pair) {
  const std::string name = pair.lobe == 0 ? "the mid-lobe" : "lobe " + std::to_string(pair.lobe);
  return pairsOfLobe(recipe, pair.lobe).size() > 1 ? name + " at " + text(pair.at) : name;
}

bool isTorn(const LeafRecipe& recipe) {
  return std::any_of(recipe.secondary.begin(), recipe.secondary.end(),
                     [](const SecondaryLobes& pair) { return pair.isTorn; });
}

Status checkSecondaryLobes(const LeafRecipe& recipe, const std::vector<FanRay>& fan) {
  for (const SecondaryLobes& pair : recipe.secondary) {
    if (pair.lobe <= recipe.veins.size()) continue;
    return badLobe("there is no lobe " + std::to_string(pair.lobe) +
                   " for secondary lobes: 0 is the mid-lobe, and " +
                   (recipe.veins.empty()
                        ? "no vein stands beside it"
                        : "the veins beside it give 1 to " + std::to_string(recipe.veins.size())));
  }
  if (Status status = checkTear(recipe); !status) return status;
  for (std::size_t lobe = 0; lobe <= recipe.veins.size(); ++lobe) {
    const SecondaryLobes* below = nullptr;
    for (const SecondaryLobes* pair : pairsOfLobe(recipe, lobe)) {
      const std::string of = lobeName(recipe, *pair);
      if (Status status = checkAngles(*pair, of); !status) return status;
      if (Status status = checkLengths(*pair, fan[2 * lobe].length, of); !status) return status;
      if (Status status = checkWithin(recipe, fan, *pair, below); !status) return status;
      below = pair;
    }
  }
  return std::monostate{};
}

}  // namespace kiri
