// Every model of examples/ can be laid flat again, in order and together.
// SPDX-License-Identifier: MIT
#include <algorithm>

#include "core/model/apply.h"
#include "core/model/moments.h"
#include "tests/examples/example_models.h"
#include "tests/support/state_check.h"

namespace kiri::test {
namespace {

class EveryOpening : public ExampleTest {};

TEST_P(EveryOpening, EndsWithFlatPaper) {
  const int number = static_cast<int>(example().states.size());
  for (const Sequence sequence : {Sequence::InOrder, Sequence::Together}) {
    const Step unfold{UnfoldStep{{}, sequence}, "", "", ""};
    const Result<FoldedState> open = apply(example().last(), unfold, number);
    ASSERT_TRUE(open) << GetParam() << ": " << open.error().message;
    EXPECT_EQ(joined(violationsOf(*open)), "") << GetParam();
    const std::vector<Edge>& edges = open->pattern.edges;
    EXPECT_TRUE(std::none_of(edges.begin(), edges.end(), [](const Edge& edge) {
      return edge.kind == EdgeKind::Hinge && edge.angle != 0;
    })) << GetParam();
  }
}

KIRI_FOR_EVERY_EXAMPLE(EveryOpening);

/// The bird base does not open with stiff facets: only its wings would be seen half open.
TEST(Crane, IsNotSaidToBeHalfUnfoldedWhereItsPaperMustBend) {
  const Model& crane = exampleModel("origami_crane").model;
  const Moments moments = momentsOf(crane, Timeline::of(crane).value());
  EXPECT_EQ(moments.halfWay, HalfWay::LastFold);
}

}  // namespace
}  // namespace kiri::test
