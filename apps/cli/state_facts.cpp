// The figures that describe a state.
// SPDX-License-Identifier: MIT
#include "apps/cli/state_facts.h"

#include <algorithm>

#include "core/layers/layer_count.h"
#include "core/paper/boxes.h"

namespace kiri::cli {

StateFacts factsOf(const FoldedState& state) {
  StateFacts facts;
  facts.facets = state.pattern.facets.size();
  facts.area = areaOf(state.pattern);
  facts.isFlat = isFlat(state);
  facts.layers = maxLayerCount(state);
  facts.stretch = stretchOf(state);
  for (std::size_t i = 0; i < state.lines.size(); ++i) {
    const FoldLine& line = state.lines[i];
    facts.lines.push_back({line.name, line.isValley, amountOf(state, FoldLineId(i)), 0});
  }
  for (const Edge& edge : state.pattern.edges) {
    if (!edge.left.isValid() && !edge.right.isValid()) continue;
    if (edge.kind == EdgeKind::Tear) ++facts.tornEdges;
    if (edge.kind != EdgeKind::Hinge) continue;
    ++facts.hinges;
    if (edge.line.isValid()) ++facts.lines[edge.line.index].hinges;
  }
  facts.lines.erase(std::remove_if(facts.lines.begin(), facts.lines.end(),
                                   [](const FoldLineFacts& line) { return line.hinges == 0; }),
                    facts.lines.end());
  const std::vector<std::uint32_t> pieces = piecesOf(state.pattern);
  if (!pieces.empty()) facts.pieces = 1 + *std::max_element(pieces.begin(), pieces.end());
  facts.paper = paperBoxOf(state.pattern);
  const ModelBox box = modelBoxOf(state);
  facts.boxLow = box.low;
  facts.boxHigh = box.high;
  return facts;
}

}  // namespace kiri::cli
