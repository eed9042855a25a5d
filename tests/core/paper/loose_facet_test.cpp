// Loose facets are whole facets that nothing hangs on.
// SPDX-License-Identifier: MIT
#include "core/paper/loose_facet.h"

#include <gtest/gtest.h>

#include "core/geometry/region.h"

namespace kiri {
namespace {

TEST(LooseFacet, HasItsOwnBorderAndLeavesOthersAlone) {
  CreasePattern pattern(Tolerance(100));
  const Vec2 square[] = {{0, 0}, {10, 0}, {10, 10}, {0, 10}};
  const Vec2 triangle[] = {{0, 0}, {10, 0}, {0, 10}};
  const FacetId first = addLooseFacet(pattern, square);
  const FacetId second = addLooseFacet(pattern, triangle);
  ASSERT_EQ(pattern.facets.size(), 2U);
  EXPECT_EQ(pattern.vertices.size(), 7U);
  EXPECT_EQ(pattern.edges.size(), 7U);
  EXPECT_NEAR(areaOf(regionOf(pattern, first)), 100, 1e-9);
  EXPECT_NEAR(areaOf(regionOf(pattern, second)), 50, 1e-9);
  for (const Edge& edge : pattern.edges) {
    EXPECT_EQ(edge.kind, EdgeKind::Border);
    EXPECT_TRUE(edge.left.isValid());
    EXPECT_FALSE(edge.right.isValid());
  }
}

}  // namespace
}  // namespace kiri
