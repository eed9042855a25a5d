// Where the frames of a film go: through ffmpeg into one file, or into numbered pictures.
// SPDX-License-Identifier: MIT
#include "apps/cli/film_output.h"

#include <cstddef>
#include <string>

#include "apps/cli/numbered_files.h"
#include "render/canvas/png.h"
#include "render/film/encoder.h"

namespace kiri::cli {

namespace {

Status addFrame(NumberedFiles& pictures, const Image& frame, std::size_t times) {
  const Result<std::string> png = encodePng(frame, 0);
  if (!png.isOk()) return png.error();
  for (std::size_t i = 0; i < times; ++i) {
    Status status = pictures.add(*png);
    if (!status.isOk()) return status;
  }
  return std::monostate{};
}

FilmFormat formatOf(const std::string& name) {
  if (name == "gif") return FilmFormat::Gif;
  return name == "webp" ? FilmFormat::WebP : FilmFormat::Mp4;
}

int failFilm(Console& console, const Error& error) {
  const bool isMissing = error.code == ErrorCode::NotFound;
  return fail(console, error, isMissing ? kCannotWrite : kBadUsage);
}

int writePictures(Console& console, const Film& film, const FilmOutput& output) {
  NumberedFiles pictures(*numberedPath(output.path));
  ProgressLine line(console, "filming");
  const Status shot = shoot(
      film, [&](const Image& frame, std::size_t times) { return addFrame(pictures, frame, times); },
      line.progress());
  if (!shot.isOk()) return failFilm(console, shot.error());
  pictures.keep();
  return kDone;
}

}  // namespace

Status checkFilmOutput(const FilmOutput& output) {
  if (output.path == "-") {
    return Error{ErrorCode::BadValue, "films are not written to standard output; name a file"};
  }
  if (output.format == "png" && !numberedPath(output.path)) {
    return Error{ErrorCode::BadValue,
                 output.path +
                     " has no place for the numbers of the pictures; write one like "
                     "film_%04d.png"};
  }
  if (output.format == "mp4" && (output.width % 2 != 0 || output.height % 2 != 0)) {
    return Error{ErrorCode::BadValue, "MP4 films have even sides; --size " +
                                          std::to_string(output.width) + "x" +
                                          std::to_string(output.height) + " has not"};
  }
  return std::monostate{};
}

Status shootInto(const Film& film, const FilmOutput& output, const Progress& progress) {
  Result<Encoder> encoder =
      Encoder::start(output.path, {formatOf(output.format), output.width, output.height,
                                   output.framesPerSecond, output.isSmall});
  if (!encoder.isOk()) return encoder.error();
  double done = 0;
  const Progress again = [&](double) { return goesOn(progress, done); };
  Status shot = shoot(
      film,
      [&](const Image& frame, std::size_t times) { return encoder->add(frame, times, again); },
      [&](double part) { return goesOn(progress, done = part); });
  if (!shot.isOk()) return shot;
  return encoder->finish(progress);
}

int writeFilm(Console& console, const Film& film, const FilmOutput& output) {
  if (output.format == "png") return writePictures(console, film, output);
  ProgressLine line(console, "filming");
  const Status shot = shootInto(film, output, line.progress());
  return shot.isOk() ? kDone : failFilm(console, shot.error());
}

}  // namespace kiri::cli
