// The layer order of a PatternStep: places on the paper to a LayerOrder, and back.
// SPDX-License-Identifier: MIT
#include "core/model/pattern_layers.h"

#include <algorithm>
#include <cmath>

#include "core/base/text.h"
#include "core/model/facet_finder.h"

namespace kiri {
namespace {

/// The facets of every plane in the order of `facets`; normals as the first of them lies.
std::vector<LayerSet> planesOf(const FoldedState& state, const std::vector<FacetId>& facets) {
  std::vector<LayerSet> sets;
  std::vector<Vec3> points;
  for (const FacetId f : facets) {
    const Rigid& pose = state.poseOf(f);
    const EdgeUse use = state.pattern[f].border.front();
    const Vec3 p = pose.apply(state.pattern[startOf(state.pattern, use)]);
    std::size_t home = sets.size();
    for (std::size_t s = 0; s < sets.size() && home == sets.size(); ++s) {
      const bool isSame = length(cross(sets[s].normal, pose.normal())) <= kSamePlane &&
                          std::abs(dot(sets[s].normal, p - points[s])) <= state.tolerance().match();
      if (isSame) home = s;
    }
    if (home == sets.size()) {
      sets.push_back({pose.normal(), {}, {}});
      points.push_back(p);
    }
    sets[home].upward.push_back(f);
  }
  return sets;
}

/// The direction that a plane's facets are listed along: see PatternStep::layers. `names`: the
/// point of each facet.
Vec3 upOfPlane(const FoldedState& state, const LayerSet& set, const std::vector<Vec2>& names) {
  const Vec3 front = state.poseOf(state.rests.front().facet).normal();
  const double along = dot(set.normal, front);
  // Far from rounding: a plane that is nearly at right angles is told from its own facet too.
  constexpr double kNearlyUpright = 1.0 / 1024;
  if (std::abs(along) > kNearlyUpright) return along > 0 ? set.normal : -set.normal;
  const FacetId first =
      *std::min_element(set.upward.begin(), set.upward.end(), [&](FacetId a, FacetId b) {
        const Vec2 p = names[a.index];
        const Vec2 q = names[b.index];
        return p.x != q.x ? p.x < q.x : p.y < q.y;
      });
  return state.poseOf(first).normal();
}

/// Reads the places of one step.
class Reading {
 public:
  Reading(const FoldedState& state, const PatternStep& step)
      : state_(state), step_(step), finder_(state.pattern) {}

  Result<LayerOrder> run() {
    const std::size_t count = state_.pattern.facets.size();
    std::vector<bool> isNamed(count, false);
    names_.resize(count);
    std::vector<FacetId> listed;
    for (const Vec2 p : step_.layers) {
      const Result<FacetId> facet = facetOf(p);
      if (!facet) return facet.error();
      if (isNamed[facet->index]) {
        return wrong(ErrorCode::BadValue,
                     "the layers name the facet at " + text(p) + " mm twice; leave one out", p);
      }
      isNamed[facet->index] = true;
      names_[facet->index] = p;
      listed.push_back(*facet);
    }
    for (std::size_t f = 0; f < count; ++f) {
      if (isNamed[f]) continue;
      const Vec2 p = namingPointOf(state_.pattern, FacetId(f));
      return wrong(ErrorCode::NotFound,
                   "the layers leave out the facet at " + text(p) +
                       " mm; name every facet once, or leave all layers out to have them found",
                   p);
    }
    sets_ = planesOf(state_, listed);
    for (LayerSet& set : sets_) set.normal = upOfPlane(state_, set, names_);
    if (const Status added = addExceptions(); !added) return added.error();
    return LayerOrder(std::move(sets_));
  }

 private:
  static Error wrong(ErrorCode code, std::string message, Vec2 p) {
    return {code, std::move(message), {{p}, {}, {p}}};
  }

  Result<FacetId> facetOf(Vec2 p) const {
    if (const std::optional<FacetId> facet = finder_.at(p)) return *facet;
    return wrong(ErrorCode::NotFound,
                 "the layers name a facet at " + text(p) +
                     " mm, where there is no paper; leave all layers out to have them found",
                 p);
  }

  Status addExceptions() {
    if (step_.exceptions.empty()) return std::monostate{};
    const LayerOrder order(sets_);
    for (const auto& [upper, lower] : step_.exceptions) {
      const Result<FacetId> above = facetOf(upper);
      if (!above) return above.error();
      const Result<FacetId> below = facetOf(lower);
      if (!below) return below.error();
      if (!order.areCoplanar(*above, *below)) {
        return wrong(ErrorCode::BadValue,
                     "the facets at " + text(upper) + " and " + text(lower) +
                         " mm lie in different planes, so neither is above the other; leave this "
                         "exception out",
                     upper);
      }
      // What the list says already is no exception to it.
      if (!order.isAbove(*above, *below))
        sets_[order.setOf(*above)].exceptions.insert({*above, *below});
    }
    return std::monostate{};
  }

  const FoldedState& state_;
  const PatternStep& step_;
  FacetFinder finder_;
  std::vector<Vec2> names_;
  std::vector<LayerSet> sets_;
};

}  // namespace

Result<LayerOrder> layersFrom(const FoldedState& state, const PatternStep& step) {
  return Reading(state, step).run();
}

void writeLayers(const FoldedState& state, PatternStep& step) {
  std::vector<Vec2> names;
  for (std::size_t f = 0; f < state.pattern.facets.size(); ++f)
    names.push_back(namingPointOf(state.pattern, FacetId(f)));
  step.layers.clear();
  step.exceptions.clear();
  for (const LayerSet& set : state.layers.sets()) {
    std::vector<Vec2> upward;
    for (const FacetId f : set.upward) upward.push_back(names[f.index]);
    const bool isUp = dot(upOfPlane(state, set, names), set.normal) > 0;
    if (!isUp) std::reverse(upward.begin(), upward.end());
    step.layers.insert(step.layers.end(), upward.begin(), upward.end());
    for (const auto& [upper, lower] : set.exceptions) {
      const Vec2 a = names[upper.index];
      const Vec2 b = names[lower.index];
      step.exceptions.emplace_back(isUp ? a : b, isUp ? b : a);
    }
  }
}

LayerOrder unorderedLayers(const FoldedState& state) {
  std::vector<FacetId> all;
  for (std::size_t f = 0; f < state.pattern.facets.size(); ++f) all.emplace_back(f);
  return LayerOrder(planesOf(state, all));
}

}  // namespace kiri
