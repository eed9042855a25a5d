// Drawings of the sizes that people have, and larger ones, on their way to patterns.
// SPDX-License-Identifier: MIT
#include <benchmark/benchmark.h>

#include <cmath>

#include "core/creases/repair.h"
#include "tests/support/random_steps.h"

namespace kiri {
namespace {

using test::Random;

/// A grid of n x n squares with a crease along every second diagonal: 3.5 n^2 lines of one square.
CreaseDrawing gridOfSquares(int n) {
  CreaseDrawing drawing;
  const auto at = [](int x, int y) { return Vec2{x * 1.1, y * 1.1}; };
  for (int y = 0; y <= n; ++y) {
    for (int x = 0; x <= n; ++x) {
      const auto kind = [&](int i) {
        return i == 0 || i == n ? Assignment::Border
                                : (i % 2 == 0 ? Assignment::Mountain : Assignment::Valley);
      };
      if (x < n) drawing.lines.push_back({at(x, y), at(x + 1, y), kind(y), {}});
      if (y < n) drawing.lines.push_back({at(x, y), at(x, y + 1), kind(x), {}});
      if (x < n && y < n && (x + y) % 2 == 0)
        drawing.lines.push_back({at(x, y), at(x + 1, y + 1), Assignment::Valley, {}});
    }
  }
  return drawing;
}

void run(benchmark::State& state, const CreaseDrawing& drawing) {
  std::size_t facets = 0;
  for (auto _ : state) {
    const Result<RepairedPattern> pattern = patternOf(drawing);
    if (!pattern) {
      state.SkipWithError(pattern.error().message.c_str());
      return;
    }
    facets = pattern->creases.pattern.facets.size();
  }
  state.counters["lines"] = static_cast<double>(drawing.lines.size());
  state.counters["facets"] = static_cast<double>(facets);
}

/// Lines that meet at their ends, as FOLD files have them. 63: 10,000 lines, 200: 100,000.
void cleanDrawing(benchmark::State& state) {
  run(state, gridOfSquares(static_cast<int>(state.range(0))));
}
BENCHMARK(cleanDrawing)->Arg(39)->Arg(63)->Arg(200)->Unit(benchmark::kMillisecond);

/// The same with every end a little off.
void noisyDrawing(benchmark::State& state) {
  CreaseDrawing drawing = gridOfSquares(static_cast<int>(state.range(0)));
  Random random(1);
  for (DrawnCrease& line : drawing.lines) {
    for (Vec2* end : {&line.from, &line.to})
      *end = *end + Vec2{random.between(-1e-4, 1e-4), random.between(-1e-4, 1e-4)};
  }
  run(state, drawing);
}
BENCHMARK(noisyDrawing)->Arg(63)->Arg(200)->Unit(benchmark::kMillisecond);

/// Long lines that cross without a vertex, as .cp files have them: n across, n up, n aslant.
void crossingLines(benchmark::State& state) {
  const int n = static_cast<int>(state.range(0));
  CreaseDrawing drawing;
  for (int i = 0; i <= n; ++i) {
    const double t = 100.0 * i / n;
    const Assignment kind = i == 0 || i == n ? Assignment::Border : Assignment::Mountain;
    drawing.lines.push_back({{t, 0}, {t, 100}, kind, {}});
    drawing.lines.push_back({{0, t}, {100, t}, kind, {}});
    if (i > 0 && i < n) drawing.lines.push_back({{0, t}, {100 - t, 100}, Assignment::Valley, {}});
  }
  run(state, drawing);
}
BENCHMARK(crossingLines)->Arg(50)->Arg(150)->Unit(benchmark::kMillisecond);

/// Short lines anywhere: most end inside facets and are left out.
void scatteredLines(benchmark::State& state) {
  Random random(1);
  CreaseDrawing drawing;
  const std::size_t n = static_cast<std::size_t>(state.range(0));
  for (std::size_t i = 0; i < n; ++i) {
    const Vec2 p{random.between(0, 100), random.between(0, 100)};
    const double reach = 60 / std::sqrt(static_cast<double>(n));
    drawing.lines.push_back({p,
                             p + Vec2{random.between(-reach, reach), random.between(-reach, reach)},
                             Assignment::Cut,
                             {}});
  }
  const Vec2 corners[] = {{-1, -1}, {101, -1}, {101, 101}, {-1, 101}, {-1, -1}};
  for (int i = 0; i < 4; ++i)
    drawing.lines.push_back({corners[i], corners[i + 1], Assignment::Border, {}});
  run(state, drawing);
}
BENCHMARK(scatteredLines)->Arg(10'000)->Arg(100'000)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace kiri
