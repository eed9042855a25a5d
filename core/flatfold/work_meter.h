// Counts the work of a search, asks now and then whether it is still wanted.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

#include "core/base/progress.h"
#include "core/base/result.h"

namespace kiri {

/// Once stopped it stays stopped: all loops that share a meter come to an end.
class WorkMeter {
 public:
  WorkMeter(const Progress& progress, std::size_t memory) : progress_(progress), memory_(memory) {}

  /// Some steps of about a nanosecond were done. False: stop.
  bool spend(std::size_t steps) {
    sinceAsked_ += steps;
    return sinceAsked_ < kStepsBetween ? !isStopped() : ask();
  }
  /// Asks at once.
  bool ask() {
    sinceAsked_ = 0;
    isCancelled_ = isCancelled_ || !goesOn(progress_, done_);
    return !isStopped();
  }
  /// The part of the whole that is done, for whoever watches.
  void setDone(double done) { done_ = done; }

  std::size_t memory() const { return memory_; }
  /// Stops the work because it wants more memory than it may have.
  void meetMemoryLimit() { isFull_ = true; }
  bool isStopped() const { return isCancelled_ || isFull_; }
  /// Why it stopped, with what was done till then.
  Error error(const std::string& doneTillThen) const;

 private:
  static constexpr std::size_t kStepsBetween = std::size_t{1} << 22;

  const Progress& progress_;
  std::size_t memory_;
  std::size_t sinceAsked_ = 0;
  double done_ = 0;
  bool isCancelled_ = false;
  bool isFull_ = false;
};

}  // namespace kiri
