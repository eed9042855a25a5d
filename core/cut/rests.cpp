// SPDX-License-Identifier: MIT
#include "core/cut/rests.h"

#include <algorithm>

#include "core/layers/refine.h"
#include "core/paper/pattern_edit.h"

namespace kiri {

void renewRests(FoldedState& state) {
  const std::vector<std::uint32_t> piece = piecesOf(state.pattern);
  const std::uint32_t count = piece.empty() ? 0 : *std::max_element(piece.begin(), piece.end()) + 1;
  std::vector<Rest> rests(count);
  for (const Rest& rest : state.rests) {
    Rest& home = rests[piece[rest.facet.index]];
    if (!home.facet.isValid()) home = rest;
  }
  // What was cut off a facet that rests goes on resting.
  for (const Rest& rest : state.rests) {
    for (std::size_t f = 0; f < piece.size(); ++f) {
      Rest& home = rests[piece[f]];
      if (!home.facet.isValid() && state.poses[f] == rest.pose) home = Rest{FacetId(f), rest.pose};
    }
  }
  for (std::size_t f = 0; f < piece.size(); ++f) {
    if (!rests[piece[f]].facet.isValid()) rests[piece[f]] = {FacetId(f), state.poses[f]};
  }
  state.rests = std::move(rests);
  state.poses = derivePoses(state.pattern, state.rests);
}

FoldedState keepOnly(const FoldedState& state, const std::vector<bool>& keep) {
  Kept kept = keepFacets(state.pattern, keep);
  FoldedState next(std::move(kept.pattern));
  next.lines = state.lines;
  next.collisions = state.collisions;
  next.layers = refined(state.layers, kept.origin);
  for (std::size_t i = 0; i < kept.origin.size(); ++i) {
    next.poses.push_back(state.poseOf(kept.origin[i]));
    for (const Rest& rest : state.rests) {
      if (rest.facet == kept.origin[i]) next.rests.push_back({FacetId(i), rest.pose});
    }
  }
  renewRests(next);
  return next;
}

}  // namespace kiri
