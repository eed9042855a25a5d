// What the kernel asks of core/geometry thousands of times for each step.
// SPDX-License-Identifier: MIT
#include <benchmark/benchmark.h>

#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

#include "core/geometry/convex.h"
#include "core/geometry/cubic.h"
#include "core/geometry/region.h"
#include "core/geometry/rigid.h"

namespace kiri {
namespace {

const Tolerance kTolerance(200);

std::vector<Vec2> ring(std::int64_t corners, double radius, Vec2 centre) {
  std::vector<Vec2> points;
  for (std::int64_t i = 0; i < corners; ++i) {
    const double angle =
        2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(corners);
    points.push_back(centre + Vec2{std::cos(angle), std::sin(angle)} * radius);
  }
  return points;
}

Region regionOf(const std::vector<Vec2>& corners) {
  Loop loop;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    loop.push_back(Arc::line(corners[i], corners[(i + 1) % corners.size()]));
  }
  return {{loop}};
}

/// A leaf-like margin: `waves` waves, each of two cubics.
Region wavy(int waves) {
  Loop loop;
  const int pieces = 2 * waves;
  for (int i = 0; i < pieces; ++i) {
    const auto at = [&](double k, double radius) {
      const double angle = 2 * std::numbers::pi * k / pieces;
      return Vec2{std::cos(angle), std::sin(angle)} * radius;
    };
    const double low = i % 2 == 0 ? 40 : 60;
    const double high = 100 - low;
    loop.push_back(Arc::cubic(at(i, low), at(i + 0.4, low), at(i + 0.6, high), at(i + 1, high)));
  }
  for (std::size_t i = 0; i < loop.size(); ++i) loop[i].end = loop[(i + 1) % loop.size()].start;
  return {{loop}};
}

void overlapOfConvexFacets(benchmark::State& state) {
  const std::vector<Vec2> a = ring(state.range(0), 50, {0, 0});
  const std::vector<Vec2> b = ring(state.range(0), 50, {20, 13});
  for (auto _ : state) benchmark::DoNotOptimize(overlap(a, b, kTolerance.fat()));
}
BENCHMARK(overlapOfConvexFacets)->Arg(4)->Arg(8);

void overlapOfNeighbours(benchmark::State& state) {
  const std::vector<Vec2> a = ring(4, 50, {0, 0});
  const std::vector<Vec2> b = ring(4, 50, {50, 50});
  for (auto _ : state) benchmark::DoNotOptimize(overlap(a, b, kTolerance.fat()));
}
BENCHMARK(overlapOfNeighbours);

void intersectionOfConvexFacets(benchmark::State& state) {
  const std::vector<Vec2> a = ring(state.range(0), 50, {0, 0});
  const std::vector<Vec2> b = ring(state.range(0), 50, {20, 13});
  for (auto _ : state) benchmark::DoNotOptimize(intersection(a, b, kTolerance.length()));
}
BENCHMARK(intersectionOfConvexFacets)->Arg(4)->Arg(8);

void locateInConvexFacet(benchmark::State& state) {
  const Region region = regionOf(ring(4, 50, {0, 0}));
  for (auto _ : state) benchmark::DoNotOptimize(locate(region, {7, 11}, kTolerance.length()));
}
BENCHMARK(locateInConvexFacet);

void locateInCurvedFacet(benchmark::State& state) {
  const Region region = wavy(20);
  for (auto _ : state) benchmark::DoNotOptimize(locate(region, {7, 11}, kTolerance.length()));
}
BENCHMARK(locateInCurvedFacet);

void partsOfConvexFacet(benchmark::State& state) {
  const Region region = regionOf(ring(4, 50, {0, 0}));
  for (auto _ : state) benchmark::DoNotOptimize(convexParts(region, kTolerance));
}
BENCHMARK(partsOfConvexFacet);

void partsOfCurvedFacet(benchmark::State& state) {
  const Region region = wavy(static_cast<int>(state.range(0)));
  std::size_t parts = 0;
  for (auto _ : state) parts = convexParts(region, kTolerance).size();
  std::size_t corners = 0;
  for (const Arc& arc : region.loops[0])
    corners += flatteningParameters(arc, kTolerance.flattening()).size() - 1;
  state.counters["corners"] = static_cast<double>(corners);
  state.counters["parts"] = static_cast<double>(parts);
}
BENCHMARK(partsOfCurvedFacet)->Arg(2)->Arg(8)->Arg(32);

void interiorPointOfConvexFacet(benchmark::State& state) {
  const Region region = regionOf(ring(4, 50, {0, 0}));
  for (auto _ : state) benchmark::DoNotOptimize(interiorPoint(region, kTolerance));
}
BENCHMARK(interiorPointOfConvexFacet);

void meetingsOfLines(benchmark::State& state) {
  const Arc a = Arc::line({0, 0}, {100, 40});
  const Arc b = Arc::line({10, 80}, {60, -20});
  for (auto _ : state) benchmark::DoNotOptimize(meetings(a, b, kTolerance));
}
BENCHMARK(meetingsOfLines);

void meetingsOfLineAndCubic(benchmark::State& state) {
  const Arc a = Arc::line({0, 20}, {100, 40});
  const Arc b = Arc::cubic({0, 0}, {40, 120}, {60, -60}, {100, 70});
  for (auto _ : state) benchmark::DoNotOptimize(meetings(a, b, kTolerance));
}
BENCHMARK(meetingsOfLineAndCubic);

void meetingsOfCubics(benchmark::State& state) {
  const Arc a = Arc::cubic({0, 70}, {40, -60}, {60, 120}, {100, 0});
  const Arc b = Arc::cubic({0, 0}, {40, 120}, {60, -60}, {100, 70});
  for (auto _ : state) benchmark::DoNotOptimize(meetings(a, b, kTolerance));
}
BENCHMARK(meetingsOfCubics);

void rotationOfAnyAngle(benchmark::State& state) {
  double degrees = 0;
  for (auto _ : state) {
    degrees += 0.37;
    benchmark::DoNotOptimize(rotationAbout({75, 0, 0}, {0.6, 0.8, 0}, degrees));
  }
}
BENCHMARK(rotationOfAnyAngle);

void rotationBy180(benchmark::State& state) {
  for (auto _ : state) benchmark::DoNotOptimize(rotationAbout({75, 0, 0}, {0.6, 0.8, 0}, 180));
}
BENCHMARK(rotationBy180);

}  // namespace
}  // namespace kiri
