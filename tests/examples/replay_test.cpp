// Every model of examples/ replays: nothing is stretched, no paper is lost, and the way back is the
// way there. SPDX-License-Identifier: MIT
#include <variant>

#include "core/model/history.h"
#include "io/kiri_reader.h"
#include "io/kiri_writer.h"
#include "tests/examples/example_models.h"
#include "tests/support/state_check.h"
#include "tests/support/state_text.h"

namespace kiri::test {
namespace {

class EveryExample : public ExampleTest {};

bool isCutting(const Step& step) {
  return std::holds_alternative<StraightCutStep>(step.action) ||
         std::holds_alternative<CurveCutStep>(step.action);
}

TEST_P(EveryExample, StretchesInNoState) {
  for (std::size_t i = 0; i < example().states.size(); ++i) {
    const FoldedState& state = *example().states[i];
    const double within = 1e-9 * state.tolerance().sheetSize();
    EXPECT_LE(stretchOf(state), within) << momentName(example(), i);
    EXPECT_LE(hingeGap(state), within) << momentName(example(), i);
    EXPECT_EQ(joined(violationsOf(state)), "") << momentName(example(), i);
  }
}

TEST_P(EveryExample, LosesPaperInCutsOnly) {
  for (std::size_t i = 1; i < example().states.size(); ++i) {
    const double before = areaOf(example().states[i - 1]->pattern);
    const double after = areaOf(example().states[i]->pattern);
    if (isCutting(example().model.steps[i - 1])) {
      EXPECT_LE(after, before * (1 + 1e-9)) << momentName(example(), i);
      EXPECT_GT(after, 0) << momentName(example(), i);
    } else {
      EXPECT_NEAR(after, before, 1e-9 * before) << momentName(example(), i);
    }
  }
}

void expectSame(const FoldedState& state, const ExampleModel& example, std::size_t step) {
  EXPECT_EQ(firstDifference(textOf(state), textOf(*example.states[step])), "")
      << momentName(example, step);
}

TEST_P(EveryExample, IsTheSameAfterUndoAndRedo) {
  Result<History> history = History::open(example().model);
  ASSERT_TRUE(history);
  const std::size_t count = example().model.steps.size();
  for (std::size_t i = count; i-- > 0;) {
    ASSERT_TRUE(history->undo());
    expectSame(history->state(), example(), i);
  }
  for (std::size_t i = 1; i <= count; ++i) {
    ASSERT_TRUE(history->redo());
    expectSame(history->state(), example(), i);
  }
  ASSERT_TRUE(history->moveTo(0));
  history->dropUndone();
  while (history->undo()) {
  }
  for (std::size_t i = 0; i < count; ++i) {
    const Status added = history->add(example().model.steps[i]);
    ASSERT_TRUE(added) << momentName(example(), i + 1) << ": " << added.error().message;
    expectSame(history->state(), example(), i + 1);
  }
}

TEST_P(EveryExample, IsTheSameAfterSavingAndOpening) {
  const Result<LoadedModel> again = readKiri(writeKiri(example().model), "again.kiri");
  ASSERT_TRUE(again) << again.error().message;
  EXPECT_EQ(again->model, example().model);
  EXPECT_TRUE(again->warnings.empty());
}

KIRI_FOR_EVERY_EXAMPLE(EveryExample);

}  // namespace
}  // namespace kiri::test
