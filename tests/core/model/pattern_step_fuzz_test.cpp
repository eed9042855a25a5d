// Thousands of drawings that are mostly no patterns: a sound state or a sentence, nothing else.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <optional>

#include "core/model/apply.h"
#include "tests/support/expect.h"
#include "tests/support/model_text.h"
#include "tests/support/random_steps.h"
#include "tests/support/sanitized.h"
#include "tests/support/state_check.h"

namespace kiri::test {
namespace {

constexpr std::uint64_t kDrawings = casesOf<std::uint64_t>(4000, 400);

const char* const kSheets[] = {"square 60", "rectangle 60 40", "disc 60",
                               "polygon 0,0 60,0 60,60 30,20 0,60",
                               "polygon 0,0 60,0 60,60 0,60 hole 20,20 40,20 40,40 20,40"};

/// Lines between neighbours of a grid, some askew, some twice, some out of the sheet.
PatternStep randomPattern(Random& random) {
  PatternStep step;
  const std::size_t columns = 2 + random.below(4);
  for (std::size_t y = 0; y < columns; ++y) {
    for (std::size_t x = 0; x < columns; ++x) {
      const double size = 60.0 / static_cast<double>(columns - 1);
      Vec2 p{static_cast<double>(x) * size, static_cast<double>(y) * size};
      if (random.chance(0.02)) p = p + Vec2{random.between(-5, 5), random.between(-5, 5)};
      if (random.chance(0.02)) p.x += random.chance(0.5) ? 1e-8 : 1e-5;
      step.vertices.push_back(p);
    }
  }
  const auto number = [&](std::size_t x, std::size_t y) {
    return static_cast<std::uint32_t>(y * columns + x);
  };
  const double density = random.between(0.3, 1);
  const auto maybe = [&](std::uint32_t from, std::uint32_t to) {
    if (!random.chance(density)) return;
    const Assignment kinds[] = {Assignment::Valley,     Assignment::Mountain, Assignment::Flat,
                                Assignment::Unassigned, Assignment::Cut,      Assignment::Join};
    const double angles[] = {180, -180, 0, 180, 0, 0};
    const std::size_t kind = random.below(random.chance(0.3) ? 6 : 2);
    step.creases.push_back({from, to, kinds[kind], angles[kind]});
    if (random.chance(0.05)) step.creases.back().angle = random.between(-180, 180);
    if (random.chance(0.002)) step.creases.push_back(step.creases.back());
  };
  for (std::size_t y = 0; y < columns; ++y) {
    for (std::size_t x = 0; x < columns; ++x) {
      const bool isInnerRow = y > 0 && y + 1 < columns;
      const bool isInnerColumn = x > 0 && x + 1 < columns;
      if (x + 1 < columns && (isInnerRow || random.chance(0.01)))
        maybe(number(x, y), number(x + 1, y));
      if (y + 1 < columns && (isInnerColumn || random.chance(0.01)))
        maybe(number(x, y), number(x, y + 1));
      if (x + 1 < columns && y + 1 < columns && random.chance(0.5))
        maybe(number(x, y), number(x + 1, y + 1));
    }
  }
  step.isFolded = random.chance(0.7);
  if (random.chance(0.1)) step.resting = Vec2{random.between(-5, 65), random.between(-5, 65)};
  return step;
}

TEST(PatternStepFuzz, EveryDrawingGivesASoundStateOrASentence) {
  std::size_t drawn = 0;
  std::size_t folded = 0;
  for (std::uint64_t seed = 1; seed <= kDrawings; ++seed) {
    Random random(seed);
    const FoldedState sheet = startOf(modelOf(kSheets[random.below(std::size(kSheets))]));
    SCOPED_TRACE(seed);
    Step step;
    step.action = randomPattern(random);
    std::optional<Result<FoldedState>> tried;
    ASSERT_NO_THROW(tried.emplace(apply(sheet, step, 1))) << seed << textOf(step);
    const Result<FoldedState>& state = *tried;
    if (!state) {
      ASSERT_TRUE(failsWith(state, state.error().code, "")) << "seed " << seed;
      continue;
    }
    // Where paper meets paper the order is wrong, and the state says so.
    const bool hasFault = !state->collisions.empty();
    ASSERT_TRUE(patternViolations(state->pattern).empty() && poseViolations(*state).empty());
    ASSERT_TRUE(hasFault || isSound(*state)) << "seed " << seed << "\n" << textOf(step);
    ++drawn;
    const PatternStep& pattern = std::get<PatternStep>(step.action);
    if (!pattern.isFolded || state->lines.empty()) continue;
    ++folded;
    const Result<Step> resolved = resolve(sheet, step, 1);
    ASSERT_TRUE(resolved.isOk()) << "seed " << seed;
    const Result<FoldedState> again = apply(sheet, *resolved, 1);
    ASSERT_TRUE(again.isOk()) << "seed " << seed << ": " << again.error().message;
    ASSERT_EQ(again->collisions.size(), state->collisions.size()) << "seed " << seed;
  }
  EXPECT_GT(drawn, kDrawings / 20);
  EXPECT_GT(folded, kDrawings / 200);
}

}  // namespace
}  // namespace kiri::test
