// SPDX-License-Identifier: MIT
#include "core/cut/add_edge.h"

#include "core/base/text.h"
#include "core/layers/divide_layers.h"
#include "core/paper/inscribe.h"

namespace kiri {

Result<FoldedState> addEdge(const FoldedState& state, const FacetLine& line,
                            const std::vector<FacetId>& layers) {
  FoldedState next = state;
  const Result<std::size_t> count =
      divideLayers(next, layers, [&](CreasePattern& pattern, FacetId facet) {
        const FacetLine here = lineOn(state, {line.facet, line.from, line.to}, facet);
        return inscribeChords(pattern, facet, here.from, here.to, EdgeKind::Hinge);
      });
  if (!count) return count.error();
  if (*count == 0) {
    return Error{
        ErrorCode::MissesPaper,
        "the edge from " + text(line.from) + " to " + text(line.to) +
            " mm crosses none of the chosen layers, or runs along edges that are there already",
        {{}, {{line.from, line.to}}, {}}};
  }
  next.poses = derivePoses(next.pattern, next.rests);
  return next;
}

}  // namespace kiri
