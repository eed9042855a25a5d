// From a step of the model to the search for its layers, and back.
// SPDX-License-Identifier: MIT
#include "editor/session/pattern_analysis.h"

#include <algorithm>
#include <utility>
#include <variant>

#include "core/model/facet_finder.h"
#include "core/model/pattern_creases.h"
#include "core/model/pattern_step.h"

namespace kiri {

namespace {

/// True when the side of the plane that `normal` points to is the upper one of the search. `normal`
/// is one of the two of a state that is folded as the search's map is, but may lie elsewhere.
bool isUpward(const FlatFolding& folding, const FoldedState& after, Vec3 normal) {
  const FacetId any(0);
  const bool isFrontAlong = dot(after.poseOf(any).normal(), normal) > 0;
  return isFrontAlong == !folding.map.poses[any.index].isFlipped;
}

bool isThisPatternFlat(const FlatFolding& folding, const FoldedState& after) {
  return after.pattern.facets.size() == folding.creases.pattern.facets.size() &&
         after.layers.sets().size() == 1 && isFlat(after);
}

std::vector<FacetId> facetsOfComponent(const LayerStates& states, std::size_t index) {
  std::vector<FacetId> facets;
  for (const std::uint32_t pair : states.component(index).pairs) {
    facets.push_back(states.problem().pairs[pair].a);
    facets.push_back(states.problem().pairs[pair].b);
  }
  std::sort(facets.begin(), facets.end());
  facets.erase(std::unique(facets.begin(), facets.end()), facets.end());
  return facets;
}

}  // namespace

std::optional<std::size_t> patternStepOf(const Model& model, std::size_t count) {
  for (std::size_t i = 0; i < std::min(count, model.steps.size()); ++i) {
    if (std::holds_alternative<PatternStep>(model.steps[i].action)) return i;
  }
  return std::nullopt;
}

bool haveSameCreases(const PatternStep& a, const PatternStep& b) {
  return a.vertices == b.vertices && a.creases == b.creases;
}

Result<AssignedPattern> creasesOf(const FoldedState& before, const PatternStep& step) {
  Result<CreasedSheet> creased = creasedSheet(before.pattern, step);
  if (!creased) return creased.error();
  AssignedPattern creases(std::move(creased->pattern));
  for (const Edge& edge : creases.pattern.edges) {
    creases.assignments.push_back(edge.kind == EdgeKind::Border ? Assignment::Border
                                                                : Assignment::Cut);
  }
  for (std::size_t i = 0; i < step.creases.size(); ++i) {
    const std::size_t e = creased->firstCrease + i;
    creases.assignments[e] = step.creases[i].assignment;
    Edge& edge = creases.pattern.edges[e];
    if (edge.kind == EdgeKind::Hinge) edge.angle = step.creases[i].angle;
  }
  return creases;
}

Result<PatternAnalysis> analysisOf(AssignedPattern creases, const Progress& progress) {
  PatternAnalysis analysis{std::move(creases), {}, {}, {}, {}};
  if (!goesOn(progress, 0)) return Error{ErrorCode::Cancelled, "", {}};
  analysis.faults = vertexFaults(analysis.creases);
  Result<FlatFolding> folding = flatFold(analysis.creases, {}, progress);
  if (!folding) {
    if (folding.error().code == ErrorCode::Cancelled) return folding.error();
    analysis.problem = folding.error();
    return analysis;
  }
  analysis.folding = std::move(*folding);
  const LayerStates& states = analysis.folding->states;
  for (std::size_t i = 0; states.exist() && i < states.componentCount(); ++i) {
    analysis.componentFacets.push_back(facetsOfComponent(states, i));
  }
  return analysis;
}

std::optional<LayerValues> valuesOf(const FlatFolding& folding, const FoldedState& after) {
  if (!isThisPatternFlat(folding, after)) return std::nullopt;
  const bool isUp = isUpward(folding, after, after.layers.sets().front().normal);
  const std::vector<FacetPair>& pairs = folding.states.problem().pairs;
  LayerValues values(pairs.size());
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    values[i] = after.layers.isAbove(pairs[i].a, pairs[i].b) == isUp;
  }
  return values;
}

PatternStep withLayers(PatternStep step, const FlatFolding& folding, const LayerValues& values,
                       const FoldedState* after) {
  step.isFolded = true;
  step.layers.clear();
  step.exceptions.clear();
  const OrderProblem& problem = folding.states.problem();
  if (!after || !isThisPatternFlat(folding, *after)) {
    nameLayers(foldedStateOf(folding.creases, problem, values), step);
    return step;
  }
  FoldedState chosen = *after;
  LayerSet set = layerOrderOf(problem, values).sets().front();
  const Vec3 normal = after->layers.sets().front().normal;
  set.normal = isUpward(folding, *after, normal) ? normal : -normal;
  chosen.layers = LayerOrder({std::move(set)});
  nameLayers(chosen, step);
  return step;
}

Result<std::vector<Literal>> wantedBy(const FlatFolding& folding, const LayerWish& wish) {
  const FacetFinder finder(folding.creases.pattern);
  const std::optional<FacetId> upper = finder.at(wish.upper);
  if (!upper) {
    return Error{ErrorCode::NotFound, "this paper does not belong to the crease pattern", {}};
  }
  const OrderProblem& problem = folding.states.problem();
  const bool isSeenFromAbove = wish.showsFront == !folding.map.poses[upper->index].isFlipped;
  std::vector<Literal> wanted;
  for (const Vec2 place : wish.lower) {
    const std::optional<FacetId> lower = finder.at(place);
    if (!lower || *lower == *upper) continue;
    const bool isFirst = *upper < *lower;
    const std::uint32_t pair =
        isFirst ? problem.indexOf(*upper, *lower) : problem.indexOf(*lower, *upper);
    if (pair == OrderProblem::kNone) continue;
    wanted.emplace_back(pair, isFirst != isSeenFromAbove);
  }
  if (wanted.empty()) {
    return Error{ErrorCode::NotFound,
                 "no other paper of the crease pattern lies there; click where layers overlap",
                 {}};
  }
  return wanted;
}

}  // namespace kiri
