// A state of the model: crease pattern, one fold angle a hinge, layer order (DESIGN section 2).
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/base/ids.h"
#include "core/geometry/rigid.h"
#include "core/paper/crease_pattern.h"
#include "core/paper/layer_order.h"
#include "core/paper/sheet.h"

namespace kiri {

/// What one fold made: the hinges that one slider drives. Its hinges are those edges whose `line`
/// names it.
struct FoldLine {
  std::string name;           ///< unique in the model
  double foldedAmount = 180;  ///< degrees that refold restores: the last amount that was not zero
  bool isValley = true;       ///< direction of the fold as it was seen when it was made
};

/// The facet of a connected piece from which the poses of the piece are composed.
struct Rest {
  FacetId facet;
  Rigid pose;
};

/// When in a motion one layer meets another.
enum class CollisionMoment {
  Start,  ///< a moving facet lies on the wrong side of a fixed one as the motion begins
  End,  ///< a moving facet arrives on both sides of a fixed one, or one pierces the other where it
        ///< lands
  Hinge,   ///< a hinge would turn past 180 degrees, through itself
  During,  ///< a moving facet meets a resting one on the way
};

/// One layer pushed through another.
struct Collision {
  std::uint32_t step = 0;  ///< number of the step in the model, from 1; 0 when applied by itself
  CollisionMoment moment = CollisionMoment::Start;
  Vec2 moving;            ///< point of the moving facet, paper frame
  Vec2 fixed;             ///< point of the fixed facet, paper frame
  double degrees = 0;     ///< how far the fold is folded then, in its own direction
  Vec3 place;             ///< where, model frame, mm; but for During a point of the moving facet
  bool isCertain = true;  ///< false: so near a touch that rounding decides
  std::string message;    ///< a sentence: what, where, what may be done
};

/// A moment in the life of the paper.
struct FoldedState {
  explicit FoldedState(CreasePattern p) : pattern(std::move(p)) {}

  CreasePattern pattern;
  std::vector<FoldLine> lines;
  std::vector<Rest> rests;  ///< one for each connected piece
  LayerOrder layers;
  std::vector<Rigid> poses;           ///< derived: one for each facet, see derivePoses
  std::vector<Collision> collisions;  ///< all that were met on the way here

  const Tolerance& tolerance() const { return pattern.tolerance; }
  const Rigid& poseOf(FacetId f) const { return poses[f.index]; }
};

/// The sheet as it lies before the first step.
FoldedState flatState(const Sheet& sheet);

/// The poses that follow from rests and fold angles, composing hinge rotations outward from each
/// rest.
std::vector<Rigid> derivePoses(const CreasePattern& pattern, const std::vector<Rest>& rests);

/// Piece number of every facet; pieces are numbered by their lowest facet. Paper holds together
/// along hinges.
std::vector<std::uint32_t> piecesOf(const CreasePattern& pattern);

/// The largest distance, mm, by which the two sides of a hinge disagree about its ends: 0 but for
/// rounding as long as the paper is not stretched.
double stretchOf(const FoldedState& state);

/// True when every fold angle is 0, 180 or -180.
bool isFlat(const FoldedState& state);

/// Degrees to which a fold line is folded in its own direction; none when its hinges disagree or it
/// has none.
std::optional<double> amountOf(const FoldedState& state, FoldLineId line);

}  // namespace kiri
