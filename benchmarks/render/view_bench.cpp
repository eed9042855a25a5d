// Time to look at partly folded paper from any side. Figures and targets: docs/benchmarks.md.
// SPDX-License-Identifier: MIT
#include <benchmark/benchmark.h>

#include <cmath>
#include <cstddef>
#include <utility>

#include "core/paper/loose_facet.h"
#include "render/scene/model_scene.h"
#include "render/visibility/plane_regions.h"
#include "render/visibility/visible_regions.h"
#include "tests/support/random_steps.h"

namespace kiri {
namespace {

/// A sheet corrugated in both directions (Miura), n x n facets, each in a plane of its own.
FoldedState corrugated(std::size_t n) {
  const double side = 200.0 / static_cast<double>(n);
  FoldedState state(CreasePattern(Tolerance(200 * std::sqrt(2.0))));
  std::vector<LayerSet> sets;
  const auto corner = [&](std::size_t i, std::size_t j) {
    return Vec3{0.8 * side * static_cast<double>(i) + (j % 2 == 1 ? 0.3 * side : 0),
                0.9 * side * static_cast<double>(j), i % 2 == 1 ? 0.6 * side : 0};
  };
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < n; ++j) {
      const Vec3 origin = corner(i, j);
      const Vec3 along = corner(i + 1, j) - origin;
      const Vec3 across = corner(i, j + 1) - origin;
      Rigid pose;
      pose.x = normalized(along);
      pose.z = normalized(cross(along, across));
      pose.y = cross(pose.z, pose.x);
      pose.origin = origin;
      const Vec2 u{length(along), 0};
      const Vec2 v{dot(across, pose.x), dot(across, pose.y)};
      const Vec2 corners[] = {{0, 0}, u, u + v, v};
      const FacetId id = addLooseFacet(state.pattern, corners);
      state.poses.push_back(pose);
      sets.push_back({pose.normal(), {id}, {}});
    }
  }
  state.layers = LayerOrder(std::move(sets));
  return state;
}

/// The same facets anywhere in a cube, turned anyhow: they pass through each other and hide each
/// other in rings.
FoldedState tangled(std::size_t n) {
  FoldedState state = corrugated(n);
  test::Random random(3);
  std::vector<LayerSet> sets;
  for (std::size_t f = 0; f < state.poses.size(); ++f) {
    const Vec3 to{random.between(0, 60), random.between(0, 60), random.between(0, 60)};
    const Rigid turn = compose(rotationAbout(to, {1, 0, 0}, random.between(0, 360)),
                               rotationAbout(to, {0, 0, 1}, random.between(0, 360)));
    state.poses[f] = compose(turn, translation(to));
    sets.push_back({state.poses[f].normal(), {FacetId(f)}, {}});
  }
  state.layers = LayerOrder(std::move(sets));
  return state;
}

// Made once: the arguments of a benchmark are evaluated anew for each of its runs.
const FoldedState& folded() {
  static const FoldedState state = corrugated(32);
  return state;
}
const FoldedState& tangle() {
  static const FoldedState state = tangled(32);
  return state;
}

void report(benchmark::State& run, const FoldedState& state) {
  run.counters["facets"] = static_cast<double>(state.pattern.facets.size());
  run.counters["planes"] = static_cast<double>(state.layers.sets().size());
}

void exactView(benchmark::State& run, const FoldedState& state, double fieldOfView) {
  const Sphere sphere = sphereOf(state);
  double azimuth = 0;
  std::size_t pieces = 0;
  for (auto _ : run) {
    azimuth += 7;
    const ViewFrame view = *frameOf({std::fmod(azimuth, 360), 35, fieldOfView}, sphere);
    const VisibleRegions regions = visibleRegions(state, view);
    pieces = 0;
    for (const VisibleFacet& facet : regions.facets) {
      for (const auto& loop : facet.loops) pieces += loop.size();
    }
  }
  run.counters["pieces"] = static_cast<double>(pieces);
  report(run, state);
}

void orbit(benchmark::State& run, const FoldedState& state) {
  const std::vector<PlaneRegions> planes = planeRegions(state);
  double azimuth = 0;
  for (auto _ : run) {
    azimuth += 7;
    const ViewFrame view = viewFrom(std::fmod(azimuth, 360), 35);
    std::size_t parts = 0;
    for (const PlaneRegions& plane : planes) parts += plane.seenFrom(view).facets.size();
    benchmark::DoNotOptimize(parts);
  }
  report(run, state);
}

void planes(benchmark::State& run, const FoldedState& state) {
  for (auto _ : run) benchmark::DoNotOptimize(planeRegions(state));
  report(run, state);
}

void shadowed(benchmark::State& run, const FoldedState& state) {
  ViewSpec spec{30, 35, 30};
  spec.isShaded = spec.hasShadow = true;
  for (auto _ : run) benchmark::DoNotOptimize(modelScene(state, {}, spec));
  report(run, state);
}

BENCHMARK_CAPTURE(exactView, corrugated, folded(), 0)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(exactView, corrugatedPerspective, folded(), 40)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(exactView, tangled, tangle(), 0)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(planes, corrugated, folded())->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(planes, tangled, tangle())->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(orbit, corrugated, folded())->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(orbit, tangled, tangle())->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(shadowed, corrugated, folded())->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace kiri
