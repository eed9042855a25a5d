// SPDX-License-Identifier: MIT
#include "editor/tools/layer_picker.h"

#include <algorithm>

#include "core/layers/topmost.h"
#include "editor/tools/seen_side.h"

namespace kiri {
namespace {

/// Where paper without a gap covers the line around a stretch.
Stretch coveredAround(const std::vector<Crossed>& crossed, Stretch around, double gap) {
  bool isGrowing = true;
  while (isGrowing) {
    isGrowing = false;
    for (const Crossed& c : crossed) {
      if (c.stretch.to < around.from - gap || c.stretch.from > around.to + gap) continue;
      if (c.stretch.from >= around.from && c.stretch.to <= around.to) continue;
      around = {std::min(around.from, c.stretch.from), std::max(around.to, c.stretch.to)};
      isGrowing = true;
    }
  }
  return around;
}

Stretch joined(Stretch a, Stretch b) { return {std::min(a.from, b.from), std::max(a.to, b.to)}; }

/// So long that the line leaves the paper on both sides.
Stretch endlessStretch(const FoldedState& state, const FacetLine& line) {
  const double reach = 2 * state.tolerance().sheetSize() / distance(line.from, line.to) + 1;
  return {-reach, reach};
}

}  // namespace

void LayerPicker::reset() { *this = LayerPicker(); }

void LayerPicker::setMode(LayerMode mode) { mode_ = mode; }

void LayerPicker::setCount(int count) {
  mode_ = LayerMode::Top;
  count_ = std::max(1, count);
}

void LayerPicker::walk(int layers) {
  const int most = std::max<int>(1, static_cast<int>(stack_.size()));
  const int before = mode_ == LayerMode::All ? most : (mode_ == LayerMode::Top ? count_ : 1);
  mode_ = LayerMode::Top;
  count_ = std::clamp(before + layers, 1, most);
}

void LayerPicker::toggle(const FoldedState& state, FacetId facet) {
  std::vector<FacetId> facets = taken_;
  const auto found = std::find(facets.begin(), facets.end(), facet);
  if (found == facets.end()) {
    facets.push_back(facet);
  } else {
    facets.erase(found);
  }
  choose(state, facets);
}

void LayerPicker::choose(const FoldedState& state, const std::vector<FacetId>& facets) {
  mode_ = LayerMode::Chosen;
  chosen_.clear();
  for (const FacetId f : facets) {
    if (f.index < state.pattern.facets.size()) chosen_.push_back(interiorPointOf(state.pattern, f));
  }
}

void LayerPicker::lookAtStack(const FoldedState& state, const FacetLine& line, Stretch within,
                              Vec3 up) {
  stack_.clear();
  for (const Crossed& c : crossedBy(state, line, within)) stack_.push_back(c.facet);
  std::sort(stack_.begin(), stack_.end());
  stack_.erase(std::unique(stack_.begin(), stack_.end()), stack_.end());
  std::sort(stack_.begin(), stack_.end(), [&](FacetId a, FacetId b) {
    return seenHeight(state, a, up) > seenHeight(state, b, up);
  });
}

std::vector<FacetId> LayerPicker::topmostAlong(const FoldedState& state, const FacetLine& line,
                                               Stretch within, Vec3 up, int count) const {
  std::vector<Cover> covers;
  for (const Crossed& c : crossedBy(state, line, within)) {
    covers.push_back({c.facet.index, std::max(within.from, c.stretch.from),
                      std::min(within.to, c.stretch.to), seenHeight(state, c.facet, up)});
  }
  std::vector<FacetId> facets;
  for (const std::size_t i : topmost(covers, count, kParallel)) facets.push_back(FacetId(i));
  return facets;
}

std::vector<FacetId> LayerPicker::crossedAmong(const FoldedState& state, const FacetLine& line,
                                               Stretch within, Vec3 up,
                                               std::optional<Spot> grabbed) const {
  if (!grabbed) return topmostAlong(state, line, within, up, 1);
  for (const Crossed& c : crossedBy(state, line, within)) {
    if (c.facet == grabbed->facet) return {c.facet};
  }
  return {};
}

std::vector<FacetId> LayerPicker::chosenOnes(const FoldedState& state,
                                             const FacetLine& line) const {
  std::vector<FacetId> facets;
  for (const Vec2 place : chosen_) {
    const auto facet = facetAt(state.pattern, place);
    if (facet && state.layers.areCoplanar(*facet, line.facet)) facets.push_back(*facet);
  }
  std::sort(facets.begin(), facets.end());
  facets.erase(std::unique(facets.begin(), facets.end()), facets.end());
  return facets;
}

void LayerPicker::look(const Scope& scope, const DrawnLine& line, std::optional<Spot> grabbed,
                       Pane pane) {
  const FoldedState& state = *scope.state;
  stack_.clear();
  taken_.clear();
  stretch_ = {0, 1};
  const auto here = locateLine(state, line);
  if (!here) return;
  const Vec3 up = seenUp(state, scope.map(pane), {here->facet, lerp(here->from, here->to, 0.5)});
  lookAtStack(state, *here, stretch_, up);
  if (mode_ == LayerMode::All) taken_ = stack_;
  if (mode_ == LayerMode::Chosen) taken_ = chosenOnes(state, *here);
  if (mode_ == LayerMode::Top) taken_ = topmostAlong(state, *here, stretch_, up, count_);
  if (mode_ != LayerMode::Hand) return;
  taken_ =
      grabbed ? std::vector<FacetId>{grabbed->facet} : topmostAlong(state, *here, stretch_, up, 1);
}

void LayerPicker::look(const Scope& scope, const FacetLine& line, std::optional<Spot> grabbed,
                       Pane pane, const FoldHand& hand) {
  const FoldedState& state = *scope.state;
  const Vec3 up = seenUp(state, scope.map(pane), {line.facet, lerp(line.from, line.to, 0.5)});
  const Stretch drawn = hand.isEndless ? endlessStretch(state, line) : Stretch{0, 1};

  std::vector<FacetId> seeds;
  if (grabbed) {
    seeds = hand.paper.pieceAt(*grabbed, hand.leftMoves);
  } else if (pane == Pane::Sheet) {
    seeds = hand.paper.piecesAlong({line.facet}, hand.leftMoves, drawn);
  } else {
    seeds = hand.paper.piecesAlong(topmostAlong(state, line, drawn, up, 1), hand.leftMoves, drawn);
  }
  const Reach reach = hand.paper.reachOf(seeds, hand.leftMoves);
  stretch_ = drawn;
  if (!reach.layers.empty())
    stretch_ = hand.isEndless ? reach.stretch : joined(drawn, reach.stretch);
  taken_ = reach.layers;
  // Paper that the line crosses without dividing it: the fold itself says what is wrong.
  if (taken_.empty()) taken_ = crossedAmong(state, line, drawn, up, grabbed);

  const double gap = state.tolerance().match() / distance(line.from, line.to);
  if (hand.isEndless && mode_ == LayerMode::All)
    stretch_ = coveredAround(crossedBy(state, line, drawn), stretch_, gap);
  if (mode_ != LayerMode::Hand && !hand.isEndless) stretch_ = drawn;
  lookAtStack(state, line, stretch_, up);
  if (mode_ == LayerMode::All) taken_ = stack_;
  if (mode_ == LayerMode::Top) taken_ = topmostAlong(state, line, stretch_, up, count_);
  if (mode_ != LayerMode::Chosen) return;
  taken_ = chosenOnes(state, line);
  reachChosen(state, line);
}

/// Facets picked one by one are meant, also where the line as drawn does not reach them.
void LayerPicker::reachChosen(const FoldedState& state, const FacetLine& line) {
  const std::vector<Crossed> all = crossedBy(state, line, endlessStretch(state, line));
  for (const FacetId facet : taken_) {
    const Crossed* nearest = nullptr;
    double least = 0;
    for (const Crossed& c : all) {
      if (c.facet != facet) continue;
      const double away =
          std::max({c.stretch.from - stretch_.to, stretch_.from - c.stretch.to, 0.0});
      if (nearest != nullptr && away >= least) continue;
      nearest = &c;
      least = away;
    }
    if (nearest != nullptr) stretch_ = joined(stretch_, nearest->stretch);
  }
}

LayerChoice LayerPicker::choice(const FoldedState& state) const {
  if (mode_ == LayerMode::All) return AllLayers{};
  ChosenLayers chosen;
  for (const FacetId f : taken_) {
    if (f.index < state.pattern.facets.size())
      chosen.facets.push_back({Frame::Paper, interiorPointOf(state.pattern, f)});
  }
  return chosen;
}

}  // namespace kiri
