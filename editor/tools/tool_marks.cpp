// SPDX-License-Identifier: MIT
#include "editor/tools/tool_marks.h"

#include <algorithm>

namespace kiri {
namespace {

/// Beyond it tints have to do.
constexpr std::size_t kMostSelected = 64;

}  // namespace

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
