// What kiri animate and animated exports are told about time and camera.
// SPDX-License-Identifier: MIT
#include "apps/cli/film_options.h"

#include <locale>
#include <sstream>

namespace kiri::cli {

namespace {

/// Reads "number separator number separator ... number", all of it.
bool readNumbers(const std::string& text, const std::string& separators,
                 const std::vector<double*>& numbers) {
  std::istringstream in(text);
  in.imbue(std::locale::classic());
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    char c = 0;
    if (i > 0 && (!in.get(c) || c != separators[i - 1])) return false;
    if (!(in >> *numbers[i])) return false;
  }
  return in.peek() == std::char_traits<char>::eof();
}

Error badSteps(const std::string& text, std::size_t count) {
  return {ErrorCode::BadValue,
          "--steps " + text + " is not understood; the model has " + std::to_string(count) +
              " steps, write some of them like 2-5 or 3, or end for the finished model"};
}

}  // namespace

void addTimeOptions(CLI::App& command, TimeOptions& options) {
  command.add_option("--speed", options.speed, "degrees a second of what turns (default 120)")
      ->type_name("N");
  command
      .add_option("--ease", options.ease,
                  "smooth: slow at the start and end of each motion (default); none: even speed")
      ->type_name("EASE");
  command.add_option("--hold", options.hold, "seconds of rest after each step (default 0.4)")
      ->type_name("S");
  command
      .add_option("--steps", options.steps,
                  "A-B: only these steps; end: the finished model, which rests (default: all)")
      ->type_name("A-B");
}

Status checkTimeOptions(const TimeOptions& options) {
  constexpr double kFastest = 36000;
  constexpr double kLongest = 3600;
  if (options.speed && !(*options.speed > 0 && *options.speed <= kFastest)) {
    return Error{ErrorCode::BadValue, "--speed must be above 0 and at most 36000 degrees a second"};
  }
  if (options.hold && !(*options.hold >= 0 && *options.hold <= kLongest)) {
    return Error{ErrorCode::BadValue, "--hold must lie between 0 and 3600 seconds"};
  }
  if (options.ease != "smooth" && options.ease != "none") {
    return Error{ErrorCode::BadValue,
                 "--ease " + options.ease + " is not known; it takes smooth or none"};
  }
  return std::monostate{};
}

Result<TimelineOptions> timelineOptionsOf(const TimeOptions& options, std::size_t stepCount) {
  TimelineOptions time;
  if (options.speed) time.degreesPerSecond = *options.speed;
  if (options.hold) time.hold = *options.hold;
  if (options.ease == "none") time.easing = Easing::None;
  time.lastStep = stepCount;
  if (options.steps.empty()) return time;
  if (options.steps == "end") {
    constexpr double kLook = 6;
    time.firstStep = stepCount;
    time.startHold = options.hold.value_or(kLook);
    return time;
  }
  double first = 0;
  double last = 0;
  if (readNumbers(options.steps, "", {&first})) {
    last = first;
  } else if (!readNumbers(options.steps, "-", {&first, &last})) {
    return badSteps(options.steps, stepCount);
  }
  const auto isStep = [&](double n) {
    return n >= 1 && n <= static_cast<double>(stepCount) &&
           n == static_cast<double>(static_cast<std::size_t>(n));
  };
  if (!isStep(first) || !isStep(last) || first > last) return badSteps(options.steps, stepCount);
  time.firstStep = static_cast<std::size_t>(first) - 1;
  time.lastStep = static_cast<std::size_t>(last);
  return time;
}

Result<Timeline> timelineOf(Console& console, const ModelInput& input,
                            const TimelineOptions& options) {
  ProgressLine line(console, "folding");
  Result<Timeline> timeline = Timeline::of(input.model, options, line.progress());
  if (timeline.isOk()) {
    warnOfCollisions(console, input, timeline->stateAfter(options.lastStep));
    return timeline;
  }
  Error error = timeline.error();
  if (error.code != ErrorCode::Cancelled) error.message = input.name + ": " + error.message;
  return error;
}

Result<PixelSize> pixelSizeOf(const std::string& text) {
  constexpr double kLeast = 16;
  constexpr double kMost = 16384;
  double width = 0;
  double height = 0;
  const auto fits = [](double n) { return n >= kLeast && n <= kMost && n == static_cast<int>(n); };
  if (!readNumbers(text, "x", {&width, &height}) || !fits(width) || !fits(height)) {
    return Error{ErrorCode::BadValue, "--size " + text +
                                          " is no size of a film; write one like 640x480, with 16 "
                                          "to 16384 pixels on a side"};
  }
  return PixelSize{static_cast<int>(width), static_cast<int>(height)};
}

Result<std::vector<CameraKey>> cameraOf(const std::string& text) {
  std::vector<CameraKey> keys;
  std::istringstream words(text);
  std::string word;
  while (words >> word) {
    CameraKey key;
    const bool isRead = readNumbers(word, ",@", {&key.azimuth, &key.elevation, &key.share});
    const bool isInOrder =
        key.share >= 0 && key.share <= 1 && (keys.empty() || key.share > keys.back().share);
    constexpr double kTurns = 36000;
    if (!isRead || !isInOrder || !(key.azimuth >= -kTurns && key.azimuth <= kTurns)) {
      return Error{ErrorCode::BadValue,
                   "--camera: " + word +
                       " is not understood; stations look like AZ,EL@SHARE, their shares of the "
                       "time grow from 0 to 1, as in \"0,90@0 60,35@1\""};
    }
    keys.push_back(key);
  }
  return keys;
}

}  // namespace kiri::cli
