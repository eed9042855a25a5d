// Applying a PatternStep: creases, fold lines, folded angles and layers.
// SPDX-License-Identifier: MIT
#include "core/model/pattern_step.h"

#include "core/base/text.h"
#include "core/model/pattern_creases.h"
#include "core/model/pattern_lines.h"

namespace kiri {
namespace {

/// The facet that stays where it is. Errors: NotFound - the step names a place without paper.
Result<FacetId> restingFacet(const CreasePattern& pattern, const PatternStep& step) {
  if (step.resting) {
    if (const std::optional<FacetId> named = facetAt(pattern, *step.resting)) return *named;
    return Error{ErrorCode::NotFound,
                 "there is no paper at " + text(*step.resting) +
                     " mm, where the facet that rests is meant to be; name a point on the sheet",
                 {{*step.resting}, {}, {}}};
  }
  FacetId largest(0);
  double most = 0;
  for (std::size_t f = 0; f < pattern.facets.size(); ++f) {
    const double area = areaOf(regionOf(pattern, FacetId(f)));
    const bool isMore = area - most > pattern.tolerance.fat() * pattern.tolerance.sheetSize();
    if (!isMore) continue;
    largest = FacetId(f);
    most = area;
  }
  return largest;
}

std::vector<double> targetsOf(const CreasedSheet& creased, const PatternStep& step) {
  std::vector<double> targets(creased.pattern.edges.size(), 0);
  for (std::size_t i = 0; i < step.creases.size(); ++i) {
    if (step.creases[i].assignment != Assignment::Cut)
      targets[creased.firstCrease + i] = step.creases[i].angle;
  }
  return targets;
}

/// One rest for each connected piece, all where the uncut sheet lay.
std::vector<Rest> restsOf(const CreasePattern& pattern, FacetId resting, const Rigid& pose) {
  std::vector<Rest> rests{{resting, pose}};
  const std::vector<std::uint32_t> piece = piecesOf(pattern);
  std::vector<bool> hasRest(piece.size(), false);
  hasRest[piece[resting.index]] = true;
  for (std::size_t f = 0; f < piece.size(); ++f) {
    if (hasRest[piece[f]]) continue;
    hasRest[piece[f]] = true;
    rests.push_back({FacetId(f), pose});
  }
  return rests;
}

/// All facets in the plane of the sheet, in the order of their numbers.
LayerOrder flatLayers(const CreasePattern& pattern, const Vec3& normal) {
  LayerSet set{normal, {}, {}};
  for (std::size_t f = 0; f < pattern.facets.size(); ++f) set.upward.push_back(FacetId(f));
  return LayerOrder({std::move(set)});
}

}  // namespace

std::string linesName(const PatternStep& step) { return step.name.empty() ? "crease" : step.name; }

Result<FoldedState> applyPattern(const FoldedState& state, const PatternStep& step, Movements*) {
  Result<CreasedSheet> creased = creasedSheet(state.pattern, step);
  if (!creased) return creased.error();
  const std::vector<double> targets = targetsOf(*creased, step);
  const Result<FacetId> resting = restingFacet(creased->pattern, step);
  if (!resting) return resting.error();
  FoldedState next(std::move(creased->pattern));
  next.collisions = state.collisions;
  next.rests = restsOf(next.pattern, *resting, state.poseOf(FacetId(0)));
  next.poses = derivePoses(next.pattern, next.rests);
  next.layers = flatLayers(next.pattern, state.layers.sets().front().normal);
  makeFoldLines(next, targets, *resting, linesName(step));
  return next;
}

void nameLayers(const FoldedState& after, PatternStep& step) {
  if (!step.resting) step.resting = interiorPointOf(after.pattern, after.rests.front().facet);
}

}  // namespace kiri
