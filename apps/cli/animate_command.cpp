// kiri animate: a film of the paper in motion.
// SPDX-License-Identifier: MIT
#include <memory>
#include <optional>
#include <string>

#include "apps/cli/commands.h"
#include "apps/cli/film_options.h"
#include "apps/cli/film_output.h"
#include "apps/cli/model_input.h"
#include "apps/cli/output_format.h"
#include "apps/cli/picture_options.h"
#include "apps/cli/view_options.h"
#include "io/sheet_json.h"

namespace kiri::cli {

namespace {

struct AnimateOptions {
  std::string model;
  std::string size = "640x480";
  double framesPerSecond = 25;
  std::string camera;
  bool isTurntable = false;
  TimeOptions time;
  ViewOptions view;
  PictureOptions picture;
};

/// The camera's way, for the view that the film starts with.
Result<std::vector<CameraKey>> cameraFor(const AnimateOptions& options, const ViewSpec& view) {
  if (!options.isTurntable) return cameraOf(options.camera);
  if (!options.camera.empty()) {
    return Error{ErrorCode::BadValue, "--camera and --turntable both say where the camera goes"};
  }
  constexpr double kFullTurn = 360;
  return std::vector<CameraKey>{{0, view.azimuth, view.elevation},
                                {1, view.azimuth + kFullTurn, view.elevation}};
}

Result<FilmOptions> filmOptionsOf(const AnimateOptions& options) {
  FilmOptions film;
  const Result<PixelSize> size = pixelSizeOf(options.size);
  if (!size.isOk()) return size.error();
  film.width = size->width;
  film.height = size->height;
  constexpr double kFastest = 240;
  if (!(options.framesPerSecond >= 1 && options.framesPerSecond <= kFastest)) {
    return Error{ErrorCode::BadValue, "--fps must lie between 1 and 240"};
  }
  film.framesPerSecond = options.framesPerSecond;
  const Result<ViewSpec> view = viewSpecOf(options.view);
  if (!view.isOk()) return view.error();
  film.view = *view;
  Result<std::vector<CameraKey>> camera = cameraFor(options, *view);
  if (!camera.isOk()) return camera.error();
  film.camera = std::move(*camera);
  if (!options.picture.background.empty()) {
    const std::optional<Color> color = colorFromText(options.picture.background);
    if (!color) {
      return Error{ErrorCode::BadValue, "--background " + options.picture.background +
                                            " is no colour; write one like \"#ffffff\""};
    }
    film.background = *color;
  }
  return film;
}

Result<FilmOutput> outputOf(const AnimateOptions& options, const FilmOptions& film) {
  const Result<std::string> format =
      chooseFormat(options.picture.out, options.picture.format, {"gif", "mp4", "webp", "png"});
  if (!format.isOk()) return format.error();
  FilmOutput output{options.picture.out, *format, film.width, film.height, film.framesPerSecond};
  const Status status = checkFilmOutput(output);
  if (!status.isOk()) return status.error();
  return output;
}

int shootAndWrite(Console& console, const ModelInput& input, const Timeline& timeline,
                  const AnimateOptions& options, const FilmOptions& filmOptions,
                  const FilmOutput& output) {
  constexpr double kMostFrames = 100000;
  if (timeline.duration() * filmOptions.framesPerSecond > kMostFrames) {
    return fail(console, kBadUsage,
                "the film would have more than 100000 frames; choose a higher --speed, a lower "
                "--fps or fewer --steps");
  }
  const Result<Appearance> appearance = appearanceFor(console, input, options.picture);
  if (!appearance.isOk()) return fail(console, appearance.error());
  const auto lookAhead = [&] {
    ProgressLine line(console, "looking for the frame");
    return Film::of(timeline, *appearance, filmOptions, line.progress());
  };
  const Result<Film> film = lookAhead();
  if (!film.isOk()) return fail(console, film.error(), kBadUsage);
  return writeFilm(console, *film, output);
}

int run(Console& console, const AnimateOptions& options) {
  const Status time = checkTimeOptions(options.time);
  if (!time.isOk()) return fail(console, time.error(), kBadUsage);
  const Result<FilmOptions> film = filmOptionsOf(options);
  if (!film.isOk()) return fail(console, film.error(), kBadUsage);
  const Result<FilmOutput> output = outputOf(options, *film);
  if (!output.isOk()) return fail(console, output.error(), kBadUsage);
  const Result<ModelInput> input = loadModel(console, options.model);
  if (!input.isOk()) return fail(console, input.error());
  const Result<TimelineOptions> line = timelineOptionsOf(options.time, input->model.steps.size());
  if (!line.isOk()) return fail(console, line.error(), kBadUsage);
  const Result<Timeline> timeline = timelineOf(console, *input, *line);
  if (!timeline.isOk()) return fail(console, timeline.error());
  return shootAndWrite(console, *input, *timeline, options, *film, *output);
}

void addFilmOptions(CLI::App& command, AnimateOptions& options) {
  command.add_option("MODEL", options.model, "a .kiri file, - for standard input")->required();
  command
      .add_option("-o,--output", options.picture.out,
                  "film to write, or pictures with a number: film_%04d.png")
      ->type_name("OUT")
      ->required();
  command
      .add_option("--format", options.picture.format,
                  "gif, mp4, webp or png (default: by the ending of OUT)")
      ->type_name("FORMAT");
  command.add_option("--size", options.size, "pixels (default 640x480)")->type_name("WxH");
  command.add_option("--fps", options.framesPerSecond, "frames a second (default 25)")
      ->type_name("N");
  addTimeOptions(command, options.time);
  addViewOptions(command, options.view);
  command.add_flag_callback(
      "--no-shade", [&options] { options.view.isShaded = false; },
      "facets keep their plain colours; films are shaded unless told so");
  command
      .add_option("--camera", options.camera,
                  "stations of a moving camera: \"AZ,EL@SHARE ...\", SHARE of the time from 0 to 1")
      ->type_name("PATH");
  command.add_flag("--turntable", options.isTurntable, "the camera goes once round the model");
  command
      .add_option("--style", options.picture.style,
                  "thesis: mountain blue, valley red; diagram: black dashes")
      ->type_name("STYLE");
  command.add_flag("--no-creases", options.picture.hidesCreases, "leave out creases that lie flat");
  command.add_option("--background", options.picture.background, "colour (default \"#ffffff\")")
      ->type_name("COLOUR");
}

}  // namespace

void addAnimateCommand(CLI::App& app, Console& console, int& code) {
  CLI::App* command = app.add_subcommand("animate", "Make a film of the paper in motion");
  const auto options = std::make_shared<AnimateOptions>();
  options->view.view = "20,50";
  options->view.isShaded = true;
  addFilmOptions(*command, *options);
  command->footer(
      "Films are made by the program ffmpeg; numbered pictures need nothing.\n"
      "Examples:\n"
      "  kiri animate leaf.kiri -o leaf.mp4\n"
      "  kiri animate leaf.kiri --steps 3-5 --view front --size 320x240 -o leaf.gif\n"
      "  kiri animate ship.kiri --steps end --turntable -o ship.webp\n"
      "  kiri animate ship.kiri --camera \"0,90@0 60,35@1\" --fps 10 -o frame_%04d.png");
  command->callback([&console, &code, options] { code = run(console, *options); });
}

}  // namespace kiri::cli
