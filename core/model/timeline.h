// A model's whole process in time: for films, for scrubbing, for moments between steps.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/fold/movement.h"
#include "core/model/model.h"
#include "core/model/replay.h"

namespace kiri {

enum class Easing {
  None,   ///< constant speed from the first to the last moment of a movement
  Smooth  ///< speeds up at the start and slows down at the end (smoothstep)
};

struct TimelineOptions {
  std::size_t firstStep = 0;        ///< steps before it are done when the time starts
  std::size_t lastStep = SIZE_MAX;  ///< steps from it on are left out; SIZE_MAX: none
  double degreesPerSecond = 120;    ///< of the fastest hinge
  double shiftSeconds = 0.5;        ///< that a movement without a turn takes
  double hold = 0.4;                ///< seconds of rest after each step
  double startHold = 0.6;           ///< seconds of rest before the first movement
  double endHold = 1.2;             ///< seconds of rest after the last
  Easing easing = Easing::Smooth;
};

/// Where in the process a moment is.
struct Moment {
  std::size_t step = 0;      ///< steps that are done before
  std::size_t movement = 0;  ///< which movement of the step under way
  double part = 0;           ///< of that movement, 0 to 1, eased
  bool isResting = true;     ///< between movements: the state is that after `step` steps
};

/// A stretch of time in which the crease pattern does not change and one movement, or rest, goes
/// on.
struct Phase {
  double start = 0;  ///< seconds
  double end = 0;
  std::size_t step = 0;
  std::size_t movement = 0;
  bool isResting = true;
};

class Timeline {
 public:
  /// Errors: that of the first step that does not apply; BadValue - a speed, hold or step out of
  /// range; Cancelled.
  static Result<Timeline> of(const Model& model, const TimelineOptions& options = {},
                             const Progress& progress = {});

  double duration() const;  ///< seconds
  const std::vector<Phase>& phases() const { return phases_; }
  /// `seconds` outside the time are its start or end.
  Moment momentAt(double seconds) const;
  FoldedState stateAt(double seconds) const { return stateAt(momentAt(seconds)); }
  FoldedState stateAt(const Moment& moment) const;
  /// The movements of step `index`, from 0; none for steps that move nothing.
  const Movements& movementsOf(std::size_t index) const { return movements_[index]; }
  /// The state after `count` steps.
  const FoldedState& stateAfter(std::size_t count) const { return *states_[count]; }

 private:
  void layOut();

  std::vector<std::shared_ptr<const FoldedState>> states_;  ///< before the first step, after each
  std::vector<Movements> movements_;
  std::vector<Phase> phases_;
  TimelineOptions options_;
};

/// The state at a moment between two steps: 2.5 is half way through the third step. Whole numbers
/// are the states after so many steps. The movements of a step share its time by the degrees they
/// turn. Errors: that of the first step that does not apply; BadValue - a number below 0 or above
/// the number of steps.
Result<FoldedState> stateBetween(const Model& model, double steps, const Progress& progress = {});

}  // namespace kiri
