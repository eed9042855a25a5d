// Where the frames of a film go: through ffmpeg into one file, or into numbered pictures.
// SPDX-License-Identifier: MIT
#include "apps/cli/film_output.h"

#include <cctype>
#include <cstdio>
#include <optional>
#include <utility>
#include <vector>

#include "io/file.h"
#include "render/canvas/png.h"
#include "render/film/encoder.h"

namespace kiri::cli {

namespace {

/// A path with a place for a number, as in f_%04d.png.
struct NumberedPath {
  std::string before;
  std::size_t digits = 0;
  std::string after;

  std::string at(std::size_t number) const {
    std::string text = std::to_string(number);
    if (text.size() < digits) text.insert(0, digits - text.size(), '0');
    return before + text + after;
  }
};

std::optional<NumberedPath> numberedPath(const std::string& path) {
  const std::size_t start = path.find('%');
  if (start == std::string::npos || path.find('%', start + 1) != std::string::npos) return {};
  std::size_t at = start + 1;
  while (at < path.size() && std::isdigit(static_cast<unsigned char>(path[at])) != 0) ++at;
  constexpr std::size_t kMostDigits = 2;  // of the count of digits
  if (at == path.size() || path[at] != 'd' || at - start - 1 > kMostDigits) return {};
  const std::string digits = path.substr(start + 1, at - start - 1);
  return NumberedPath{path.substr(0, start), digits.empty() ? 1 : std::stoul(digits),
                      path.substr(at + 1)};
}

/// Numbered pictures; those that were written go again unless `keep` is called.
class Pictures {
 public:
  explicit Pictures(NumberedPath path) : path_(std::move(path)) {}
  Pictures(const Pictures&) = delete;
  Pictures& operator=(const Pictures&) = delete;
  ~Pictures() {
    for (const std::string& name : written_) std::remove(name.c_str());
  }

  Status add(const Image& frame, std::size_t times) {
    const Result<std::string> png = encodePng(frame, 0);
    if (!png.isOk()) return png.error();
    for (std::size_t i = 0; i < times; ++i) {
      const std::string name = path_.at(++count_);
      Status status = writeFile(name, *png);
      if (!status.isOk()) return status;
      written_.push_back(name);
    }
    return std::monostate{};
  }
  void keep() { written_.clear(); }

 private:
  NumberedPath path_;
  std::size_t count_ = 0;
  std::vector<std::string> written_;
};

FilmFormat formatOf(const std::string& name) {
  if (name == "gif") return FilmFormat::Gif;
  return name == "webp" ? FilmFormat::WebP : FilmFormat::Mp4;
}

int failFilm(Console& console, const Error& error) {
  const bool isMissing = error.code == ErrorCode::NotFound;
  return fail(console, error, isMissing ? kCannotWrite : kBadUsage);
}

int writePictures(Console& console, const Film& film, const FilmOutput& output) {
  Pictures pictures(*numberedPath(output.path));
  ProgressLine line(console, "filming");
  const Status shot = shoot(
      film, [&](const Image& frame, std::size_t times) { return pictures.add(frame, times); },
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

int writeFilm(Console& console, const Film& film, const FilmOutput& output) {
  if (output.format == "png") return writePictures(console, film, output);
  Result<Encoder> encoder = Encoder::start(
      output.path, {formatOf(output.format), output.width, output.height, output.framesPerSecond});
  if (!encoder.isOk()) return failFilm(console, encoder.error());
  ProgressLine line(console, "filming");
  const Progress stop = [&](double) { return !isCancelled(console); };
  const Status shot = shoot(
      film, [&](const Image& frame, std::size_t times) { return encoder->add(frame, times, stop); },
      line.progress());
  if (!shot.isOk()) return failFilm(console, shot.error());
  const Status finished = encoder->finish(line.progress());
  if (!finished.isOk()) return failFilm(console, finished.error());
  return kDone;
}

}  // namespace kiri::cli
