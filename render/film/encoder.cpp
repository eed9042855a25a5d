// Films as files: frames go through the program ffmpeg, which is found when it is wanted.
// SPDX-License-Identifier: MIT
#include "render/film/encoder.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <optional>
#include <system_error>
#include <utility>
#include <vector>

#include "core/base/check.h"
#include "core/base/text.h"

namespace kiri {

namespace {

using Words = std::vector<std::string>;

Words joined(Words first, const Words& second) {
  first.insert(first.end(), second.begin(), second.end());
  return first;
}

/// The same frames give the same bytes.
Words ffmpeg(const Words& more) {
  return joined({"ffmpeg", "-nostdin", "-hide_banner", "-loglevel", "error", "-y"}, more);
}

Words rawInput(const EncoderOptions& options) {
  return {"-f",       "rawvideo",
          "-pix_fmt", "rgba",
          "-s",       std::to_string(options.width) + "x" + std::to_string(options.height),
          "-r",       text(options.framesPerSecond),
          "-i",       "pipe:0"};
}

const Words kExact = {"-an", "-fflags", "+bitexact", "-flags:v", "+bitexact"};

/// How the frames are encoded as they come. GIF needs all of them to choose its colours, so they
/// are kept without loss first.
Words encoding(const EncoderOptions& options) {
  switch (options.format) {
    case FilmFormat::Gif:
      return {"-c:v", "ffv1", "-level", "3", "-pix_fmt", "bgr0"};
    case FilmFormat::Mp4:
      return {"-vf",
              "scale=out_color_matrix=bt709:out_range=tv",
              "-c:v",
              "libx264",
              "-threads",
              options.isSmall ? "1" : "0",
              "-crf",
              options.isSmall ? "26" : "18",
              "-pix_fmt",
              "yuv420p",
              "-colorspace",
              "bt709",
              "-color_trc",
              "bt709",
              "-movflags",
              "+faststart",
              "-color_range",
              "tv",
              "-color_primaries",
              "bt709"};
    case FilmFormat::WebP:
      // Harder work at it (up to 6) takes twice as long and gives files of the same size.
      return {"-c:v", "libwebp_anim", "-lossless", "1", "-compression_level", "1", "-loop", "0"};
  }
  return {};
}

const char* nameOf(FilmFormat format) {
  switch (format) {
    case FilmFormat::Gif:
      return "film.gif";
    case FilmFormat::Mp4:
      return "film.mp4";
    case FilmFormat::WebP:
      return "film.webp";
  }
  return "";
}

Status checkOptions(const EncoderOptions& options) {
  constexpr int kMost = 16384;
  constexpr double kFastest = 240;
  const auto fits = [](int pixels) { return pixels >= 1 && pixels <= kMost; };
  if (!fits(options.width) || !fits(options.height)) {
    return Error{ErrorCode::BadValue, "a film has 1 to 16384 pixels on a side", {}};
  }
  if (options.format == FilmFormat::Mp4 && (options.width % 2 != 0 || options.height % 2 != 0)) {
    return Error{ErrorCode::BadValue,
                 "MP4 films have even sides, not " + std::to_string(options.width) + " x " +
                     std::to_string(options.height) + " pixels; add one pixel",
                 {}};
  }
  if (!(options.framesPerSecond >= 1 && options.framesPerSecond <= kFastest)) {
    return Error{ErrorCode::BadValue, "a film has 1 to 240 frames a second", {}};
  }
  return std::monostate{};
}

Error unwritable(const std::string& path, int code) {
  return {ErrorCode::Unwritable,
          "cannot write " + path + ": " + std::generic_category().message(code),
          {}};
}

/// Where a chain of links ends, so that writing replaces the file and not the link.
std::string targetOf(const std::string& path) {
  const std::unique_ptr<char, void (*)(void*)> real(::realpath(path.c_str(), nullptr), std::free);
  return real ? real.get() : path;
}

void sync(const std::string& path) {
  const int handle = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (handle < 0) return;
  ::fsync(handle);
  ::close(handle);
}

}  // namespace

/// The folder that a film is made in, and the program at work in it.
struct Encoder::Workshop {
  std::string path;
  std::string folder;
  EncoderOptions options;
  std::optional<Child> child;

