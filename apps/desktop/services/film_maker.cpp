// The whole process as a film.
// SPDX-License-Identifier: MIT
#include "apps/desktop/services/film_maker.h"

#include <QStandardPaths>

#include "apps/desktop/services/textures.h"
#include "render/film/film.h"

namespace kiri::desktop {

namespace {

/// The part of the whole progress from `from` to `to`.
Progress stretch(const Progress& progress, double from, double to) {
  return [progress, from, to](double done) { return goesOn(progress, from + (to - from) * done); };
}

FilmOptions optionsOf(const FilmRequest& request) {
  FilmOptions film;
  film.width = request.width;
  film.height = request.height;
  film.framesPerSecond = request.framesPerSecond;
  film.background = request.background;
  film.view = {20, 50};
  if (request.view == ExportView::Front) film.view = frontSpec();
  if (request.view == ExportView::Back) film.view = backSpec();
  film.view.isShaded = true;
  if (request.isTurntable) {
    constexpr double kFullTurn = 360;
    film.camera = {{0, film.view.azimuth, film.view.elevation},
                   {1, film.view.azimuth + kFullTurn, film.view.elevation}};
  }
  return film;
}

Status write(const Film& film, const FilmRequest& request, const Progress& progress) {
  Result<Encoder> encoder =
      Encoder::start(request.path.toStdString(),
                     {request.format, request.width, request.height, request.framesPerSecond});
  if (!encoder.isOk()) return encoder.error();
  const Progress shooting = stretch(progress, 0.25, 0.95);
  double reached = 0;
  const Status shot = shoot(
      film,
      [&](const Image& frame, std::size_t times) {
        return encoder->add(frame, times, [&](double) { return goesOn(shooting, reached); });
      },
      [&](double done) {
        reached = done;
        return goesOn(shooting, done);
      });
  if (!shot.isOk()) return shot.error();
  return encoder->finish([&](double) { return goesOn(progress, 0.97); });
}

}  // namespace

QString endingOf(FilmFormat format) {
  switch (format) {
    case FilmFormat::Gif:
      return "gif";
    case FilmFormat::Mp4:
      return "mp4";
    case FilmFormat::WebP:
      return "webp";
  }
  return {};
}

bool hasFilmProgram() { return !QStandardPaths::findExecutable("ffmpeg").isEmpty(); }

Status makeFilm(const ExportSource& source, const FilmRequest& request, const Progress& progress) {
  const Result<Timeline> timeline =
      Timeline::of(source.model, request.time, stretch(progress, 0, 0.15));
  if (!timeline.isOk()) return timeline.error();
  Appearance looks = appearanceWithTextures(source.model, source.path);
  looks.lineStyle = request.lineStyle;
  looks.showCreases = request.showsCreases;
  const Result<Film> film =
      Film::of(*timeline, looks, optionsOf(request), stretch(progress, 0.15, 0.25));
  if (!film.isOk()) return film.error();
  return write(*film, request, progress);
}

}  // namespace kiri::desktop
