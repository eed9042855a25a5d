// Where places of the sheet lie, for tests of what a hand did.
// SPDX-License-Identifier: MIT
#pragma once

#include <gtest/gtest.h>

#include "core/paper/folded_state.h"

namespace kiri::test {

/// Where a place of the sheet lies, model frame.
inline Vec3 imageOf(const FoldedState& state, Vec2 paper) {
  return state.poseOf(*facetAt(state.pattern, paper)).apply(paper);
}

#define EXPECT_AT(point, X, Y, Z)      \
  do {                                 \
    const ::kiri::Vec3 seenAt = point; \
    EXPECT_NEAR(seenAt.x, X, 1e-6);    \
    EXPECT_NEAR(seenAt.y, Y, 1e-6);    \
    EXPECT_NEAR(seenAt.z, Z, 1e-6);    \
  } while (false)

}  // namespace kiri::test
