// Import, flat map, cells and rules of large patterns. Figures and targets: docs/benchmarks.md; the
// peers' are import, fold and cells of 11,859 facets in 0.6 s, setup of 422,273 pairs in 149 s.
// SPDX-License-Identifier: MIT
#include <benchmark/benchmark.h>

#include <fstream>
#include <sstream>
#include <string>

#include "core/creases/repair.h"
#include "core/flatfold/folded_ground.h"
#include "core/flatfold/local_conditions.h"
#include "io/patterns/pattern_file.h"
#include "tests/core/flatfold/flat_patterns.h"

namespace kiri::bench {
namespace {

void countersOf(benchmark::State& state, const AssignedPattern& creases,
                const GroundAndOrders& ground) {
  state.counters["facets"] = static_cast<double>(creases.pattern.facets.size());
  state.counters["cells"] = static_cast<double>(ground.ground.cells.size());
  state.counters["pairs"] = static_cast<double>(ground.problem.pairs.size());
  state.counters["rules"] =
      static_cast<double>(ground.problem.same.size() + ground.problem.interleavings.size());
}

/// Flat map, cells and rules of a pattern; false when it does not fold.
bool layOut(benchmark::State& state, const AssignedPattern& creases) {
  const Result<FlatMap> map = flatMapOf(creases);
  if (!map) return false;
  const Result<GroundAndOrders> ground = overlapsOf(creases, *map);
  if (!ground) return false;
  countersOf(state, creases, *ground);
  return true;
}

/// From lines to rules: square twists side by side; 54 x 54 of them have 11,881 facets.
void tessellationFromLines(benchmark::State& state) {
  const CreaseDrawing drawing =
      drawingOf(test::twistTessellation(static_cast<int>(state.range(0))));
  for (auto _ : state) {
    const Result<RepairedPattern> repaired = patternOf(drawing);
    if (!repaired || !layOut(state, repaired->creases)) state.SkipWithError("does not fold");
  }
}
BENCHMARK(tessellationFromLines)->Arg(12)->Arg(37)->Arg(54)->Unit(benchmark::kMillisecond);

void rulesAroundVertices(benchmark::State& state) {
  const AssignedPattern creases = test::twistTessellation(static_cast<int>(state.range(0)));
  for (auto _ : state) benchmark::DoNotOptimize(vertexFaults(creases));
  state.counters["facets"] = static_cast<double>(creases.pattern.facets.size());
}
BENCHMARK(rulesAroundVertices)->Arg(54)->Unit(benchmark::kMillisecond);

/// Reading, repairing and laying out a real file, where the files are beside the checkout.
void realFile(benchmark::State& state, const std::string& name) {
  std::ifstream in(std::string(KIRI_SOURCE_DIR) + "/../shared/data/patterns/flat-folder/" + name);
  std::stringstream text;
  text << in.rdbuf();
  if (text.str().empty()) {
    state.SkipWithError("the patterns are not beside the checkout");
    return;
  }
  for (auto _ : state) {
    const Result<PatternFile> file = readPattern(text.str(), name);
    const Result<RepairedPattern> repaired = patternOf(file->drawing);
    if (!repaired || !layOut(state, repaired->creases)) state.SkipWithError("does not fold");
  }
}
BENCHMARK_CAPTURE(realFile, chalcosoma736, "instagram/252_imai_Chalcosoma_Chiron.fold")
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(realFile, shrimp1714, "instagram/037_imai_Shrimp_v2.fold")
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(realFile, sierpinski3871,
                  "instagram/284_beber_Sierpinski-Penrose_Triangle_#2.fold")
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace kiri::bench
