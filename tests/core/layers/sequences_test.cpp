// Fold sequences through all layers against a folder written apart: half, spiral and offset (guide:
// peers 10.1). SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "core/model/apply.h"
#include "tests/support/expect.h"
#include "tests/support/model_text.h"
#include "tests/support/reference_folder.h"
#include "tests/support/state_check.h"

namespace kiri::test {
namespace {

struct Sequence8 {
  FoldSequence sequence;
  int folds;
  bool hasMountains;
};

class Sequences : public testing::TestWithParam<Sequence8> {};

TEST_P(Sequences, GiveTheLayersOfTheReferenceAtEveryStep) {
  const Sequence8 param = GetParam();
  ReferenceStack stack = unfolded({{0, 0}, {100, 0}, {100, 100}, {0, 100}});
  FoldedState state = run("square 100");
  for (int k = 0; k < param.folds; ++k) {
    const auto [a, b] = lineOf(param.sequence, stack, k);
    const bool isValley = !param.hasMountains || k % 3 != 1;
    stack = folded(stack, a, b, isValley);
    FoldStep fold;
    fold.line = {Frame::Model, a, b, std::nullopt};
    fold.type = isValley ? FoldType::Valley : FoldType::Mountain;
    Step step;
    step.action = fold;
    Result<FoldedState> next = apply(state, step, k + 1);
    ASSERT_TRUE(next.isOk()) << next.error().message;
    state = std::move(next).value();
    ASSERT_EQ(joined(differences(stack, state)), "") << "after fold " << k + 1;
    EXPECT_NEAR(areaOf(state), 10000, 1e-7);
    EXPECT_NEAR(test::areaOf(stack), 10000, 1e-6);
    EXPECT_TRUE(state.collisions.empty()) << state.collisions.front().message;
    if (facetCount(state) <= 64) {
      EXPECT_TRUE(isSound(state));
    }
  }
}

INSTANTIATE_TEST_SUITE_P(All, Sequences,
                         testing::Values(Sequence8{FoldSequence::Half, 8, false},
                                         Sequence8{FoldSequence::Half, 7, true},
                                         Sequence8{FoldSequence::Spiral, 8, false},
                                         Sequence8{FoldSequence::Spiral, 8, true},
                                         Sequence8{FoldSequence::Offset, 9, false},
                                         Sequence8{FoldSequence::Offset, 8, true}));

TEST(ReferenceFolder, HasTheFacetsThatAPeerCounted) {
  const int half[] = {2, 4, 8, 16, 32, 64, 128, 256};
  const int spiral[] = {2, 4, 8, 16, 30, 56, 84, 144};
  for (const FoldSequence sequence : {FoldSequence::Half, FoldSequence::Spiral}) {
    ReferenceStack stack = unfolded({{0, 0}, {1, 0}, {1, 1}, {0, 1}});
    for (int k = 0; k < 8; ++k) {
      const auto [a, b] = lineOf(sequence, stack, k);
      stack = folded(stack, a, b, true);
      const int expected = sequence == FoldSequence::Half ? half[k] : spiral[k];
      EXPECT_EQ(stack.size(), static_cast<std::size_t>(expected)) << k + 1;
    }
  }
}

}  // namespace
}  // namespace kiri::test
