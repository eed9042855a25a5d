// Claims about states and errors in the words of GoogleTest.
// SPDX-License-Identifier: MIT
#include "tests/support/expect.h"

#include <algorithm>
#include <cctype>
#include <limits>
#include <set>

#include "tests/support/state_check.h"
#include "tests/support/state_text.h"

namespace kiri::test {

testing::AssertionResult isSound(const FoldedState& state) {
  const std::vector<std::string> found = violationsOf(state);
  if (found.empty()) return testing::AssertionSuccess();
  return testing::AssertionFailure() << joined(found);
}

testing::AssertionResult isClean(const FoldedState& state) {
  if (!state.collisions.empty()) {
    return testing::AssertionFailure() << "collision: " << state.collisions.front().message;
  }
  return isSound(state);
}

testing::AssertionResult failsWith(const Result<FoldedState>& result, ErrorCode code,
                                   const std::string& fragment) {
  if (result) return testing::AssertionFailure() << "there is no error";
  const Error& error = result.error();
  if (error.code != code) {
    return testing::AssertionFailure()
           << "code " << static_cast<int>(error.code) << ": " << error.message;
  }
  const std::string& text = error.message;
  if (text.find(fragment) == std::string::npos)
    return testing::AssertionFailure() << "the sentence is: " << text;
  const bool isSentence = !text.empty() &&
                          std::isupper(static_cast<unsigned char>(text.front())) == 0 &&
                          text.back() != '.' && text.find('\n') == std::string::npos;
  if (!isSentence) return testing::AssertionFailure() << "not written as the others are: " << text;
  return testing::AssertionSuccess();
}

testing::AssertionResult isSameState(const FoldedState& a, const FoldedState& b) {
  const std::string difference = firstDifference(textOf(a), textOf(b));
  if (difference.empty()) return testing::AssertionSuccess();
  return testing::AssertionFailure() << difference;
}

FacetId facetOf(const FoldedState& state, Vec2 paper) {
  const std::optional<FacetId> facet = facetAt(state.pattern, paper);
  EXPECT_TRUE(facet.has_value()) << "no paper at (" << paper.x << ", " << paper.y << ")";
  return facet.value_or(FacetId(std::size_t{0}));
}

Vec3 modelOf(const FoldedState& state, Vec2 paper) {
  return state.poseOf(facetOf(state, paper)).apply(paper);
}

bool isAbove(const FoldedState& state, Vec2 a, Vec2 b) {
  const FacetId f = facetOf(state, a);
  const FacetId g = facetOf(state, b);
  EXPECT_TRUE(state.layers.areCoplanar(f, g));
  if (!state.layers.areCoplanar(f, g)) return false;
  const bool isUp = state.layers.sets()[state.layers.setOf(f)].normal.z > 0;
  return state.layers.isAbove(f, g) == isUp;
}

testing::AssertionResult liesAt(const FoldedState& state, Vec2 paper, Vec3 model) {
  const Vec3 there = modelOf(state, paper);
  if (distance(there, model) <= 1e-9 * state.tolerance().sheetSize())
    return testing::AssertionSuccess();
  return testing::AssertionFailure()
         << "it lies at (" << there.x << ", " << there.y << ", " << there.z << ")";
}

double areaOf(const FoldedState& state) { return kiri::areaOf(state.pattern); }

std::size_t facetCount(const FoldedState& state) { return state.pattern.facets.size(); }

std::size_t pieceCount(const FoldedState& state) {
  const std::vector<std::uint32_t> pieces = piecesOf(state.pattern);
  return std::set<std::uint32_t>(pieces.begin(), pieces.end()).size();
}

std::size_t edgeCount(const FoldedState& state, EdgeKind kind) {
  const auto count = std::count_if(state.pattern.edges.begin(), state.pattern.edges.end(),
                                   [kind](const Edge& edge) { return edge.kind == kind; });
  return static_cast<std::size_t>(count);
}

std::vector<double> anglesOf(const FoldedState& state, const std::string& line) {
  std::vector<double> angles;
  for (const Edge& edge : state.pattern.edges) {
    if (edge.kind != EdgeKind::Hinge || !edge.line.isValid()) continue;
    if (state.lines[edge.line.index].name == line) angles.push_back(edge.angle);
  }
  std::sort(angles.begin(), angles.end());
  return angles;
}

double amountOf(const FoldedState& state, const std::string& line) {
  for (std::size_t i = 0; i < state.lines.size(); ++i) {
    if (state.lines[i].name != line) continue;
    return kiri::amountOf(state, FoldLineId(i)).value_or(std::numeric_limits<double>::quiet_NaN());
  }
  ADD_FAILURE() << "no fold line is called '" << line << "'";
  return 0;
}

}  // namespace kiri::test
