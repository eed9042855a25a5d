// The planar map: loops, uses, areas, and finding facets by places.
// SPDX-License-Identifier: MIT
#include "core/paper/crease_pattern.h"

#include <gtest/gtest.h>

#include <numbers>

#include "core/paper/pattern_edit.h"
#include "tests/support/expect.h"
#include "tests/support/model_text.h"
#include "tests/support/plane_overlap.h"
#include "tests/support/random_steps.h"
#include "tests/support/state_check.h"

namespace kiri::test {
namespace {

CreasePattern patternFor(const char* sheet) {
  return startOf(kiri::test::modelOf(std::string_view(sheet))).pattern;
}

TEST(PatternOfASheet, IsOneFacetWithTheSheetsArea) {
  const CreasePattern square = patternFor("square 100");
  EXPECT_EQ(joined(patternViolations(square)), "");
  EXPECT_EQ(square.facets.size(), 1u);
  EXPECT_EQ(square.edges.size(), 4u);
  EXPECT_DOUBLE_EQ(kiri::areaOf(square), 10000);
  const CreasePattern disc = patternFor("disc 100");
  EXPECT_EQ(joined(patternViolations(disc)), "");
  EXPECT_NEAR(kiri::areaOf(disc), std::numbers::pi * 2500, 1e-4);
  const CreasePattern holed =
      patternFor("polygon 0,0 100,0 100,100 0,100 hole 40,40 60,40 60,60 40,60");
  EXPECT_EQ(joined(patternViolations(holed)), "");
  EXPECT_EQ(holed.facets.front().holeStarts.size(), 1u);
  EXPECT_DOUBLE_EQ(kiri::areaOf(holed), 9600);
}

TEST(SplitEdge, KeepsBothFacetsSharingTheNewVertex) {
  CreasePattern pattern = run("square 100; edge 50,0 50,100").pattern;
  for (std::size_t e = 0; e < pattern.edges.size(); ++e) {
    if (pattern.edges[e].kind != EdgeKind::Hinge) continue;
    const VertexId middle = splitEdge(pattern, EdgeId(e), 0.25);
    EXPECT_EQ(joined(patternViolations(pattern)), "");
    EXPECT_NEAR(pattern[middle].x, 50, 1e-12);
    EXPECT_EQ(pattern.facets[0].border.size(), 5u);
    EXPECT_EQ(pattern.facets[1].border.size(), 5u);
    return;
  }
  FAIL() << "no hinge";
}

TEST(SplitEdge, OfACurveKeepsItsShape) {
  CreasePattern pattern = patternFor("disc 100");
  const double area = kiri::areaOf(pattern);
  for (int i = 0; i < 10; ++i)
    splitEdge(pattern, EdgeId(static_cast<std::size_t>(i)), 0.1 * i + 0.05);
  EXPECT_EQ(joined(patternViolations(pattern)), "");
  EXPECT_NEAR(kiri::areaOf(pattern), area, 1e-9);
}

TEST(FacetAt, FindsTheFacetOfEveryInteriorPoint) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    Random random(seed);
    const Model model = randomSheet(random);
    FoldedState state = startOf(model);
    for (int i = 1; i <= 10; ++i) {
      Result<FoldedState> next = tryAfter(state, textOf(randomStep(random, state, {})));
      if (next) state = std::move(next).value();
    }
    for (std::size_t f = 0; f < state.pattern.facets.size(); ++f) {
      const Vec2 inside = interiorPointOf(state.pattern, FacetId(f));
      EXPECT_TRUE(contains(flatLoopsOf(state.pattern, FacetId(f), 64), inside)) << "seed " << seed;
      const std::optional<FacetId> found = facetAt(state.pattern, inside);
      ASSERT_TRUE(found.has_value()) << "seed " << seed;
      EXPECT_EQ(*found, FacetId(f)) << "seed " << seed;
    }
  }
}

TEST(FacetAt, FindsNothingBesideThePaperAndInHoles) {
  const CreasePattern holed =
      patternFor("polygon 0,0 100,0 100,100 0,100 hole 40,40 60,40 60,60 40,60");
  EXPECT_FALSE(facetAt(holed, {50, 50}).has_value());
  EXPECT_FALSE(facetAt(holed, {-1, 50}).has_value());
  EXPECT_TRUE(facetAt(holed, {0, 50}).has_value()) << "a place on the border belongs to the paper";
}

TEST(KeepFacets, MakesBordersOfEdgesTowardsWhatGoes) {
  const FoldedState state = run("square 100; edge 50,0 50,100; edge 0,50 100,50");
  std::vector<bool> keep(4, true);
  keep[facetOf(state, {25, 25}).index] = false;
  const Kept kept = keepFacets(state.pattern, keep);
  EXPECT_EQ(joined(patternViolations(kept.pattern)), "");
  EXPECT_EQ(kept.pattern.facets.size(), 3u);
  EXPECT_DOUBLE_EQ(kiri::areaOf(kept.pattern), 7500);
  EXPECT_EQ(kept.pattern.vertices.size(), 8u);
}

}  // namespace
}  // namespace kiri::test
