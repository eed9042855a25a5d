// The whole process in time: play, pause, scrub (thesis A13, A14).
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <memory>
#include <optional>

#include "core/model/timeline.h"

namespace kiri {

/// Where the film of the model is. The window gives it the time that has gone by; it knows no
/// clock.
class Player {
 public:
  /// None: nothing to play.
  void load(std::shared_ptr<const Timeline> timeline);
  bool isLoaded() const { return timeline_ != nullptr; }
  double duration() const;
  double seconds() const { return seconds_; }

  void play();  ///< from the start when it stands at the end
  void pause() { isPlaying_ = false; }
  bool isPlaying() const { return isPlaying_; }
  void seek(double seconds);
  void setSpeed(double factor) { speed_ = factor; }
  double speed() const { return speed_; }
  void setLoops(bool loops) { loops_ = loops; }
  bool loops() const { return loops_; }
  /// To the start of the next or previous step.
  void skip(int steps);
  /// Time goes by; true when the picture changes.
  bool advance(double realSeconds);

  /// What is to be seen now.
  FoldedState state() const;
  std::size_t step() const;  ///< steps that are done

 private:
  std::shared_ptr<const Timeline> timeline_;
  double seconds_ = 0;
  double speed_ = 1;
  bool isPlaying_ = false;
  bool loops_ = false;
};

}  // namespace kiri
