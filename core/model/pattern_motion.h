// How a crease pattern gets from the flat sheet to its folded state with rigid facets, if it does.
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "core/base/progress.h"
#include "core/fold/movement.h"
#include "core/linkage/rigid_path.h"
#include "core/paper/folded_state.h"

namespace kiri {

enum class PatternWay {
  Rigid,        ///< the facets stay flat all the way, and the paper meets nothing
  OneByOne,     ///< the same, one fold line after the other
  MustBend,     ///< no way of rigid facets was found
  MeetsItself,  ///< there is a way, but the paper would pass through itself on it or come to lie
                ///< in another order
  NotTried,     ///< more facets than are followed
};

/// More facets than this are not followed: the time grows with them, and models of so many rarely
/// fold rigidly.
inline constexpr std::size_t kMostRigidFacets = 1000;

struct PatternMotion {
  PatternWay way = PatternWay::MustBend;
  std::shared_ptr<const RigidPath> path;  ///< where there is one that arrives
  /// The state at its end, with the layer order that the motion itself leads to.
  std::optional<FoldedState> end;
};

/// The motion of all creases at once from `flat` to the angles of `folded`, which has the same
/// pattern and rests. Layers of `folded` are not looked at; see haveSameOrder.
PatternMotion patternMotion(const FoldedState& flat, const FoldedState& folded,
                            const Progress& progress = {});

/// The way to `folded` one fold line after the other, as maps are folded: found by unfolding it.
/// None when no order of the lines does without meeting paper, or they are too many to be tried.
Movements foldingOneByOne(const FoldedState& flat, const FoldedState& folded,
                          const Progress& progress = {});

/// True when every two facets of one plane that overlap lie in the same order in both states, which
/// have the same pattern and poses. Cost: pairs of facets of one plane.
bool haveSameOrder(const FoldedState& a, const FoldedState& b);

/// What the way means for who folds it, as a sentence: "the paper must bend ...". Empty for Rigid
/// and OneByOne.
std::string sentenceOf(PatternWay way);

}  // namespace kiri
