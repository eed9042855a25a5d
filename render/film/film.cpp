// The frames of a film: a model in motion, seen by a camera that may move too.
// SPDX-License-Identifier: MIT
#include "render/film/film.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/geometry/bounds.h"
#include "render/canvas/rasterise.h"
#include "render/scene/model_scene.h"
#include "render/scene/shadow.h"

namespace kiri {

namespace {

Status checkOptions(const FilmOptions& options) {
  constexpr int kMost = 16384;
  constexpr int kLeast = 16;
  constexpr double kFastest = 240;
  const auto fits = [](int pixels) { return pixels >= kLeast && pixels <= kMost; };
  if (!fits(options.width) || !fits(options.height)) {
    return Error{ErrorCode::BadValue, "a film has 16 to 16384 pixels on a side", {}};
  }
  if (!(options.framesPerSecond >= 1 && options.framesPerSecond <= kFastest)) {
    return Error{ErrorCode::BadValue, "a film has 1 to 240 frames a second", {}};
  }
  if (!(options.margin >= 0 && options.margin < 0.5)) {
    return Error{ErrorCode::BadValue, "the margin of a film lies between 0 and half a side", {}};
  }
  for (const CameraKey& key : options.camera) {
    ViewSpec spec = options.view;
    spec.elevation = key.elevation;
    spec.azimuth = std::remainder(key.azimuth, 360.0);
    Status status = checkViewSpec(spec);
    if (!status) return status;
  }
  return checkViewSpec(options.view);
}

/// see(point) for points whose hull holds what is seen, model frame.
template <class See>
void forPoints(const FoldedState& bare, const ViewSpec& view, const See& see) {
  const std::optional<FoldedState> spread = spreadFor(bare, view);
  const FoldedState& state = spread ? *spread : bare;
  if (view.hasShadow) {
    for (const Vec3 point : shadowPoints(state)) see(point);
  }
  for (std::size_t f = 0; f < state.pattern.facets.size(); ++f) {
    for (const EdgeUse use : state.pattern.facets[f].border) {
      const Arc arc = arcOf(state.pattern, use);
      see(state.poses[f].apply(arc.start));
      if (!arc.isCurved) continue;
      see(state.poses[f].apply(arc.control1));
      see(state.poses[f].apply(arc.control2));
    }
  }
}

}  // namespace

Film::Film(const Timeline& timeline, const Appearance& appearance, const FilmOptions& options)
    : timeline_(&timeline), appearance_(appearance), options_(options) {
  const double frames = timeline.duration() * options.framesPerSecond;
  count_ = static_cast<std::size_t>(std::max(1.0, std::round(frames)));
}

Result<Film> Film::of(const Timeline& timeline, const Appearance& appearance,
                      const FilmOptions& options, const Progress& progress) {
  const Status checked = checkOptions(options);
  if (!checked) return checked.error();
  Film film(timeline, appearance, options);
  const Status found = film.findPage(progress);
  if (!found) return found.error();
  return film;
}

double Film::secondsOf(std::size_t index) const {
  if (index + 1 == count_) return timeline_->duration();
  return static_cast<double>(index) / options_.framesPerSecond;
}

ViewSpec Film::viewAt(double seconds) const {
  ViewSpec view = options_.view;
  if (options_.camera.empty()) return view;
  const std::vector<CameraKey>& keys = options_.camera;
  const double share = timeline_->duration() > 0 ? seconds / timeline_->duration() : 0;
  const auto next = std::upper_bound(keys.begin(), keys.end(), share,
                                     [](double s, const CameraKey& key) { return s < key.share; });
  CameraKey key = next == keys.end() ? keys.back() : *next;
  if (next != keys.begin() && next != keys.end()) {
    const CameraKey& before = *(next - 1);
    const double t = (share - before.share) / (next->share - before.share);
    key.azimuth = before.azimuth + (next->azimuth - before.azimuth) * t;
    key.elevation = before.elevation + (next->elevation - before.elevation) * t;
  }
  view.azimuth = std::remainder(key.azimuth, 360.0);
  view.elevation = key.elevation;
  return view;
}

Status Film::findPage(const Progress& progress) {
  // The ball first, for it says where the eye is; then what the eye sees of every moment.
  std::vector<std::size_t> moments;
  for (std::size_t i = 0; i < count_; i += repeatsAt(i)) moments.push_back(i);
  bool isFirst = true;
  for (std::size_t k = 0; k < moments.size(); ++k) {
    if (!goesOn(progress, static_cast<double>(k) / static_cast<double>(2 * moments.size()))) {
      return Error{ErrorCode::Cancelled, "stopped", {}};
    }
    const FoldedState state = timeline_->stateAt(secondsOf(moments[k]));
    const Sphere sphere = sphereOf(state, options_.view);
    sphere_ = isFirst ? sphere : joined(sphere_, sphere);
    isFirst = false;
  }
  page_ = {{0, 0}, {0, 0}};
  for (std::size_t k = 0; k < moments.size(); ++k) {
    const double done = static_cast<double>(moments.size() + k);
    if (!goesOn(progress, done / static_cast<double>(2 * moments.size()))) {
      return Error{ErrorCode::Cancelled, "stopped", {}};
    }
    const double seconds = secondsOf(moments[k]);
    const Result<ViewFrame> view = frameOf(viewAt(seconds), sphere_);
    if (!view) return view.error();
    const Vec2 middle = view->project(sphere_.centre);
    forPoints(timeline_->stateAt(seconds), options_.view,
              [&](Vec3 point) { page_ = joined(page_, view->project(point) - middle); });
  }
  return std::monostate{};
}

bool Film::isSame(std::size_t a, std::size_t b) const {
  const Moment first = timeline_->momentAt(secondsOf(a));
  const Moment second = timeline_->momentAt(secondsOf(b));
  if (first.step != second.step || first.isResting != second.isResting) return false;
  if (!first.isResting && (first.movement != second.movement || first.part != second.part)) {
    return false;
  }
  const ViewSpec from = viewAt(secondsOf(a));
  const ViewSpec to = viewAt(secondsOf(b));
  return from.azimuth == to.azimuth && from.elevation == to.elevation;
}

std::size_t Film::repeatsAt(std::size_t index) const {
  std::size_t next = index + 1;
  while (next < count_ && isSame(index, next)) ++next;
  return next - index;
}

Result<Scene> Film::sceneOf(std::size_t index) const {
  // Lines have widths in mm on paper: a page of the size at which screens show so many pixels.
  constexpr double kPixel = 25.4 / 96;
  const Vec2 room{options_.width * kPixel, options_.height * kPixel};
  const double margin = options_.margin * std::min(room.x, room.y);
  const Vec2 size = page_.high - page_.low;
  const double largest = std::max(size.x / (room.x - 2 * margin), size.y / (room.y - 2 * margin));
  const double scale = largest > 0 ? 1 / largest : 1;

  const double seconds = secondsOf(index);
  const ViewSpec spec = viewAt(seconds);
  const Result<ViewFrame> view = frameOf(spec, sphere_);
  if (!view) return view.error();
  const Vec2 middle = view->project(sphere_.centre) + (page_.low + page_.high) / 2;
  const Vec2 half = room / (2 * scale);
  ModelSceneOptions options;
  options.margin = 0;
  options.scale = scale;
  options.box = Box{middle - half, middle + half};
  options.sphere = sphere_;
  Result<Scene> scene = modelScene(timeline_->stateAt(seconds), appearance_, spec, options);
  if (scene.isOk()) scene->background = options_.background;
  return scene;
}

Result<Image> Film::frameAt(std::size_t index) const {
  const Result<Scene> scene = sceneOf(index);
  if (!scene) return scene.error();
  return rasterise(*scene, options_.width, options_.height);
}

Status shoot(const Film& film, const std::function<Status(const Image&, std::size_t)>& take,
             const Progress& progress) {
  for (std::size_t i = 0; i < film.frameCount();) {
    if (!goesOn(progress, static_cast<double>(i) / static_cast<double>(film.frameCount()))) {
      return Error{ErrorCode::Cancelled, "stopped", {}};
    }
    const Result<Image> frame = film.frameAt(i);
    if (!frame) return frame.error();
    const std::size_t times = film.repeatsAt(i);
    Status taken = take(*frame, times);
    if (!taken) return taken;
    i += times;
  }
  return std::monostate{};
}

}  // namespace kiri
