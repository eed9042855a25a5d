// From witnesses to marks.
// SPDX-License-Identifier: MIT
#include "editor/session/fault_marks.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "editor/session/moved_facets.h"

namespace kiri {

namespace {

std::string degreesText(double degrees) {
  return std::to_string(static_cast<int>(std::lround(degrees))) + "°";
}

}  // namespace

Marks marksOf(const Witness& witness, const FoldedState& state) {
  Marks marks;
  for (const auto& [from, to] : witness.segments) {
    if (const auto facet = facetAt(state.pattern, lerp(from, to, 0.5))) {
      marks.push_back(PathMark{MarkRole::Fault, {Spot{*facet, from}, Spot{*facet, to}}});
    }
  }
  for (const Vec2 point : witness.points) {
    if (const auto facet = facetAt(state.pattern, point)) {
      marks.push_back(PointMark{MarkRole::Fault, Spot{*facet, point}});
    }
  }
  return marks;
}

Marks marksOf(const std::vector<Collision>& collisions, const FoldedState& state) {
  Marks marks;
  std::vector<std::pair<Vec3, std::string>> said;
  for (const Collision& collision : collisions) {
    const std::string degrees = degreesText(collision.degrees);
    // Layers that lie on each other meet at one place: it is marked once.
    const bool isSaid = std::any_of(said.begin(), said.end(), [&](const auto& other) {
      return other.second == degrees &&
             distance(other.first, collision.place) <= state.tolerance().pick();
    });
    if (isSaid) continue;
    said.emplace_back(collision.place, degrees);
    marks.push_back(PointMark{MarkRole::Collision, collision.place});
    marks.push_back(TextMark{MarkRole::Collision, collision.place,
                             Phrase{KIRI_TEXT("editor/session", "meets at %1"), {degrees}}});
  }
  return marks;
}

std::vector<FacetId> facetsOf(const std::vector<Collision>& collisions, const FoldedState& state) {
  std::vector<Vec2> places;
  for (const Collision& collision : collisions) {
    places.push_back(collision.moving);
    places.push_back(collision.fixed);
  }
  return facetsHolding(state.pattern, places);
}

}  // namespace kiri
