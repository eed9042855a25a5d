// Where the frames of a film go: through ffmpeg into one file, or into numbered pictures.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "apps/cli/console.h"
#include "render/film/film.h"

namespace kiri::cli {

struct FilmOutput {
  std::string path;    ///< for pictures with one number like %04d
  std::string format;  ///< gif, mp4, webp or png
  int width = 640;
  int height = 480;
  double framesPerSecond = 25;
  bool isSmall = false;  ///< for pages (EncoderOptions)
};

/// Mistakes that can be told before any work is done.
Status checkFilmOutput(const FilmOutput& output);

/// Shoots the film into a file of its format, which is no png. Errors: NotFound - there is no
/// ffmpeg; Unwritable; Cancelled. Nothing is left behind then.
Status shootInto(const Film& film, const FilmOutput& output, const Progress& progress);

/// Shoots the film and writes it, with progress. Nothing is left behind when it fails or is
/// stopped.
int writeFilm(Console& console, const Film& film, const FilmOutput& output);

}  // namespace kiri::cli
