// Claims about states and errors in the words of GoogleTest.
// SPDX-License-Identifier: MIT
#pragma once

#include <gtest/gtest.h>

#include <cstddef>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/paper/folded_state.h"

namespace kiri::test {

/// Holds when no check of state_check.h finds anything; says what was found.
testing::AssertionResult isSound(const FoldedState& state);
/// Holds when the state is sound and no layer was pushed through another on the way.
testing::AssertionResult isClean(const FoldedState& state);
/// Holds when the result is an error of this code whose sentence contains `fragment` and is one
/// sentence: it starts with a small letter or a digit, has no full stop at the end and no line
/// break.
testing::AssertionResult failsWith(const Result<FoldedState>& result, ErrorCode code,
                                   const std::string& fragment);
testing::AssertionResult isSameState(const FoldedState& a, const FoldedState& b);

/// The facet that holds a place of the sheet. The test fails when there is none.
FacetId facetOf(const FoldedState& state, Vec2 paper);
/// Where a place of the sheet lies in the model.
Vec3 modelOf(const FoldedState& state, Vec2 paper);
/// Whether the paper around `a` lies above that around `b`, seen from the front of the model (+z).
bool isAbove(const FoldedState& state, Vec2 a, Vec2 b);
testing::AssertionResult liesAt(const FoldedState& state, Vec2 paper, Vec3 model);

double areaOf(const FoldedState& state);
std::size_t facetCount(const FoldedState& state);
std::size_t pieceCount(const FoldedState& state);
std::size_t edgeCount(const FoldedState& state, EdgeKind kind);
/// Fold angles of the hinges of a fold line, sorted.
std::vector<double> anglesOf(const FoldedState& state, const std::string& line);
double amountOf(const FoldedState& state, const std::string& line);

}  // namespace kiri::test
