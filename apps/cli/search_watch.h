// Long work in parts under a limit of time.
// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <string>

#include "apps/cli/console.h"

namespace kiri::cli {

/// Knows how long a command has worked, shows its parts one after the other and stops them when the
/// time is over or the user wants it.
class SearchWatch {
 public:
  /// `limit`: seconds from now; 0: none.
  SearchWatch(Console& console, double limit);

  /// Does `work(progress)` under a name: "searching 12 %".
  template <class Work>
  auto part(const std::string& name, Work work) {
    part_ = name;
    ProgressLine line(console_, name);
    line.update(0);
    return work(Progress([&](double done) { return !isOver() && line.update(done); }));
  }

  /// Seconds since the beginning.
  double seconds() const;
  /// True when the limit of time stopped a part.
  bool ranOut() const { return ranOut_; }
  /// The part that was begun last.
  const std::string& lastPart() const { return part_; }

 private:
  bool isOver();

  Console& console_;
  double limit_;
  std::chrono::steady_clock::time_point start_;
  std::string part_;
  bool ranOut_ = false;
};

}  // namespace kiri::cli
