// Long work in parts under a limit of time.
// SPDX-License-Identifier: MIT
#include "apps/cli/search_watch.h"

namespace kiri::cli {

SearchWatch::SearchWatch(Console& console, double limit)
    : console_(console), limit_(limit), start_(std::chrono::steady_clock::now()) {}

double SearchWatch::seconds() const {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
}

bool SearchWatch::isOver() {
  ranOut_ = ranOut_ || (limit_ > 0 && seconds() >= limit_);
  return ranOut_;
}

}  // namespace kiri::cli
