// Flat states of the models of examples/: layers and creases are such as paper can have.
// SPDX-License-Identifier: MIT
#include <cmath>

#include "core/flatfold/local_conditions.h"
#include "core/model/pattern_model.h"
#include "tests/examples/example_models.h"
#include "tests/examples/vertex_laws.h"
#include "tests/support/order_check.h"
#include "tests/support/state_check.h"

namespace kiri::test {
namespace {

class EveryFlatState : public ExampleTest {};

TEST_P(EveryFlatState, HasAnOrderThatPaperCanHave) {
  for (std::size_t i = 0; i < example().states.size(); ++i) {
    const FoldedState& state = *example().states[i];
    if (!isFlat(state)) continue;
    EXPECT_EQ(joined(orderViolations(state)), "") << momentName(example(), i);
  }
}

TEST_P(EveryFlatState, ObeysKawasakiAndMaekawaWhereNoTearAndNoCutTouches) {
  for (std::size_t i = 0; i < example().states.size(); ++i) {
    const FoldedState& state = *example().states[i];
    if (!isFlat(state)) continue;
    EXPECT_EQ(joined(vertexLawsOf(state).faults), "") << momentName(example(), i);
    for (const VertexFault& fault : vertexFaults(assignedPatternOf(state))) {
      ADD_FAILURE() << momentName(example(), i) << ": " << fault.message;
    }
  }
}

KIRI_FOR_EVERY_EXAMPLE(EveryFlatState);

/// The last flat state of a model with a vertex to which the laws apply.
FoldedState withVertices(const std::string& name) {
  const ExampleModel& example = exampleModel(name);
  for (std::size_t i = example.states.size(); i-- > 0;) {
    const FoldedState& state = *example.states[i];
    if (isFlat(state) && vertexLawsOf(state).vertexCount > 0) return state;
  }
  ADD_FAILURE() << name << " has no vertex inside the paper";
  return example.last();
}

TEST(VertexLaws, MissNoneOfTheVerticesThatTheProductLooksAt) {
  for (const char* name : {"origami_cup", "origami_samurai_hat", "pattern_bird_base", "ship"}) {
    const FoldedState state = withVertices(name);
    const int count = vertexLawsOf(state).vertexCount;
    int foundByLaws = 0;
    int foundByProduct = 0;
    for (std::size_t e = 0; e < state.pattern.edges.size(); ++e) {
      FoldedState spoilt = state;
      Edge& edge = spoilt.pattern.edges[e];
      if (edge.kind != EdgeKind::Hinge || edge.angle == 0) continue;
      edge.angle = -edge.angle;
      foundByLaws += vertexLawsOf(spoilt).faults.empty() ? 0 : 1;
      foundByProduct += vertexFaults(assignedPatternOf(spoilt)).empty() ? 0 : 1;
    }
    EXPECT_GT(count, 0) << name;
    EXPECT_GT(foundByLaws, 0) << name;
    EXPECT_GE(foundByProduct, foundByLaws) << name;  // it knows more laws
  }
}

TEST(VertexLaws, NoticeAVertexThatIsMoved) {
  FoldedState state = withVertices("pattern_bird_base");
  ASSERT_EQ(joined(vertexLawsOf(state).faults), "");
  for (Vec2& vertex : state.pattern.vertices) vertex = vertex + Vec2{0, vertex.x * vertex.x / 1e4};
  EXPECT_NE(joined(vertexLawsOf(state).faults), "");
}

}  // namespace
}  // namespace kiri::test
