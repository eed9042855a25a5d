// What the command line says with its exit code (docs/cli.md).
// SPDX-License-Identifier: MIT
#pragma once

namespace kiri::cli {

enum ExitCode : int {
  kDone = 0,
  kBadModel = 1,     ///< the model cannot be read, or a step that is needed does not apply
  kBadUsage = 2,     ///< the command line asks for something that there is not
  kCannotWrite = 3,  ///< the result could not be written
  kCancelled = 4,    ///< stopped by Ctrl-C
  kVerdictNo = 5,    ///< with --exit-code: the pattern does not fold flat
  kLimitMet = 6,     ///< a limit of time or memory ended the search
  kDefect = 70,      ///< a defect of the program
};

}  // namespace kiri::cli
