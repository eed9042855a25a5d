// Films as files: frames go through the program ffmpeg, which is found when it is wanted.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <memory>
#include <string>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "render/film/child.h"
#include "render/scene/image.h"

namespace kiri {

enum class FilmFormat {
  Gif,   ///< 256 colours chosen for the whole film, runs for ever
  Mp4,   ///< H.264, as browsers and phones play it; sides must be even
  WebP,  ///< animated, without loss (smaller than with, for paper), runs for ever
};

struct EncoderOptions {
  FilmFormat format = FilmFormat::Mp4;
  int width = 640;
  int height = 480;
  double framesPerSecond = 25;
  /// MP4 for a page that has many of them: half as large, a little softer, and made by one
  /// processor, so that the bytes do not hang on how many there are.
  bool isSmall = false;
};

/// Writes one film. Everything is made in a folder beside `path`, which goes when this object goes;
/// the film is moved to `path` when it is whole.
class Encoder {
 public:
  /// Errors: NotFound - there is no ffmpeg, with what to do; Unwritable - the place cannot be
  /// written to; BadValue - a size or rate that the format cannot have.
  static Result<Encoder> start(const std::string& path, const EncoderOptions& options);

  Encoder(Encoder&&) noexcept;
  Encoder& operator=(Encoder&&) noexcept;
  Encoder(const Encoder&) = delete;
  Encoder& operator=(const Encoder&) = delete;
  ~Encoder();

  /// Appends a frame of the film's size, `times` times. Errors: Unwritable - ffmpeg failed, with
  /// what it said; Cancelled - `progress`, asked while ffmpeg is busy, said so.
  Status add(const Image& frame, std::size_t times = 1, const Progress& progress = {});
  /// Completes the film and puts it in its place. Errors: as add; Cancelled.
  Status finish(const Progress& progress = {});

 private:
  struct Workshop;
  explicit Encoder(std::unique_ptr<Workshop> workshop);
  std::unique_ptr<Workshop> workshop_;
};

}  // namespace kiri
