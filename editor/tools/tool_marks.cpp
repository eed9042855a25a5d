// SPDX-License-Identifier: MIT
#include "editor/tools/tool_marks.h"

#include <algorithm>

namespace kiri {
namespace {

constexpr std::size_t kMostCollisions = 8;
/// Beyond it tints have to do.
constexpr std::size_t kMostSelected = 64;

}  // namespace

void addWitness(const FoldedState& state, const Witness& witness, Marks& marks) {
  for (const auto& [from, to] : witness.segments) {
    const auto facet = facetAt(state.pattern, lerp(from, to, 0.5));
    if (!facet) continue;
    marks.push_back(
        PathMark{MarkRole::Fault, {Spot{*facet, from}, Spot{*facet, to}}, false, false});
  }
  if (!witness.segments.empty()) return;
  for (const Vec2 p : witness.points) {
    if (const auto facet = facetAt(state.pattern, p))
      marks.push_back(PointMark{MarkRole::Fault, Spot{*facet, p}});
  }
}

void addCollisions(const std::vector<Collision>& collisions, Marks& marks) {
  for (std::size_t i = 0; i < std::min(collisions.size(), kMostCollisions); ++i) {
    marks.push_back(PointMark{MarkRole::Collision, collisions[i].place});
  }
}

void addSelected(const FoldedState& state, const std::vector<Selected>& items, MarkRole role,
                 Marks& marks) {
  for (std::size_t i = 0; i < std::min(items.size(), kMostSelected); ++i) {
    const Selected& item = items[i];
    const auto facet = facetAt(state.pattern, item.place);
    if (!facet) continue;
    if (item.kind == SelectedKind::Facet) {
      marks.push_back(outlineOf(state, *facet, role));
    } else if (item.kind == SelectedKind::Line) {
      marks.push_back(
          PathMark{role, {Spot{*facet, item.from}, Spot{*facet, item.to}}, false, false});
    } else {
      marks.push_back(PointMark{role, Spot{*facet, item.place}});
    }
  }
}

PathMark outlineOf(const FoldedState& state, FacetId facet, MarkRole role) {
  PathMark outline{role, {}, true, false};
  const Facet& paper = state.pattern[facet];
  const std::size_t outer =
      paper.holeStarts.empty() ? paper.border.size() : paper.holeStarts.front();
  for (std::size_t i = 0; i < outer; ++i) {
    const Arc arc = arcOf(state.pattern, paper.border[i]);
    const int pieces = arc.isCurved ? 6 : 1;
    for (int p = 0; p < pieces; ++p)
      outline.places.push_back(Spot{facet, pointAt(arc, static_cast<double>(p) / pieces)});
  }
  return outline;
}

}  // namespace kiri
