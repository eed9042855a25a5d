// What the command line reads from and talks to, so that tests can stand in for a terminal.
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <istream>
#include <ostream>
#include <string>

#include "apps/cli/exit_codes.h"
#include "core/base/progress.h"
#include "core/base/result.h"

namespace kiri::cli {

struct Console {
  std::istream& in;
  std::ostream& out;
  std::ostream& err;
  bool showsProgress = false;         ///< progress is written to `err`
  std::function<bool()> isCancelled;  ///< may be empty: never
  std::string programFolder = {};     ///< where the program's file is; empty: nobody knows
};

/// Writes "error: sentence" and returns the code.
int fail(Console& console, ExitCode code, const std::string& sentence);
/// Writes the sentence of an error; Cancelled and Unwritable have exit codes of their own, all else
/// is `code`.
int fail(Console& console, const Error& error, ExitCode code = kBadModel);
void warn(Console& console, const std::string& sentence);

bool isCancelled(const Console& console);

/// Progress of long work: a line on `err` when the console shows it, and the ear for Ctrl-C in any
/// case.
class ProgressLine {
 public:
  ProgressLine(Console& console, std::string what);
  ~ProgressLine();
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

  /// For work that reports: valid as long as this object lives.
  Progress progress();
  /// Says where the work is; false when it shall stop.
  bool update(double done);
  /// The same in words: "12 of 38".
  bool tell(const std::string& words);

 private:
  Console& console_;
  std::string what_;
  std::string shown_;
};

/// Puts the result where the user wants it: into a file, or to standard output for "-".
int writeResult(Console& console, const std::string& path, const std::string& bytes);

}  // namespace kiri::cli
