// Setting an angle with about 1,024 facets, everything on the way checked. Figures and targets:
// docs/benchmarks.md.
// SPDX-License-Identifier: MIT
#include <benchmark/benchmark.h>

#include <string>

#include "core/fold/fold_line.h"
#include "core/model/apply.h"

namespace kiri::bench {
namespace {

FoldedState folded(const FoldedState& state, Vec2 from, Vec2 to, FoldType type, double angle,
                   Hand moving = Hand::Left) {
  FoldStep fold;
  fold.line = {Frame::Model, from, to, std::nullopt};
  fold.type = type;
  fold.angle = angle;
  fold.moving = moving;
  Step step;
  step.action = fold;
  return apply(state, step, static_cast<int>(state.lines.size()) + 1).value();
}

/// The sheet halved again and again onto its upper right corner.
FoldedState halved(FoldedState state, double size, int folds) {
  double left = 0;
  double top = size;
  for (int k = 0; k < folds; ++k) {
    if (k % 2 == 0) {
      left = (left + size) / 2;
      state = folded(state, {left, -size}, {left, 2 * size}, FoldType::Valley, 180);
    } else {
      top /= 2;
      state = folded(state, {-size, top}, {3 * size, top}, FoldType::Valley, 180);
    }
  }
  return state;
}

/// A strip in zigzag: each crease stands open by 120 degrees.
FoldedState zigzag(int facets) {
  FoldedState state = flatState(*rectangleSheet(facets, 40));
  // From the right, so that what is creased next still lies in the plane of the viewer.
  for (int k = facets - 1; k > 0; --k) {
    const FoldType type = k % 2 == 0 ? FoldType::Valley : FoldType::Mountain;
    FoldStep fold;
    fold.line = {Frame::Paper, {1.0 * k, 0}, {1.0 * k, 40}, Vec2{0.5, 20}};
    fold.type = type;
    fold.angle = 60;
    fold.moving = Hand::Right;
    Step step;
    step.action = fold;
    state = apply(state, step, facets - k).value();
  }
  return state;
}

FoldLineId lineAt(const FoldedState& state, std::size_t index) {
  return FoldLineId(index < state.lines.size() ? index : state.lines.size() - 1);
}

void set(benchmark::State& bench, const FoldedState& state, FoldLineId line, double amount) {
  std::size_t collisions = 0;
  for (auto _ : bench) {
    const Result<FoldedState> next = setAmount(state, line, amount);
    if (!next) {
      bench.SkipWithError(next.error().message.c_str());
      return;
    }
    collisions = next->collisions.size();
    benchmark::DoNotOptimize(&next);
  }
  bench.counters["facets"] = static_cast<double>(state.pattern.facets.size());
  bench.counters["collisions"] = static_cast<double>(collisions);
}

/// All layers of a flat packet, opened at the last fold.
void SetAngleFlat(benchmark::State& bench) {
  const FoldedState state = halved(flatState(*squareSheet(100)), 100, 10);
  set(bench, state, lineAt(state, 9), 90);
}
BENCHMARK(SetAngleFlat)->Unit(benchmark::kMillisecond);

/// Half of a zigzag swings past the other half.
void SetAngleZigzag(benchmark::State& bench) {
  const FoldedState state = zigzag(static_cast<int>(bench.range(0)));
  set(bench, state, lineAt(state, state.lines.size() / 2), 20);
}
BENCHMARK(SetAngleZigzag)->Arg(128)->Arg(1024)->Unit(benchmark::kMillisecond);

/// A packet of 512 layers bent up and bent back: three planes with many layers each.
void SetAngleBent(benchmark::State& bench) {
  FoldedState state = halved(flatState(*squareSheet(100)), 100, 9);
  state = folded(state, {99, -50}, {98, 150}, FoldType::Valley, 70, Hand::Right);
  state = folded(state, {98, -50}, {97, 150}, FoldType::Mountain, 70, Hand::Left);
  set(bench, state, lineAt(state, 9), 100);
}
BENCHMARK(SetAngleBent)->Unit(benchmark::kMillisecond);

/// The same of a disc, where many facets have a curved border.
void SetAngleCurved(benchmark::State& bench) {
  FoldedState state = halved(flatState(*discSheet(100)), 200, 9);
  state = folded(state, {198, -50}, {197, 250}, FoldType::Valley, 70, Hand::Right);
  state = folded(state, {196, -50}, {195, 250}, FoldType::Mountain, 70, Hand::Left);
  set(bench, state, lineAt(state, 9), 100);
}
BENCHMARK(SetAngleCurved)->Unit(benchmark::kMillisecond);

/// A zigzag wall in the way of the flap beside it: what collides is found among all pairs.
void SetAngleThroughZigzag(benchmark::State& bench) {
  FoldedState state = zigzag(1024);
  set(bench, state, lineAt(state, state.lines.size() / 2), -150);
}
BENCHMARK(SetAngleThroughZigzag)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace kiri::bench
