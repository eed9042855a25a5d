// The whole process as a film, made beside the window.
// SPDX-License-Identifier: MIT
#pragma once

#include <QString>

#include "apps/desktop/services/exporter.h"
#include "core/model/timeline.h"
#include "render/film/encoder.h"

namespace kiri::desktop {

struct FilmRequest {
  QString path;
  FilmFormat format = FilmFormat::Mp4;
  int width = 1280;
  int height = 720;
  double framesPerSecond = 25;
  ExportView view = ExportView::Angled;  ///< Screen counts as Angled: a film needs room to move in
  bool isTurntable = false;              ///< the camera goes once round the model
  bool showsCreases = true;
  LineStyle lineStyle = LineStyle::Thesis;
  Color background{255, 255, 255};
  TimelineOptions time;
};

QString endingOf(FilmFormat format);

/// True when ffmpeg, which makes films, can be started here.
bool hasFilmProgram();

/// Shoots and writes the film; nothing is left behind when it fails. Errors: NotFound - there is no
/// ffmpeg; those of Timeline::of, Film::of and Encoder; Cancelled.
Status makeFilm(const ExportSource& source, const FilmRequest& request,
                const Progress& progress = {});

}  // namespace kiri::desktop
