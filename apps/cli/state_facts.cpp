// The figures that describe a state.
// SPDX-License-Identifier: MIT
#include "apps/cli/state_facts.h"

#include <algorithm>

#include "core/layers/layer_count.h"

namespace kiri::cli {

namespace {

class Boxes {
 public:
  explicit Boxes(StateFacts& facts) : facts_(facts) {}

  void hold(Vec2 paper, Vec3 model) {
    if (isFirst_) {
      facts_.paper = {paper, paper};
      facts_.boxLow = facts_.boxHigh = model;
      isFirst_ = false;
    }
    Box& box = facts_.paper;
    box.low = {std::min(box.low.x, paper.x), std::min(box.low.y, paper.y)};
    box.high = {std::max(box.high.x, paper.x), std::max(box.high.y, paper.y)};
    Vec3& low = facts_.boxLow;
    Vec3& high = facts_.boxHigh;
    low = {std::min(low.x, model.x), std::min(low.y, model.y), std::min(low.z, model.z)};
    high = {std::max(high.x, model.x), std::max(high.y, model.y), std::max(high.z, model.z)};
  }

 private:
  StateFacts& facts_;
  bool isFirst_ = true;
};

void findBoxes(const FoldedState& state, StateFacts& facts) {
  Boxes boxes(facts);
  for (std::size_t f = 0; f < state.pattern.facets.size(); ++f) {
    const FacetId facet(f);
    for (const EdgeUse use : state.pattern[facet].border) {
      const Arc arc = arcOf(state.pattern, use);
      for (const double t : flatteningParameters(arc, state.tolerance().flattening())) {
        const Vec2 p = pointAt(arc, t);
        boxes.hold(p, state.poseOf(facet).apply(p));
      }
    }
  }
}

}  // namespace

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
  findBoxes(state, facts);
  return facts;
}

}  // namespace kiri::cli
