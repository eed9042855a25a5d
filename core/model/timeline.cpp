// SPDX-License-Identifier: MIT
#include "core/model/timeline.h"

#include <algorithm>
#include <cmath>

#include "core/base/text.h"
#include "core/model/apply.h"

namespace kiri {
namespace {

Status checkOptions(const TimelineOptions& options, std::size_t steps) {
  constexpr double kFastest = 36000;
  constexpr double kLongest = 3600;
  const auto isTime = [](double seconds) { return seconds >= 0 && seconds <= kLongest; };
  if (!(options.degreesPerSecond > 0 && options.degreesPerSecond <= kFastest)) {
    return Error{ErrorCode::BadValue,
                 "the speed " + text(options.degreesPerSecond) +
                     " is out of range; give degrees a second above 0, up to 36000",
                 {}};
  }
  for (const double seconds :
       {options.shiftSeconds, options.hold, options.startHold, options.endHold}) {
    if (isTime(seconds)) continue;
    return Error{ErrorCode::BadValue,
                 "the time " + text(seconds) + " s is out of range; give 0 to 3600 seconds",
                 {}};
  }
  if (options.firstStep > std::min(options.lastStep, steps)) {
    return Error{ErrorCode::BadValue,
                 "the time would start after step " + std::to_string(options.firstStep) +
                     ", which is past its end; the model has " + std::to_string(steps) + " steps",
                 {}};
  }
  return std::monostate{};
}

double eased(double part, Easing easing) {
  return easing == Easing::Smooth ? part * part * (3 - 2 * part) : part;
}

Error failed(std::size_t index, Error error) {
  error.message = "step " + std::to_string(index + 1) + ": " + error.message;
  return error;
}

}  // namespace

Result<Timeline> Timeline::of(const Model& model, const TimelineOptions& options,
                              const Progress& progress) {
  if (const Status checked = checkOptions(options, model.steps.size()); !checked)
    return checked.error();
  const Result<Sheet> sheet = makeSheet(model.sheet);
  if (!sheet) return sheet.error();
  Timeline line;
  line.options_ = options;
  const std::size_t last = std::min(options.lastStep, model.steps.size());
  line.states_.push_back(std::make_shared<const FoldedState>(flatState(*sheet)));
  for (std::size_t i = 0; i < last; ++i) {
    if (!goesOn(progress, static_cast<double>(i) / static_cast<double>(last)))
      return Error{ErrorCode::Cancelled, "stopped at step " + std::to_string(i + 1), {}};
    Movements movements;
    const bool isShown = i >= options.firstStep;
    Result<FoldedState> next = apply(*line.states_.back(), model.steps[i], static_cast<int>(i) + 1,
                                     isShown ? &movements : nullptr);
    if (!next) return failed(i, next.error());
    line.states_.push_back(std::make_shared<const FoldedState>(std::move(*next)));
    line.movements_.push_back(std::move(movements));
  }
  line.layOut();
  return line;
}

void Timeline::layOut() {
  double now = 0;
  const auto add = [&](double seconds, std::size_t step, std::size_t movement, bool isResting) {
    phases_.push_back({now, now + seconds, step, movement, isResting});
    now += seconds;
  };
  add(options_.startHold, options_.firstStep, 0, true);
  for (std::size_t step = options_.firstStep; step < movements_.size(); ++step) {
    for (std::size_t m = 0; m < movements_[step].size(); ++m) {
      const double degrees = degreesOf(movements_[step][m]);
      const double seconds =
          degrees > 0 ? degrees / options_.degreesPerSecond : options_.shiftSeconds;
      add(seconds, step, m, false);
    }
    const bool isLast = step + 1 == movements_.size();
    add(isLast ? options_.endHold : options_.hold, step + 1, 0, true);
  }
}

double Timeline::duration() const { return phases_.back().end; }

Moment Timeline::momentAt(double seconds) const {
  const auto later = std::upper_bound(phases_.begin(), phases_.end(), seconds,
                                      [](double s, const Phase& phase) { return s < phase.end; });
  const Phase& phase = later == phases_.end() ? phases_.back() : *later;
  Moment moment{phase.step, phase.movement, 0, phase.isResting};
  if (phase.isResting) return moment;
  const double part = (std::max(seconds, phase.start) - phase.start) / (phase.end - phase.start);
  moment.part = eased(std::min(part, 1.0), options_.easing);
  return moment;
}

FoldedState Timeline::stateAt(const Moment& moment) const {
  if (moment.isResting) return *states_[moment.step];
  return stateDuring(movements_[moment.step][moment.movement], moment.part);
}

Result<FoldedState> stateBetween(const Model& model, double steps, const Progress& progress) {
  const double count = static_cast<double>(model.steps.size());
  if (!(steps >= 0 && steps <= count)) {
    return Error{ErrorCode::BadValue,
                 "there is no moment " + text(steps) + "; the model has " + text(count) + " steps",
                 {}};
  }
  const auto done = static_cast<std::size_t>(std::floor(steps));
  const double part = steps - std::floor(steps);
  TimelineOptions options;
  options.firstStep = done;
  options.lastStep = part > 0 ? done + 1 : done;
  const Result<Timeline> line = Timeline::of(model, options, progress);
  if (!line) return line.error();
  if (!(part > 0)) return line->stateAfter(done);
  const Movements& movements = line->movementsOf(done);
  if (movements.empty()) return line->stateAfter(done + 1);  // done at once
  return stateAlong(movements, part);
}

}  // namespace kiri
