// Fold angles that go together: the way of a crease pattern whose facets stay rigid.
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "core/base/progress.h"
#include "core/paper/folded_state.h"

namespace kiri {

/// One fold angle for each edge of a pattern, degrees, valley positive; 0 where there is no hinge.
using FoldAngles = std::vector<double>;

FoldAngles anglesOf(const CreasePattern& pattern);

/// By how far the loops of the paper fail to close when every hinge has the given angle: the
/// largest distance, mm, between the two images of a hinge's end. 0 but for rounding: the angles go
/// together.
double closureError(const CreasePattern& pattern, const std::vector<Rest>& rests,
                    const FoldAngles& angles);

/// What a rigid motion is asked for.
struct PathRequest {
  FoldAngles wanted;           ///< angles at the end
  std::vector<EdgeId> driven;  ///< hinges that must go from their angles to the wanted ones, all in
                               ///< the same proportion
  std::vector<EdgeId> free;    ///< hinges that may take any angle on the way and at the end, to
                               ///< keep loops closed; `wanted` is where they head for. All others
                               ///< keep their angles
};

/// A motion in which no facet stretches: angles as a function of the part that is done.
class RigidPath {
 public:
  struct Sample {
    double part = 0;
    FoldAngles angles;
  };
  RigidPath(const CreasePattern& pattern, PathRequest request, std::vector<Sample> samples);

  /// How far the paper goes: 1, or the part at which it stops.
  double reach() const { return samples_.back().part; }
  bool isComplete() const { return reach() == 1; }
  /// Angles at `part`, 0 to reach(), closed within tolerance.length().
  FoldAngles at(double part) const;

 private:
  std::vector<Sample> samples_;
};

/// The motion from the state's angles on. Where creases form no closed loop, or every loop closes
/// by itself, all hinges go straight. Else the angles are followed along the solutions of the
/// closure equations (rigid folding by projection, Tachi; guide to algorithms 7.1), from a flat
/// state in the direction of the signs of `wanted`. None when there is no way at all from here.
/// `progress`: false stops; the path then ends there.
std::optional<RigidPath> rigidPath(const FoldedState& state, const PathRequest& request,
                                   const Progress& progress = {});

}  // namespace kiri
