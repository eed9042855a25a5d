// The rooms from a pattern to its states, one after the other.
// SPDX-License-Identifier: MIT
#include "core/flatfold/flat_folding.h"

#include <cmath>
#include <string>

#include "core/base/text.h"

namespace kiri {
namespace {

/// Parts of the whole work, as progress tells them.
constexpr double kGroundPart = 0.4;

Progress partOf(const Progress& progress, double from, double to) {
  if (!progress) return {};
  return [&progress, from, to](double done) { return progress(from + (to - from) * done); };
}

Error notMeantFlat(const CreasePattern& pattern) {
  for (const Edge& edge : pattern.edges) {
    const double amount = std::abs(edge.angle);
    if (edge.kind != EdgeKind::Hinge || amount == 0 || amount == 180) continue;
    const Vec2 from = pattern[edge.from];
    const Vec2 to = pattern[edge.to];
    return {ErrorCode::BadValue,
            "the crease from " + text(from) + " to " + text(to) + " mm is meant to fold by " +
                text(amount) +
                " degrees; only patterns whose creases fold by 0 or 180 degrees have flat states",
            {{}, {{from, to}}, {}}};
  }
  return {ErrorCode::BadValue, "the pattern is not meant to fold flat", {}};
}

}  // namespace

Result<FlatFolding> flatFold(AssignedPattern creases, const SearchLimits& limits,
                             const Progress& progress) {
  if (!isMeantFlat(creases)) return notMeantFlat(creases.pattern);
  Result<FlatMap> map = flatMapOf(creases);
  if (!map) return map.error();
  Result<GroundAndOrders> ground = overlapsOf(creases, *map, partOf(progress, 0, kGroundPart));
  if (!ground) return ground.error();
  Result<LayerStates> states =
      LayerStates::find(std::move(ground->problem), limits, partOf(progress, kGroundPart, 1));
  if (!states) return states.error();
  return FlatFolding{std::move(creases), std::move(*map), std::move(ground->ground),
                     std::move(*states)};
}

}  // namespace kiri
