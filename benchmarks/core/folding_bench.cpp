// Folding, replaying, and what a state weighs. Figures and targets: docs/benchmarks.md.
// SPDX-License-Identifier: MIT
#include <benchmark/benchmark.h>

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "benchmarks/core/heap.h"
#include "core/model/apply.h"
#include "core/model/replay.h"

namespace kiri::bench {
namespace {

Step foldStep(Frame frame, Vec2 from, Vec2 to, FoldType type = FoldType::Valley) {
  FoldStep fold;
  fold.line = {frame, from, to, std::nullopt};
  fold.type = type;
  Step step;
  step.action = fold;
  return step;
}

/// Fold `number` (from 0) of the halving sequence of a unit square: the left half is turned onto
/// the right one, then the upper onto the lower, and so on.
Step halving(int number) {
  const double left =
      1 - std::ldexp(1.0, -(number + 1) / 2);  // the paper is left..1 wide and 0..top high
  const double top = std::ldexp(1.0, -(number / 2));
  if (number % 2 == 0) {
    const double x = (left + 1) / 2;
    return foldStep(Frame::Model, {x, -1}, {x, 2});
  }
  return foldStep(Frame::Model, {-1, top / 2}, {3, top / 2});
}

FoldedState halved(int folds) {
  FoldedState state = flatState(*squareSheet(1));
  for (int k = 0; k < folds; ++k) state = apply(state, halving(k), k + 1).value();
  return state;
}

void report(benchmark::State& bench, const FoldedState& state) {
  bench.counters["facets"] = static_cast<double>(state.pattern.facets.size());
}

void Halving(benchmark::State& bench) {
  const int folds = static_cast<int>(bench.range(0));
  std::size_t facets = 0;
  for (auto _ : bench) {
    const FoldedState state = halved(folds);
    facets = state.pattern.facets.size();
    benchmark::DoNotOptimize(facets);
  }
  if (facets != std::size_t{1} << folds) bench.SkipWithError("the halving sequence lost a facet");
  bench.counters["facets"] = static_cast<double>(facets);
}
BENCHMARK(Halving)->DenseRange(1, 12)->Unit(benchmark::kMillisecond);

/// One more fold through all layers of 2^folds facets.
void OneFold(benchmark::State& bench) {
  const int folds = static_cast<int>(bench.range(0));
  const FoldedState state = halved(folds);
  const Step step = halving(folds);
  for (auto _ : bench) benchmark::DoNotOptimize(apply(state, step, folds + 1));
  report(bench, state);
}
BENCHMARK(OneFold)->Arg(8)->Arg(10)->Arg(11)->Unit(benchmark::kMillisecond);

/// The angle of the first line that can move: all facets turn, none is divided.
void OpenLastFold(benchmark::State& bench) {
  const int folds = static_cast<int>(bench.range(0));
  const FoldedState state = halved(folds);
  Step step;
  step.action = AngleStep{"fold " + std::to_string(folds), 90};
  for (auto _ : bench) benchmark::DoNotOptimize(apply(state, step, folds + 1));
  report(bench, state);
}
BENCHMARK(OpenLastFold)->Arg(10)->Arg(12)->Unit(benchmark::kMillisecond);

/// Heap bytes of one state, by copying it.
void BytesPerFacet(benchmark::State& bench) {
  const FoldedState state = halved(static_cast<int>(bench.range(0)));
  std::size_t bytes = 0;
  for (auto _ : bench) {
    const std::size_t before = heapBytes();
    const FoldedState copy = state;
    bytes = heapBytes() - before;
    benchmark::DoNotOptimize(&copy);
  }
  report(bench, state);
  bench.counters["bytes_per_facet"] =
      static_cast<double>(bytes) / static_cast<double>(state.pattern.facets.size());
}
BENCHMARK(BytesPerFacet)->Arg(8)->Arg(12)->Unit(benchmark::kMillisecond);

constexpr Vec2 kPetiole{100, 0};

Vec2 onRay(double degrees, double length) {
  const CosSin turn = cosSinDegrees(degrees);
  return kPetiole + Vec2{turn.cos, turn.sin} * length;
}

Step pleat(double degrees, double inBeyond) {
  FoldStep fold;
  const Vec2 beyond = onRay(inBeyond, 20);
  fold.line = {Frame::Paper, kPetiole, onRay(degrees, 300), beyond};
  fold.moving = MovingPoint{{Frame::Paper, beyond}};
  fold.layers = ChosenLayers{{{Frame::Paper, beyond}}};
  Step step;
  step.action = fold;
  return step;
}

/// A palmate leaf in 100 steps: nine pleats through the petiole, one margin cut through all layers,
/// then unfolding, refolding, turning, angles, an edge and a tear, over and over.
Model leaf() {
  Model model;
  model.sheet.shape = SheetSpec::Shape::Rectangle;
  model.sheet.width = 200;
  model.sheet.height = 120;
  const int pleats = 9;
  const auto axis = [](int i) { return 30 + 13.0 * i; };
  for (int i = 0; i < pleats; ++i)
    model.steps.push_back(pleat(axis(i), axis(i) + (i + 1 < pleats ? 6.5 : 3)));
  CurveCutStep cut;
  for (int i = 0; i <= 8; ++i)
    cut.controls.push_back(onRay(-20 + 220.0 * i / 8, 60 + 12 * (i % 3)));
  cut.keep.places.push_back({Frame::Model, onRay(20, 5)});
  Step margin;
  margin.action = cut;
  model.steps.push_back(margin);
  const auto add = [&model](Action action) {
    Step step;
    step.action = std::move(action);
    model.steps.push_back(std::move(step));
  };
  for (int round = 0; model.steps.size() < 100; ++round) {
    const std::string last = "fold " + std::to_string(pleats);
    switch (round % 6) {
      case 0:
        add(UnfoldStep{});
        break;
      case 1:
        add(RefoldStep{});
        break;
      case 2:
        add(AngleStep{last, 60});
        break;
      case 3:
        add(AngleStep{last, 180});
        break;
      case 4:
        add(TurnOverStep{});
        break;
      default:
        add(RotateStep{15, std::nullopt});
        break;
    }
  }
  return model;
}

void ReplayLeaf(benchmark::State& bench) {
  const Model model = leaf();
  for (auto _ : bench) {
    const Result<Replay> replayed = replay(model);
    const auto last = replayed->after(model.steps.size());
    if (!last) {
      bench.SkipWithError(last.error().message.c_str());
      return;
    }
    bench.counters["facets"] = static_cast<double>((*last)->pattern.facets.size());
  }
  bench.counters["steps"] = static_cast<double>(model.steps.size());
}
BENCHMARK(ReplayLeaf)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace kiri::bench
