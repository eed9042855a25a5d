// The frames of a film: a model in motion, seen by a camera that may move too.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/model/timeline.h"
#include "render/scene/appearance.h"
#include "render/scene/image.h"
#include "render/scene/scene.h"
#include "render/scene/view_spec.h"

namespace kiri {

/// Where the camera is when a share of the time has passed.
struct CameraKey {
  double share = 0;  ///< of the film's time, 0 to 1
  double azimuth = 0;
  double elevation = 90;
};

struct FilmOptions {
  int width = 640;
  int height = 480;
  double framesPerSecond = 25;
  ViewSpec view;  ///< what the camera does not change
  /// In order of their shares; between two of them the camera goes evenly, before the first and
  /// after the last it rests. Empty: it rests at `view`. Azimuths may go on beyond a full turn.
  std::vector<CameraKey> camera;
  Color background{255, 255, 255};
  double margin = 0.04;  ///< of the shorter side of the picture, around everything that is shown
};

/// A film of the whole time line. Every frame shows the same page, in which everything that is seen
/// at any moment has room, so that nothing but the paper and the camera moves.
class Film {
 public:
  /// Looks at all moments to find the page. `timeline` must outlive the film. Errors: BadValue - a
  /// size, rate, margin or view out of range; Cancelled.
  static Result<Film> of(const Timeline& timeline, const Appearance& appearance,
                         const FilmOptions& options, const Progress& progress = {});

  /// At least 1: frame i shows the moment i / framesPerSecond, the last one the end.
  std::size_t frameCount() const { return count_; }
  /// Frames from `index` on that look like frame `index`: holds, in which the camera rests too.
  std::size_t repeatsAt(std::size_t index) const;
  /// The picture of a frame before it becomes pixels.
  Result<Scene> sceneOf(std::size_t index) const;
  Result<Image> frameAt(std::size_t index) const;

 private:
  Film(const Timeline& timeline, const Appearance& appearance, const FilmOptions& options);
  double secondsOf(std::size_t index) const;
  ViewSpec viewAt(double seconds) const;
  bool isSame(std::size_t a, std::size_t b) const;
  Status findPage(const Progress& progress);

  const Timeline* timeline_;
  Appearance appearance_;
  FilmOptions options_;
  std::size_t count_ = 1;
  Sphere sphere_;  ///< what the camera looks at
  Box page_;       ///< around the middle of the sphere, view coordinates
};

/// Makes every frame once and hands it on, with how often it is shown. Errors: those of the frames
/// and of `take`; Cancelled.
Status shoot(const Film& film, const std::function<Status(const Image&, std::size_t)>& take,
             const Progress& progress = {});

}  // namespace kiri
