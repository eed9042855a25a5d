// Finding and counting layer orders: real patterns where they are there, and maps. Figures and
// targets: docs/benchmarks.md.
// SPDX-License-Identifier: MIT
#include <benchmark/benchmark.h>

#include <fstream>
#include <optional>
#include <sstream>
#include <string>

#include "core/creases/repair.h"
#include "core/flatfold/flat_folding.h"
#include "io/patterns/pattern_file.h"
#include "tests/core/flatfold/made_problems.h"

namespace kiri::bench {
namespace {

std::optional<AssignedPattern> realPattern(const std::string& name) {
  std::ifstream in(std::string(KIRI_SOURCE_DIR) + "/../shared/data/patterns/flat-folder/" + name,
                   std::ios::binary);
  std::stringstream text;
  text << in.rdbuf();
  const Result<PatternFile> file = readPattern(text.str(), name);
  if (!file) return std::nullopt;
  Result<RepairedPattern> repaired = patternOf(file->drawing);
  if (!repaired) return std::nullopt;
  return std::move(repaired->creases);
}

void tell(benchmark::State& bench, const LayerStates& states) {
  bench.counters["pairs"] = static_cast<double>(states.problem().pairs.size());
  bench.counters["components"] = static_cast<double>(states.componentCount());
}

/// Folds, divides the ground, finds one state: everything after the repairs.
void firstState(benchmark::State& bench, const std::string& name) {
  const std::optional<AssignedPattern> creases = realPattern(name);
  if (!creases) return bench.SkipWithError("the shared patterns are not here");
  for (auto _ : bench) {
    const Result<FlatFolding> folding = flatFold(*creases);
    benchmark::DoNotOptimize(folding->states.exist());
    bench.PauseTiming();
    tell(bench, folding->states);
    bench.ResumeTiming();
  }
}

/// The same, and the exact number of all states.
void allStates(benchmark::State& bench, const std::string& name) {
  const std::optional<AssignedPattern> creases = realPattern(name);
  if (!creases) return bench.SkipWithError("the shared patterns are not here");
  for (auto _ : bench) {
    Result<FlatFolding> folding = flatFold(*creases);
    if (!folding->states.count().isOk()) bench.SkipWithError("it was not counted");
    bench.PauseTiming();
    tell(bench, folding->states);
    bench.SetLabel(folding->states.total().str() + " states");
    bench.ResumeTiming();
  }
}

void countOfMap(benchmark::State& bench) {
  const auto side = static_cast<std::size_t>(bench.range(0));
  const OrderProblem problem = test::mapProblem(side, static_cast<std::size_t>(bench.range(1)));
  for (auto _ : bench) {
    Result<LayerStates> states = LayerStates::find(problem);
    if (!states->count().isOk()) bench.SkipWithError("it was not counted");
    benchmark::DoNotOptimize(states->total());
  }
}

void firstOfMap(benchmark::State& bench) {
  const auto side = static_cast<std::size_t>(bench.range(0));
  const OrderProblem problem = test::mapProblem(side, side);
  for (auto _ : bench) {
    const Result<LayerStates> states = LayerStates::find(problem);
    benchmark::DoNotOptimize(states->first().size());
  }
}

const std::string kChiron = "instagram/252_imai_Chalcosoma_Chiron.fold";
const std::string kChess = "instagram/036_ku_Checkerboard_26x26.fold";
const std::string kShrimp = "instagram/037_imai_Shrimp_v2.fold";
const std::string kTurtle = "instagram/266_kamiya_Turtle.fold";
const std::string kMantis = "instagram/095_imai_Mantis_v2-8.fold";
const std::string kStag = "instagram/046_imai_Prosopocoilus_Inclinatus_v3-1.fold";
const std::string kTarantula = "unsatisfiable/012_imai_Tarantula_(old).fold";

BENCHMARK_CAPTURE(allStates, Beetle736, kChiron)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(allStates, Chess944, kChess)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(allStates, Turtle583, kTurtle)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(allStates, Mantis1528, kMantis)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(allStates, Shrimp1714, kShrimp)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(firstState, Shrimp1714, kShrimp)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(firstState, Prosopocoilus1426, kStag)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(firstState, Tarantula866WithoutState, kTarantula)->Unit(benchmark::kMillisecond);
BENCHMARK(countOfMap)->Args({3, 4})->Args({4, 4})->Unit(benchmark::kMillisecond);
BENCHMARK(firstOfMap)->Arg(8)->Arg(10)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace kiri::bench
