// The whole process in time: play, pause, scrub (thesis A13, A14).
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <memory>
#include <optional>

#include "core/model/timeline.h"

namespace kiri {

/// Where the film of the model is. The window gives it the time that has gone by; it knows no
/// clock. Speed and loops outlast the film.
class Player {
 public:
  static constexpr double kSlowest = 0.1;
  static constexpr double kFastest = 10;

  /// Stands at the start, paused. None: nothing to play; nothing below does anything then.
  void load(std::shared_ptr<const Timeline> timeline);
  bool isLoaded() const { return timeline_ != nullptr; }
  double duration() const;
  double seconds() const { return seconds_; }

  void play();  ///< from the start when it stands at the end
  void pause() { isPlaying_ = false; }
  bool isPlaying() const { return isPlaying_; }
  void seek(double seconds);  ///< outside the time: its start or end
  /// Times real time; kept within kSlowest and kFastest.
  void setSpeed(double factor);
  double speed() const { return speed_; }
  void setLoops(bool loops) { loops_ = loops; }
  bool loops() const { return loops_; }
  /// To the moment when so many steps more (or fewer) are done than now. Back from within a step
  /// goes to its start first. Past the ends: start and end.
  void skip(int steps);
  /// The moment when `done` steps are done.
  void seekStep(std::size_t done);
  /// Time goes by while it plays; true when the picture changes. At the end it starts again where
  /// it loops, else it stops there.
  bool advance(double realSeconds);

  /// What is to be seen now. Requires that something is loaded.
  FoldedState state() const;
  std::size_t step() const;  ///< steps that are done; 0: nothing loaded
  /// The step that is under way, from 1, or the last one done where the paper rests; 0: none yet.
  std::size_t stepSeen() const;

 private:
  std::shared_ptr<const Timeline> timeline_;
  double seconds_ = 0;
  double speed_ = 1;
  bool isPlaying_ = false;
  bool loops_ = false;
};

}  // namespace kiri
