// How long it takes to find the rigid motion of corrugated sheets, and a moment of it.
// SPDX-License-Identifier: MIT
#include <benchmark/benchmark.h>

#include "core/linkage/rigid_path.h"
#include "tests/support/pattern_text.h"

namespace kiri {
namespace {

struct Opening {
  test::Corrugation sheet;
  PathRequest request;
};

/// A sheet of n x n facets that opens from flat-folded by one driven hinge.
Opening openingOf(int n) {
  Opening opening{test::corrugationOf(n, n, 50), {}};
  test::Corrugation& sheet = opening.sheet;
  for (std::size_t e = 0; e < sheet.folded.size(); ++e)
    sheet.state.pattern.edges[e].angle = sheet.folded[e];
  opening.request.wanted.assign(sheet.folded.size(), 0);
  opening.request.driven = {EdgeId(sheet.zigzag[0])};
  for (const std::size_t e : sheet.straight) opening.request.free.push_back(EdgeId(e));
  for (std::size_t i = 1; i < sheet.zigzag.size(); ++i)
    opening.request.free.push_back(EdgeId(sheet.zigzag[i]));
  return opening;
}

void openingOfACorrugatedSheet(benchmark::State& state) {
  const Opening opening = openingOf(static_cast<int>(state.range(0)));
  for (auto _ : state) {
    const RigidPath path = rigidPath(opening.sheet.state, opening.request);
    if (!path.arrives()) state.SkipWithError("the sheet did not open");
  }
}
BENCHMARK(openingOfACorrugatedSheet)
    ->Arg(4)
    ->Arg(8)
    ->Arg(14)
    ->Arg(32)
    ->Unit(benchmark::kMillisecond);

void aMomentOfItsOpening(benchmark::State& state) {
  const Opening opening = openingOf(static_cast<int>(state.range(0)));
  const RigidPath path = rigidPath(opening.sheet.state, opening.request);
  double part = 0;
  for (auto _ : state) {
    part = part > 0.98 ? 0.0137 : part + 0.0173;
    benchmark::DoNotOptimize(path.at(part));
  }
}
BENCHMARK(aMomentOfItsOpening)->Arg(4)->Arg(14)->Arg(32)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace kiri
