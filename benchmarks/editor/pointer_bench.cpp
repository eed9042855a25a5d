// What every move of the pointer costs at 2,048 facets: picking and snapping. Figures:
// docs/benchmarks.md.
// SPDX-License-Identifier: MIT
#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <vector>

#include "core/model/apply.h"
#include "editor/snap/snap.h"
#include "editor/view/camera.h"
#include "editor/view/picking.h"
#include "tests/support/random_steps.h"

namespace kiri {
namespace {

/// A square halved eleven times: 2,048 layers on each other.
FoldedState stack() {
  FoldedState state = flatState(*squareSheet(100));
  for (int k = 0; k < 11; ++k) {
    const double width = 100 * std::ldexp(1.0, -((k + 1) / 2));
    const double height = 100 * std::ldexp(1.0, -(k / 2));
    FoldStep fold;
    if (k % 2 == 0) {
      fold.line = {Frame::Model, {100 - width / 2, -10}, {100 - width / 2, 110}, std::nullopt};
    } else {
      fold.line = {Frame::Model, {-10, height / 2}, {110, height / 2}, std::nullopt};
    }
    state = apply(state, {fold, {}, {}, {}}, k + 1).value();
  }
  return state;
}

/// The same, unfolded: all side by side.
FoldedState sheet() {
  return apply(stack(), {UnfoldStep{{}, Sequence::InOrder}, {}, {}, {}}, 12).value();
}

/// The same facets anywhere in a cube, each in a plane of its own, through each other.
FoldedState tangle() {
  FoldedState state = sheet();
  test::Random random(3);
  std::vector<LayerSet> sets;
  for (std::size_t f = 0; f < state.poses.size(); ++f) {
    const Vec2 middle = interiorPointOf(state.pattern, FacetId(f));
    const Vec3 to{random.between(0, 30), random.between(0, 30), random.between(0, 30)};
    const Rigid turn = compose(rotationAbout(to, {1, 0, 0}, random.between(0, 360)),
                               rotationAbout(to, {0, 0, 1}, random.between(0, 360)));
    state.poses[f] = compose(turn, translation(to - Vec3{middle.x, middle.y, 0}));
    sets.push_back({state.poses[f].normal(), {FacetId(f)}, {}});
  }
  state.layers = LayerOrder(std::move(sets));
  return state;
}

const FoldedState& stackOnce() {
  static const FoldedState state = stack();
  return state;
}
const FoldedState& sheetOnce() {
  static const FoldedState state = sheet();
  return state;
}
const FoldedState& tangleOnce() {
  static const FoldedState state = tangle();
  return state;
}

enum class Question { Paper, Stack, Vertex, Edge, Snap, SnapInFrame };

std::size_t ask(Question question, const FoldedState& state, const PaneMap& map, Vec2 pixels) {
  SnapSettings settings;
  settings.divisions = 4;
  settings.angleStep = 22.5;
  const FacetId frame(std::size_t{0});
  switch (question) {
    case Question::Paper:
      return pickPaper(state, map, pixels) ? 1 : 0;
    case Question::Stack:
      return pickStack(state, map, pixels).size();
    case Question::Vertex:
      return pickVertex(state, map, pixels, 10) ? 1 : 0;
    case Question::Edge:
      return pickEdge(state, map, pixels, 10) ? 1 : 0;
    case Question::Snap:
      return snapPoint(state, map, pixels, settings) ? 1 : 0;
    case Question::SnapInFrame:
      return snapPoint(state, map, pixels, settings, frame, interiorPointOf(state.pattern, frame))
                 ? 1
                 : 0;
  }
  return 0;
}

/// Asks at pixels near edges and corners, where there is most to be looked at; says what the
/// slowest took, of the CPU.
void pointer(benchmark::State& run, const FoldedState& state, Question question,
             double fieldOfView) {
  Camera camera;
  camera.resize({1000, 800});
  camera.look(fieldOfView > 0 ? Camera::Preset::Angled : Camera::Preset::Front, sphereOf(state));
  camera.setPerspective(fieldOfView);
  const PaneMap map = camera.map();
  test::Random random(5);
  double worst = 0;
  std::size_t found = 0;
  for (auto _ : run) {
    const FacetId facet(random.below(state.pattern.facets.size()));
    const auto& border = state.pattern[facet].border;
    const Arc arc = arcOf(state.pattern, border[random.below(border.size())]);
    const double t = random.chance(0.5) ? 0 : random.unit();
    const Vec2 pixels = map.toPixels(state, {facet, pointAt(arc, t)}) +
                        Vec2{random.between(-12, 12), random.between(-12, 12)};
    const std::clock_t begin = std::clock();
    found += ask(question, state, map, pixels);
    const auto took = static_cast<double>(std::clock() - begin);
    worst = std::max(worst, took * 1000 / CLOCKS_PER_SEC);
  }
  run.counters["facets"] = static_cast<double>(state.pattern.facets.size());
  run.counters["worst_ms"] = worst;
  if (found == 0 && run.iterations() > 100) run.SkipWithError("nothing was found anywhere");
}

BENCHMARK_CAPTURE(pointer, paperStack, stackOnce(), Question::Paper, 0)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(pointer, paperSheet, sheetOnce(), Question::Paper, 0)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(pointer, paperTangle, tangleOnce(), Question::Paper, 40)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(pointer, layersStack, stackOnce(), Question::Stack, 0)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(pointer, vertexStack, stackOnce(), Question::Vertex, 0)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(pointer, vertexSheet, sheetOnce(), Question::Vertex, 0)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(pointer, vertexTangle, tangleOnce(), Question::Vertex, 40)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(pointer, edgeStack, stackOnce(), Question::Edge, 0)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(pointer, edgeSheet, sheetOnce(), Question::Edge, 0)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(pointer, edgeTangle, tangleOnce(), Question::Edge, 40)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(pointer, snapStack, stackOnce(), Question::Snap, 0)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(pointer, snapSheet, sheetOnce(), Question::Snap, 0)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(pointer, snapTangle, tangleOnce(), Question::Snap, 40)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(pointer, snapInPlaneOfStack, stackOnce(), Question::SnapInFrame, 0)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(pointer, snapInPlaneOfSheet, sheetOnce(), Question::SnapInFrame, 0)
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace kiri
