// Time from a state to a frame of the window. Figures and targets: docs/benchmarks.md.
// SPDX-License-Identifier: MIT
#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "core/geometry/rigid.h"
#include "render/gl/renderer.h"
#include "render/mesh/moved_mesh.h"
#include "render/mesh/paper_mesh.h"
#include "render/scene/view_spec.h"
#include "tests/render/gl/headless_gl.h"
#include "tests/render/gl/states.h"

namespace kiri {
namespace {

const FoldedState& folded(std::size_t n) {
  static const FoldedState small = test::miura(32);
  static const FoldedState middle = test::miura(45);
  static const FoldedState large = test::miura(256);
  return n == 32 ? small : n == 45 ? middle : large;
}

void meshOfState(benchmark::State& run) {
  const FoldedState& state = folded(static_cast<std::size_t>(run.range(0)));
  for (auto _ : run) benchmark::DoNotOptimize(meshOf(state));
  run.counters["facets"] = static_cast<double>(state.pattern.facets.size());
}

/// What a slider costs while its fold lines stay in planes of their own: here, while all of it
/// turns.
void movedMeshOfState(benchmark::State& run) {
  const FoldedState& state = folded(static_cast<std::size_t>(run.range(0)));
  const PaperMesh base = meshOf(state);
  FoldedState turned = state;
  const Rigid turn = rotationAbout({}, {1, 0, 0}, 20);
  for (Rigid& pose : turned.poses) pose = compose(turn, pose);
  std::vector<LayerSet> sets = turned.layers.sets();
  for (LayerSet& set : sets) set.normal = turn.direction(set.normal);
  turned.layers = LayerOrder(std::move(sets));
  if (!movedMesh(base, state, turned)) return run.SkipWithError("not only poses differ");
  for (auto _ : run) benchmark::DoNotOptimize(movedMesh(base, state, turned));
  run.counters["facets"] = static_cast<double>(state.pattern.facets.size());
}

void sheetMesh(benchmark::State& run) {
  const FoldedState& state = folded(static_cast<std::size_t>(run.range(0)));
  for (auto _ : run) benchmark::DoNotOptimize(sheetMeshOf(state));
  run.counters["facets"] = static_cast<double>(state.pattern.facets.size());
}

/// A context, a framebuffer of a window's size with four samples, and a mesh in it.
struct Window {
  static constexpr int kWidth = 1280;
  static constexpr int kHeight = 800;

  Window() {
    std::string why;
    gl = test::HeadlessGl::create(test::GlKind::Desktop33, why);
    if (!gl) return;
    renderer = *GlRenderer::create();
    gl->begin(kWidth, kHeight);
    mesh = meshOf(folded(45));
    renderer->setMesh(mesh);
  }
  ~Window() { renderer.reset(); }
  Window(const Window&) = delete;
  Window& operator=(const Window&) = delete;

  GlView view(double azimuth) const {
    const Sphere sphere = sphereOf(folded(45));
    GlView view;
    view.frame = *frameOf({azimuth, 50, 30}, sphere);
    const Box box = boxOf(view.frame, sphere);
    view.centre = (box.low + box.high) / 2;
    view.width = kWidth;
    view.height = kHeight;
    view.pixelsPerMm = kHeight / (box.high.y - box.low.y);
    view.nearDepth = 2 * sphere.radius;
    view.farDepth = -2 * sphere.radius;
    return view;
  }

  std::unique_ptr<test::HeadlessGl> gl;
  std::unique_ptr<GlRenderer> renderer;
  PaperMesh mesh;
};

void setMesh(benchmark::State& run) {
  Window window;
  if (!window.gl) return run.SkipWithError("no EGL without a screen");
  for (auto _ : run) window.renderer->setMesh(window.mesh);
}

/// Wall clock, with reading the picture back: without it the frames are never finished.
void frame(benchmark::State& run, bool hasLines, bool isNew) {
  Window window;
  if (!window.gl) return run.SkipWithError("no EGL without a screen");
  double azimuth = 0;
  for (auto _ : run) {
    GlView view = window.view(azimuth += 7);
    view.showsEdges = view.showsBorders = view.showsCreases = hasLines;
    if (isNew) window.renderer->setMesh(window.mesh);
    window.renderer->draw(view);
    benchmark::DoNotOptimize(window.gl->finish());
  }
  run.counters["facets"] = static_cast<double>(window.mesh.facetCount);
}

BENCHMARK(meshOfState)->Arg(32)->Arg(256)->Unit(benchmark::kMillisecond);
BENCHMARK(movedMeshOfState)->Arg(32)->Arg(256)->Unit(benchmark::kMillisecond);
BENCHMARK(sheetMesh)->Arg(32)->Arg(256)->Unit(benchmark::kMillisecond);
BENCHMARK(setMesh)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(frame, paper, false, false)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK_CAPTURE(frame, lines, true, false)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK_CAPTURE(frame, newMesh, true, true)->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace
}  // namespace kiri
