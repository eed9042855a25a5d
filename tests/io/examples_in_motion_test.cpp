// The examples on their way from step to step.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "core/model/apply.h"
#include "core/model/replay.h"
#include "tests/support/example_files.h"
#include "tests/support/order_check.h"
#include "tests/support/sanitized.h"
#include "tests/support/state_check.h"

namespace kiri {
namespace {

void checkOnTheWay(const Movement& movement, const std::string& where) {
  const double area = areaOf(movement.start->pattern);
  for (const double part : {0.01, 0.37, 0.8, 0.99}) {
    const FoldedState there = stateDuring(movement, part);
    const std::string moment = where + " at " + std::to_string(part);
    EXPECT_LE(stretchOf(there), 1e-9 * there.tolerance().sheetSize()) << moment;
    EXPECT_NEAR(areaOf(there.pattern), area, 1e-9 * area) << moment;
    EXPECT_EQ(test::joined(test::poseViolations(there)), "") << moment;
    EXPECT_EQ(test::joined(test::orderViolations(there)), "") << moment;
  }
}

TEST(ExamplesInMotion, NeverStretchAndKeepTheirLayersRightOnTheWay) {
  std::size_t movementCount = 0;
  for (const std::filesystem::path& file : test::exampleFilesThatTakeLong()) {
    const std::string name = file.filename().string();
    const Model model = test::modelInFile(file);
    const Result<Sheet> sheet = makeSheet(model.sheet);
    FoldedState state = flatState(*sheet);
    for (std::size_t i = 0; i < model.steps.size(); ++i) {
      Movements movements;
      Result<FoldedState> next = apply(state, model.steps[i], static_cast<int>(i) + 1, &movements);
      ASSERT_TRUE(next.isOk()) << name << ": " << next.error().message;
      for (const Movement& movement : movements)
        checkOnTheWay(movement, name + " step " + std::to_string(i + 1));
      movementCount += movements.size();
      state = std::move(*next);
    }
  }
  EXPECT_GT(movementCount, test::casesOf(200u, 40u));
}

}  // namespace
}  // namespace kiri
