// Time to find what is seen of 4,096 and 65,536 facets: near-linear in what is visible
// (guide/stack.md section 4). SPDX-License-Identifier: MIT
#include <benchmark/benchmark.h>

#include <cmath>
#include <cstdint>
#include <random>

#include "core/paper/folded_state.h"
#include "core/paper/loose_facet.h"
#include "render/visibility/visible_regions.h"

namespace kiri {
namespace {

/// How the n x n cells of a sheet lie.
enum class Lie {
  Stack,    ///< all on one cell, as after the halving sequence; rounding noise as poses have it
  Sheet,    ///< side by side, all visible
  Pleats,   ///< knife pleats in both directions: each cell mostly under its neighbours
  Scatter,  ///< anywhere on the sheet, any angle
};

void addCell(CreasePattern& pattern, double side, std::size_t i, std::size_t j) {
  const double x = side * static_cast<double>(i);
  const double y = side * static_cast<double>(j);
  const Vec2 corners[] = {{x, y}, {x + side, y}, {x + side, y + side}, {x, y + side}};
  addLooseFacet(pattern, corners);
}

Rigid poseOfCell(Lie lie, double side, std::size_t i, std::size_t j, std::mt19937& random) {
  std::uniform_real_distribution<double> noise(-1e-12, 1e-12);
  const double x = side * static_cast<double>(i);
  const double y = side * static_cast<double>(j);
  switch (lie) {
    case Lie::Sheet:
      return {};
    case Lie::Stack: {
      Rigid pose = translation({noise(random) - x, noise(random) - y, 0});
      if ((i + j) % 2 != 0) {  // back up: mirrored in the middle of the cell
        pose.x = {-1, 0, 0};
        pose.z = {0, 0, -1};
        pose.origin.x = x + side + noise(random);
      }
      return pose;
    }
    case Lie::Pleats:
      return translation({-x * 0.7 + noise(random), -y * 0.7 + noise(random), 0});
    case Lie::Scatter: {
      std::uniform_real_distribution<double> place(0, 200);
      std::uniform_real_distribution<double> angle(0, 360);
      const Vec3 to{place(random), place(random), 0};
      return compose(rotationAbout(to, {0, 0, 1}, angle(random)), translation(to - Vec3{x, y, 0}));
    }
  }
  return {};
}

FoldedState cells(Lie lie, std::size_t n) {
  const double side = 200.0 / static_cast<double>(n);
  FoldedState state(CreasePattern(Tolerance(200 * std::sqrt(2.0))));
  std::mt19937 random(7);
  LayerSet all{{0, 0, 1}, {}, {}};
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < n; ++j) {
      all.upward.emplace_back(state.pattern.facets.size());
      addCell(state.pattern, lie == Lie::Scatter ? side * 4 : side, i, j);
      state.poses.push_back(poseOfCell(lie, side, i, j, random));
    }
  }
  state.layers = LayerOrder({all});
  return state;
}

void seen(benchmark::State& run, Lie lie) {
  const FoldedState state = cells(lie, static_cast<std::size_t>(run.range(0)));
  std::size_t visible = 0;
  std::size_t pieces = 0;
  for (auto _ : run) {
    const VisibleRegions regions = visibleRegions(state, frontView());
    visible = regions.facets.size();
    pieces = 0;
    for (const VisibleFacet& facet : regions.facets) {
      for (const auto& loop : facet.loops) pieces += loop.size();
    }
  }
  run.counters["facets"] = static_cast<double>(state.pattern.facets.size());
  run.counters["visible"] = static_cast<double>(visible);
  run.counters["pieces"] = static_cast<double>(pieces);
}

BENCHMARK_CAPTURE(seen, stack, Lie::Stack)->Arg(64)->Arg(256)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(seen, sheet, Lie::Sheet)->Arg(64)->Arg(256)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(seen, pleats, Lie::Pleats)->Arg(64)->Arg(256)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(seen, scatter, Lie::Scatter)->Arg(64)->Arg(256)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace kiri