  Workshop(std::string target, std::string place, const EncoderOptions& wanted)
      : path(std::move(target)), folder(std::move(place)), options(wanted) {}
  Workshop(const Workshop&) = delete;
  Workshop& operator=(const Workshop&) = delete;
  ~Workshop() {
    child.reset();
    for (const char* file : {nameOf(options.format), "frames.mkv", "colours.png"}) {
      ::unlink(in(file).c_str());
    }
    ::rmdir(folder.c_str());
  }

  std::string in(const std::string& file) const { return folder + "/" + file; }

  Status start(const Words& words) {
    Result<Child> started = Child::start(words);
    if (started.isOk()) {
      child = std::move(*started);
      return std::monostate{};
    }
    if (started.error().code != ErrorCode::NotFound) return started.error();
    return Error{ErrorCode::NotFound,
                 "films are made by the program ffmpeg, which is not installed (Debian: apt-get "
                 "install ffmpeg); or write numbered pictures, like -o film_%04d.png",
                 {}};
  }

  Status run(const Words& words, const Progress& progress) {
    const Status started = start(words);
    return started.isOk() ? child->finish(progress) : started;
  }

  Status startEncoding() {
    const bool isTwice = options.format == FilmFormat::Gif;
    const std::string out = isTwice ? "frames.mkv" : nameOf(options.format);
    return start(
        ffmpeg(joined(joined(rawInput(options), encoding(options)), joined(kExact, {in(out)}))));
  }

  /// Chooses the colours, then uses them. No dithering: paper has plain colours.
  Status makeGif(const Progress& progress) {
    const std::string frames = in("frames.mkv");
    const std::string colours = in("colours.png");
    Status chosen =
        run(ffmpeg({"-i", frames, "-vf", "palettegen=reserve_transparent=0", colours}), progress);
    if (!chosen.isOk()) return chosen;
    return run(ffmpeg(joined({"-i", frames, "-i", colours, "-lavfi",
                              "paletteuse=dither=none:diff_mode=rectangle", "-loop", "0"},
                             joined(kExact, {in(nameOf(FilmFormat::Gif))}))),
               progress);
  }

  Status deliver() {
    const std::string film = in(nameOf(options.format));
    sync(film);
    if (std::rename(film.c_str(), path.c_str()) != 0) return unwritable(path, errno);
    return std::monostate{};
  }
};

Encoder::Encoder(std::unique_ptr<Workshop> workshop) : workshop_(std::move(workshop)) {}
Encoder::Encoder(Encoder&&) noexcept = default;
Encoder& Encoder::operator=(Encoder&&) noexcept = default;
Encoder::~Encoder() = default;

Result<Encoder> Encoder::start(const std::string& path, const EncoderOptions& options) {
  const Status checked = checkOptions(options);
  if (!checked.isOk()) return checked.error();
  const std::string target = targetOf(path);
  struct stat old = {};
  if (::stat(target.c_str(), &old) == 0 && !S_ISREG(old.st_mode)) {
    return Error{ErrorCode::Unwritable,
                 "cannot write " + path + ": it is no ordinary file; name another one",
                 {}};
  }
  std::string folder = target + ".XXXXXX";
  if (::mkdtemp(folder.data()) == nullptr) return unwritable(path, errno);
  auto workshop = std::make_unique<Workshop>(target, folder, options);
  const Status started = workshop->startEncoding();
  if (!started.isOk()) return started.error();
  return Encoder(std::move(workshop));
}

Status Encoder::add(const Image& frame, std::size_t times, const Progress& progress) {
  const EncoderOptions& options = workshop_->options;
  KIRI_CHECK(frame.width == options.width && frame.height == options.height,
             "frames have the size of the film");
  for (std::size_t i = 0; i < times; ++i) {
    Status sent = workshop_->child->send(frame.rgba.data(), frame.rgba.size(), progress);
    if (!sent.isOk()) return sent;
  }
  return std::monostate{};
}

Status Encoder::finish(const Progress& progress) {
  Status ended = workshop_->child->finish(progress);
  if (!ended.isOk()) return ended;
  if (workshop_->options.format == FilmFormat::Gif) {
    Status made = workshop_->makeGif(progress);
    if (!made.isOk()) return made;
  }
  return workshop_->deliver();
}

}  // namespace kiri
