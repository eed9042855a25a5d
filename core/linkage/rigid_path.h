// Fold angles that go together: the way of a crease pattern whose facets stay rigid.
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <vector>

#include "core/base/progress.h"
#include "core/linkage/loops.h"
#include "core/paper/folded_state.h"

namespace kiri {

class Closure;

FoldAngles anglesOf(const CreasePattern& pattern);

/// By how far the loops of the paper fail to close when every hinge has the given angle: the
/// largest distance, mm, between a facet's corner and where a hinge, folded from the neighbour,
/// would put it. 0 but for rounding: the angles go together.
double closureError(const CreasePattern& pattern, const std::vector<Rest>& rests,
                    const FoldAngles& angles);

/// What a rigid motion is asked for.
struct PathRequest {
  FoldAngles wanted;           ///< angles at the end
  std::vector<EdgeId> driven;  ///< hinges that must go from their angles to the wanted ones, all in
                               ///< the same proportion
  std::vector<EdgeId> free;    ///< hinges that may take any angle on the way and at the end, to
                               ///< keep loops closed; `wanted` is where they head for. All others
                               ///< keep their angles. A hinge that starts flat or fully folded
                               ///< leaves towards its wanted angle or stays, never the other way
};

/// Why a path ends where it does.
enum class PathEnd {
  Complete,   ///< the driven hinges have their wanted angles
  HingeFull,  ///< a hinge would turn past 180 degrees
  Locked,     ///< no angles of the free hinges close all loops any further on
  Cancelled
};

/// A motion in which no facet stretches: angles as a function of the part that is done.
class RigidPath {
 public:
  struct Sample {
    double part = 0;
    FoldAngles angles;
  };
  struct Stop {
    PathEnd end = PathEnd::Complete;
    std::vector<EdgeId> hinges;  ///< HingeFull: which; Locked: those of a loop that would not close
  };
  /// `samples`: at least one, from part 0 on, rising; every one closed. `closure` closes what lies
  /// between them; none: all hinges go straight.
  RigidPath(PathRequest request, std::vector<Sample> samples, Stop stop,
            std::shared_ptr<const Closure> closure);

  /// How far the paper goes: 1, or the part at which it stops (to about a millionth); 0 when there
  /// is no way at all from the start.
  double reach() const { return samples_.back().part; }
  bool isComplete() const { return reach() == 1; }
  /// True when it is complete and the free hinges too have come to their wanted angles.
  bool arrives() const;
  const Stop& stop() const { return stop_; }
  /// True when all hinges go straight from start to end.
  bool isStraight() const { return closure_ == nullptr; }
  /// Angles at `part`, 0 to reach(), closed within tolerance.length(). Continuous in `part`.
  FoldAngles at(double part) const;
  /// The moments that were solved for, from part 0 to reach(): between neighbours no hinge turns
  /// more than some 6 degrees, unless the path is straight.
  const std::vector<Sample>& samples() const { return samples_; }

 private:
  PathRequest request_;
  std::vector<Sample> samples_;
  Stop stop_;
  std::shared_ptr<const Closure> closure_;
};

/// The motion from the state's angles on. Where creases form no closed loop, or every loop closes
/// by itself, all hinges go straight. Else the angles are followed along the solutions of the
/// closure equations (rigid folding by projection, Tachi; guide to algorithms 7.1), from a flat
/// state into the branch in which every hinge leaves towards its wanted angle. Where more than one
/// motion is free, the one nearest to heading straight for what is wanted is taken. At the end all
/// hinges have their wanted angles, or all are flat, exactly, if the motion leads there; the driven
/// ones are as wanted always.
/// Rigid foldability is NP-hard: that no path is found is no proof that there is none.
/// Collisions are not looked for. `progress`: false stops; the path then ends there.
RigidPath rigidPath(const FoldedState& state, const PathRequest& request,
                    const Progress& progress = {});

}  // namespace kiri
