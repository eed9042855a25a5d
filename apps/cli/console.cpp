// What the command line reads from and talks to, so that tests can stand in for a terminal.
// SPDX-License-Identifier: MIT
#include "apps/cli/console.h"

#include <algorithm>
#include <utility>

#include "io/file.h"

namespace kiri::cli {

int fail(Console& console, ExitCode code, const std::string& sentence) {
  console.err << "error: " << sentence << '\n';
  return code;
}

int fail(Console& console, const Error& error, ExitCode code) {
  if (error.code == ErrorCode::Cancelled)
    return fail(console, kCancelled, "stopped; nothing was written");
  return fail(console, error.code == ErrorCode::Unwritable ? kCannotWrite : code, error.message);
}

void warn(Console& console, const std::string& sentence) {
  console.err << "warning: " << sentence << '\n';
}

bool isCancelled(const Console& console) { return console.isCancelled && console.isCancelled(); }

ProgressLine::ProgressLine(Console& console, std::string what)
    : console_(console), what_(std::move(what)) {}

ProgressLine::~ProgressLine() {
  if (!shown_.empty()) console_.err << "\r\x1b[K" << std::flush;
}

Progress ProgressLine::progress() {
  return [this](double done) { return update(done); };
}

bool ProgressLine::update(double done) {
  constexpr double kPercent = 100;
  const int percent = static_cast<int>(kPercent * std::clamp(done, 0.0, 1.0));
  return tell(std::to_string(percent) + " %");
}

bool ProgressLine::tell(const std::string& words) {
  if (console_.showsProgress && words != shown_) {
    // What was there may have been longer.
    console_.err << '\r' << what_ << ' ' << words << "\x1b[K" << std::flush;
    shown_ = words;
  }
  return !isCancelled(console_);
}

int writeResult(Console& console, const std::string& path, const std::string& bytes) {
  if (isCancelled(console)) return fail(console, Error{ErrorCode::Cancelled, "", {}});
  if (path == "-") {
    console.out.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    console.out.flush();
    if (!console.out) return fail(console, kCannotWrite, "cannot write to standard output");
    return kDone;
  }
  const Status status = writeFile(path, bytes);
  return status.isOk() ? kDone : fail(console, status.error());
}

}  // namespace kiri::cli
