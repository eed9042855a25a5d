// Random paper and random eyes.
// SPDX-License-Identifier: MIT
#include "tests/support/views.h"

#include "core/model/apply.h"
#include "core/paper/boxes.h"
#include "tests/support/model_text.h"

namespace kiri::test {
namespace {

Camera cameraAt(Camera::Preset preset, const FoldedState& state, Vec2 size) {
  Camera camera;
  camera.resize(size);
  camera.look(preset, sphereOf(state));
  return camera;
}

}  // namespace

FoldedState randomState(std::uint64_t seed) {
  Random random(seed);
  const Model model = randomSheet(random);
  FoldedState state = startOf(model);
  RandomStepOptions options;
  options.facetLimit = 60;
  const std::size_t count = 3 + random.below(10);
  for (std::size_t i = 0; i < count; ++i) {
    Result<FoldedState> next =
        apply(state, randomStep(random, state, options), static_cast<int>(i + 1));
    if (next) state = std::move(next).value();
  }
  return state;
}

Camera randomCamera(Random& random, const FoldedState& state) {
  Camera camera = cameraAt(
      static_cast<Camera::Preset>(random.below(3)), state,
      {static_cast<double>(300 + random.below(900)), static_cast<double>(300 + random.below(900))});
  if (random.chance(0.5)) camera.setPerspective(random.between(5, 100));
  camera.turn(random.between(-180, 180), random.between(-90, 90), random.between(-180, 180));
  camera.pan({random.between(-60, 60), random.between(-60, 60)});
  camera.zoom({random.between(0, 400), random.between(0, 400)}, random.between(0.5, 2.5));
  return camera;
}

Camera frontCamera(const FoldedState& state, double width, double height) {
  return cameraAt(Camera::Preset::Front, state, {width, height});
}

Camera backCamera(const FoldedState& state, double width, double height) {
  return cameraAt(Camera::Preset::Back, state, {width, height});
}

SheetCamera sheetCamera(const FoldedState& state, bool showsBack) {
  SheetCamera camera;
  camera.resize({500, 600});
  camera.setShowsBack(showsBack);
  camera.fit(paperBoxOf(state.pattern));
  return camera;
}

Vec2 pixelsOf(const FoldedState& state, const PaneMap& map, Vec2 paper) {
  return map.toPixels(state, {facetAt(state.pattern, paper).value(), paper});
}

}  // namespace kiri::test
