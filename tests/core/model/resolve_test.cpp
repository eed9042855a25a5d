// Resolved steps: nothing in them hangs on how the model lay, and they do the same.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "core/model/apply.h"
#include "tests/support/expect.h"
#include "tests/support/model_text.h"

namespace kiri::test {
namespace {

const char* const kFolded =
    "square 100; fold A valley 50,0 50,100 left; fold B valley @model 40,50 110,50 left";

class Resolving : public testing::TestWithParam<const char*> {};

TEST_P(Resolving, GivesTheSameState) {
  const FoldedState state = run(kFolded);
  const Step step = stepOf(GetParam());
  const Result<FoldedState> direct = apply(state, step, 3);
  ASSERT_TRUE(direct.isOk()) << direct.error().message;
  const Result<Step> resolved = resolve(state, step, 3);
  ASSERT_TRUE(resolved.isOk()) << resolved.error().message;
  const Result<FoldedState> again = apply(state, *resolved, 3);
  ASSERT_TRUE(again.isOk()) << again.error().message;
  EXPECT_TRUE(isSound(*again));
  ASSERT_EQ(facetCount(*direct), facetCount(*again));
  for (const Vec2 v : direct->pattern.vertices) {
    const FacetId f = facetOf(*direct, v);
    const Vec2 inside = interiorPointOf(direct->pattern, f);
    EXPECT_TRUE(liesAt(*again, inside, modelOf(*direct, inside)));
  }
}

INSTANTIATE_TEST_SUITE_P(
    All, Resolving,
    testing::Values("fold C valley @model 75,-10 75,60 right",
                    "fold C mountain 90 @model 75,-10 75,60 left",
                    "fold C valley @model 110,30 70,-10 to m:98,2 top 2",
                    "fold C valley @model 110,30 70,-10 to m:98,2 top 1", "angle B 30",
                    "angle m:75,50 30", "unfold", "unfold B together", "edge @model 75,-10 75,60",
                    "cut @model 75,-10 75,60 keep m:60,20",
                    "cut @model 75,-10 75,60 through keep m:60,20",
                    "curve @model 40,20 60,35 75,20 85,30 95,10 120,15 keep m:60,45",
                    "tear @model 50,50 75,50 top 1", "turn", "rotate 30", "move 5,6"));

TEST(Resolve, WritesTheLineOnThePaperOfANamedFacet) {
  const FoldedState state = run(kFolded);
  const Step resolved =
      resolve(state, stepOf("fold C valley @model 110,30 70,-10 to m:98,2 top 2"), 3).value();
  const FoldStep& fold = std::get<FoldStep>(resolved.action);
  EXPECT_EQ(fold.line.frame, Frame::Paper);
  EXPECT_TRUE(fold.line.facet.has_value());
  EXPECT_TRUE(std::holds_alternative<ChosenLayers>(fold.layers));
  EXPECT_EQ(std::get<ChosenLayers>(fold.layers).facets.size(), 2u);
  EXPECT_FALSE(fold.name.empty());
}

TEST(Resolve, KeepsTitleNotesAndUnknownFields) {
  const FoldedState state = run(kFolded);
  Step step = stepOf("fold C valley @model 75,-10 75,60 right");
  step.title = "t";
  step.notes = "n";
  step.unknown = "{\"u\":1}";
  const Step resolved = resolve(state, step, 3).value();
  EXPECT_EQ(resolved.title, "t");
  EXPECT_EQ(resolved.notes, "n");
  EXPECT_EQ(resolved.unknown, "{\"u\":1}");
}

TEST(Resolve, RefusesWhatApplyRefuses) {
  const FoldedState state = run(kFolded);
  EXPECT_FALSE(resolve(state, stepOf("fold C valley @model 275,-10 275,60 right"), 3).isOk());
  EXPECT_FALSE(resolve(state, stepOf("angle nobody 20"), 3).isOk());
}

}  // namespace
}  // namespace kiri::test
