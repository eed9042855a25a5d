// How many frames a second films are made with, frame by frame and through ffmpeg to the file.
// SPDX-License-Identifier: MIT
#include <benchmark/benchmark.h>

#include <cstdio>
#include <fstream>
#include <iterator>
#include <string>

#include "io/kiri_reader.h"
#include "render/film/encoder.h"
#include "render/film/film.h"

namespace kiri {
namespace {

Model example(const std::string& name) {
  const std::string path = "examples/" + name + ".kiri";  // run from the root of the repository
  std::ifstream file(path, std::ios::binary);
  const std::string text(std::istreambuf_iterator<char>(file), {});
  Result<LoadedModel> loaded = readKiri(text, path);
  return loaded.isOk() ? loaded->model : Model{};
}

FilmOptions optionsOf(bool hasAll) {
  FilmOptions options;
  options.view.azimuth = 20;
  options.view.elevation = 50;
  options.view.isShaded = true;
  options.view.hasShadow = hasAll;
  options.view.fieldOfView = hasAll ? 40 : 0;
  // A camera that moves, so that no frame repeats.
  options.camera = {{0, 20, 50}, {1, 60, 50}};
  return options;
}

/// Frames of 640 x 480 as pixels: the state, what is seen of it, the drawing.
void frames(benchmark::State& state, const std::string& name, bool hasAll) {
  const Result<Timeline> timeline = Timeline::of(example(name));
  if (!timeline.isOk()) return state.SkipWithError(timeline.error().message.c_str());
  const Model model = example(name);
  const Result<Film> film = Film::of(*timeline, appearanceOf(model), optionsOf(hasAll));
  if (!film.isOk()) return state.SkipWithError(film.error().message.c_str());
  std::size_t index = 0;
  std::int64_t count = 0;
  for (auto _ : state) {
    benchmark::DoNotOptimize(film->frameAt(index));
    index = (index + 7) % film->frameCount();
    ++count;
  }
  state.counters["frames/s"] =
      benchmark::Counter(static_cast<double>(count), benchmark::Counter::kIsRate);
}
BENCHMARK_CAPTURE(frames, ship, "ship", false)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(frames, leaf, "leaf_palmate", false)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(frames, leaf_shadow_perspective, "leaf_palmate", true)
    ->Unit(benchmark::kMillisecond);

/// A whole film, wall clock, with the encoder at work beside.
void film(benchmark::State& state, FilmFormat format) {
  const Result<Timeline> timeline = Timeline::of(example("ship"));
  if (!timeline.isOk()) return state.SkipWithError(timeline.error().message.c_str());
  const Model model = example("ship");
  std::int64_t count = 0;
  for (auto _ : state) {
    const Result<Film> shots = Film::of(*timeline, appearanceOf(model), optionsOf(false));
    Result<Encoder> encoder = Encoder::start("/tmp/kiri_film_bench", {format, 640, 480, 25});
    if (!shots.isOk() || !encoder.isOk()) return state.SkipWithError("ffmpeg is missing");
    const Status shot = shoot(*shots, [&](const Image& frame, std::size_t times) {
      count += static_cast<std::int64_t>(times);
      return encoder->add(frame, times);
    });
    if (!shot.isOk() || !encoder->finish().isOk()) return state.SkipWithError("ffmpeg failed");
  }
  std::remove("/tmp/kiri_film_bench");
  state.counters["frames/s"] =
      benchmark::Counter(static_cast<double>(count), benchmark::Counter::kIsRate);
}
BENCHMARK_CAPTURE(film, mp4, FilmFormat::Mp4)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK_CAPTURE(film, gif, FilmFormat::Gif)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK_CAPTURE(film, webp, FilmFormat::WebP)->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace
}  // namespace kiri
