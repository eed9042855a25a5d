// Secondary lobes of a recipe: which stand where, and which can be folded.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/leaf/fan.h"

namespace kiri {

/// The pairs on a lobe (0: the mid-lobe), from the petiole outward.
std::vector<const SecondaryLobes*> pairsOfLobe(const LeafRecipe& recipe, std::size_t lobe);

/// "the mid-lobe", "lobe 2"; with the junction where a lobe has several pairs.
std::string lobeName(const LeafRecipe& recipe, const SecondaryLobes& pair);

/// True for the way of Figure 7.4.
bool isTorn(const LeafRecipe& recipe);

/// Whether every pair can be folded flat between its neighbours. Errors: BadValue - with the pair
/// and the remedy: a lobe that is not there, angles or lengths out of order, a flap that would be
/// folded past its vein, creases that reach into another lobe, a tear where none can be made.
Status checkSecondaryLobes(const LeafRecipe& recipe, const std::vector<FanRay>& fan);

}  // namespace kiri
