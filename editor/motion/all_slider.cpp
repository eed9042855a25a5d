// SPDX-License-Identifier: MIT
#include "editor/motion/all_slider.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/fold/fold_line.h"
#include "core/fold/group_motion.h"

namespace kiri {

namespace {

/// The most that a hinge has to turn.
double turnTo(const FoldedState& from, const FoldedState& to) {
  double most = 0;
  for (std::size_t e = 0; e < from.pattern.edges.size(); ++e)
    most = std::max(most, std::abs(from.pattern.edges[e].angle - to.pattern.edges[e].angle));
  return most;
}

bool isStopped(const Result<FoldedState>& end) {
  return !end && end.error().code == ErrorCode::Cancelled;
}

}  // namespace

struct AllSlider::Ways {
  /// From the state of the drag to one of the ends.
  struct Way {
    Way(const FoldedState& state, Result<FoldedState> reached, Movements made)
        : movements(std::move(made)) {
      if (!reached) {
        why = reached.error();
        return;
      }
      degrees = movements.empty() ? turnTo(state, *reached) : degreesOf(movements);
      end = std::make_shared<const FoldedState>(std::move(*reached));
    }

    std::shared_ptr<const FoldedState> at(const FoldedState& from, double part) const {
      if (part >= 1 && end != nullptr) return end;
      if (movements.empty() || part <= 0) return std::make_shared<const FoldedState>(from);
      return std::make_shared<const FoldedState>(stateAlong(movements, part));
    }

    std::shared_ptr<const FoldedState> end;  ///< none: it cannot be reached
    std::optional<Error> why;
    Movements movements;
    double degrees = 0;  ///< 0: the state is at this end
  };

  FoldedState start;
  Sequence sequence;
  Way opening;
  Way closing;
  double openness = 0;
};

Result<AllSlider> AllSlider::prepare(const FoldedState& state, Sequence sequence,
                                     const Progress& progress) {
  std::vector<FoldLineId> lines;
  for (std::size_t i = 0; i < state.lines.size(); ++i) {
    if (!hingesOf(state, FoldLineId(i)).empty()) lines.push_back(FoldLineId(i));
  }
  if (lines.empty())
    return Error{ErrorCode::NothingToDo, "there is no fold to open; fold the paper first", {}};
  const GroupMotion motion =
      sequence == Sequence::Together ? GroupMotion::Together : GroupMotion::InFreeOrder;
  Movements opening;
  Movements closing;
  const auto half = [&progress](double from) {
    return [&progress, from](double done) { return goesOn(progress, from + done / 2); };
  };
  Result<FoldedState> open = unfoldLines(state, lines, motion, &opening, half(0));
  if (isStopped(open)) return open.error();
  Result<FoldedState> closed = refoldLines(state, lines, motion, &closing, half(0.5));
  if (isStopped(closed) || (!open && !closed))
    return isStopped(closed) ? closed.error() : open.error();
  Ways ways{state,
            sequence,
            {state, std::move(open), std::move(opening)},
            {state, std::move(closed), std::move(closing)},
            0};
  const double all = ways.opening.degrees + ways.closing.degrees;
  if (all > 0) ways.openness = ways.closing.degrees / all;
  return AllSlider(std::make_shared<const Ways>(std::move(ways)));
}

double AllSlider::openness() const { return ways_->openness; }
const std::optional<Error>& AllSlider::whyNotOpen() const { return ways_->opening.why; }
const std::optional<Error>& AllSlider::whyNotFolded() const { return ways_->closing.why; }

std::shared_ptr<const FoldedState> AllSlider::at(double openness) const {
  const double here = ways_->openness;
  if (openness > here) return ways_->opening.at(ways_->start, (openness - here) / (1 - here));
  if (openness < here) return ways_->closing.at(ways_->start, (here - openness) / here);
  return std::make_shared<const FoldedState>(ways_->start);
}

std::optional<Step> AllSlider::stepAt(double openness) const {
  if (openness >= 1 && ways_->opening.end && ways_->opening.degrees > 0)
    return Step{UnfoldStep{{}, ways_->sequence}, {}, {}, {}};
  if (openness <= 0 && ways_->closing.end && ways_->closing.degrees > 0)
    return Step{RefoldStep{{}, ways_->sequence}, {}, {}, {}};
  return std::nullopt;
}

}  // namespace kiri
