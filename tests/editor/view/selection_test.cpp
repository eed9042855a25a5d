// What the person has picked.
// SPDX-License-Identifier: MIT
#include "editor/view/selection.h"

#include <gtest/gtest.h>

#include <vector>

#include "tests/support/model_text.h"

namespace kiri::testing {
namespace {

TEST(Selection, TogglingTwiceChangesNothing) {
  const FoldedState state = test::run("square 100; fold valley 50,0 50,100 left");
  Selection selection;
  const Selected facet = selectedFacet(state, FacetId(std::size_t{0}));
  const Selected vertex = selectedVertex(state, VertexId(std::size_t{0}));
  selection.toggle(facet);
  selection.toggle(vertex);
  EXPECT_EQ(selection.items().size(), 2U);
  selection.toggle(facet);
  EXPECT_EQ(selection.items(), std::vector{vertex});
  selection.toggle(vertex);
  EXPECT_TRUE(selection.isEmpty());
}

TEST(Selection, FacetsAreFoundAgainAfterSteps) {
  const FoldedState flat = test::run("square 100; fold valley 50,0 50,100 left; unfold all");
  Selection selection;
  const FacetId left = facetAt(flat.pattern, {10, 50}).value();
  selection.toggle(selectedFacet(flat, left));
  EXPECT_EQ(facetsOf(flat, selection), std::vector{left});
  const FoldedState later = test::after(flat, "fold across valley 0,80 100,80 left; unfold all");
  const std::vector<FacetId> found = facetsOf(later, selection);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found.front(), facetAt(later.pattern, {25, 50}).value());
}

TEST(Selection, PaperThatIsGoneIsNoLongerSelected) {
  const FoldedState flat = test::run("square 100");
  Selection selection;
  selection.toggle(selectedFacet(flat, FacetId(std::size_t{0})));
  const FoldedState cut = test::after(flat, "cut 0,20 100,20 keep 50,10");
  EXPECT_TRUE(facetsOf(cut, selection).empty());
}

TEST(Selection, ALineIsItsEndsAndItsMiddle) {
  const FoldedState state = test::run("square 100; fold valley 50,0 50,100 left");
  Selection selection;
  EXPECT_FALSE(selection.lastLine().has_value());
  for (std::uint32_t e = 0; e < state.pattern.edges.size(); ++e) {
    if (state.pattern.edges[e].kind != EdgeKind::Hinge) continue;
    selection.toggle(selectedLine(state, EdgeId(e)));
  }
  selection.toggle(selectedVertex(state, VertexId(std::size_t{0})));
  ASSERT_TRUE(selection.lastLine().has_value());
  const Selected line = *selection.lastLine();
  EXPECT_EQ(line.place, (Vec2{50, 50}));
  EXPECT_EQ(distance(line.from, line.to), 100);
  EXPECT_EQ(selection.placesOf(SelectedKind::Line), (std::vector<Vec2>{{50, 50}}));
}

}  // namespace
}  // namespace kiri::testing
