// The sweep against brute force, over random motions of random models.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "core/model/apply.h"
#include "core/sweep/sweep.h"
#include "tests/support/crossing_check.h"
#include "tests/support/model_text.h"
#include "tests/support/motion_check.h"
#include "tests/support/order_check.h"
#include "tests/support/random_steps.h"
#include "tests/support/sanitized.h"
#include "tests/support/state_check.h"

namespace kiri::test {
namespace {

constexpr int kMotions = casesOf<int>(1200, 60);

bool isCurved(const FoldedState& state) { return !state.pattern.curves.empty(); }

struct Tally {
  int free = 0;
  int collides = 0;
  int undecided = 0;
};

/// Compares one motion; returns what is wrong.
std::string compare(const FoldedState& state, const LineMotion& how, Tally& tally) {
  const double size = state.tolerance().sheetSize();
  const SweepReport report = sweep(state, how.moves, how.motion);
  const MotionCheck check(state, how);
  const double deep = (isCurved(state) ? 2e-3 : 1e-6) * size;
  const std::optional<Crossing> sampled = check.firstCrossing(40, deep);
  const double reported = std::abs(report.degrees);
  switch (report.verdict) {
    case SweepVerdict::Undecided:
      ++tally.undecided;
      return "";
    case SweepVerdict::Free:
      ++tally.free;
      if (!sampled) return "";
      return "free, but facet " + std::to_string(sampled->moving.index) + " is " +
             std::to_string(sampled->depth) + " mm deep in facet " +
             std::to_string(sampled->resting.index) + " at " + std::to_string(sampled->degrees);
    case SweepVerdict::Collides:
      break;
  }
  ++tally.collides;
  if (sampled && sampled->degrees < reported - 1e-3)
    return "met at " + std::to_string(reported) + ", but facet " +
           std::to_string(sampled->moving.index) + " is " + std::to_string(sampled->depth) +
           " mm deep in facet " + std::to_string(sampled->resting.index) + " already at " +
           std::to_string(sampled->degrees);
  double shown = check.overlapAt(report.moving, report.resting, reported);
  for (double ahead = 1e-5; ahead < 4 && shown <= 1e-9 * size; ahead *= 2)
    shown = std::max(shown, check.depthAt(report.moving, report.resting, reported + ahead));
  // Where paper goes on straight across a crease, its next facet may show it.
  for (double ahead = 1e-5; ahead < 4 && shown <= 1e-9 * size; ahead *= 2)
    shown = std::max(shown, check.deepestAt(reported + ahead));
  if (shown > 1e-9 * size) return "";
  return "facet " + std::to_string(report.moving.index) + " is said to meet facet " +
         std::to_string(report.resting.index) + " at " + std::to_string(reported) +
         ", but nothing crosses there";
}

/// By how much distances between corners of a facet differ in space from those on the sheet.
double changeOfSize(const FoldedState& state) {
  double worst = 0;
  for (std::size_t f = 0; f < state.pattern.facets.size(); ++f) {
    const std::vector<EdgeUse>& border = state.pattern.facets[f].border;
    const Vec2 first = state.pattern[startOf(state.pattern, border.front())];
    for (const EdgeUse use : border) {
      const Vec2 a = state.pattern[startOf(state.pattern, use)];
      for (const Vec2 b : {first, state.pattern[endOf(state.pattern, use)]}) {
        const double folded = distance(state.poses[f].apply(a), state.poses[f].apply(b));
        worst = std::max(worst, std::abs(folded - distance(a, b)));
      }
    }
  }
  return worst;
}

/// What is wrong with the states on the way and at the end of a motion.
std::string follow(const FoldedState& state, const std::string& line, double amount) {
  AngleStep angle;
  angle.line = line;
  angle.angle = amount;
  Step step;
  step.action = angle;
  Movements movements;
  const Result<FoldedState> end = apply(state, step, 1, &movements);
  if (!end) return "";
  for (const Movement& movement : movements) {
    for (const double part : {0.3, 0.7, 1.0}) {
      const FoldedState now = stateDuring(movement, part);
      if (changeOfSize(now) > 1e-9) return "a facet changed its size";
      if (hingeGap(now) > 1e-9 * state.tolerance().sheetSize()) return "the paper was stretched";
    }
  }
  if (end->collisions.size() > state.collisions.size()) return "";
  return joined(orderViolations(*end)) + joined(crossingViolations(*end));
}

TEST(RandomMotions, HaveTheVerdictOfDenseSamplingAndKeepThePaperWhole) {
  Tally tally;
  int motions = 0;
  for (std::uint64_t seed = 1; motions < kMotions; ++seed) {
    Random random(seed);
    Model model = randomSheet(random);
    FoldedState state = startOf(model);
    RandomStepOptions options;
    options.facetLimit = 16;
    options.hasCuts = seed % 4 == 0;
    for (int tries = 0; tries < 60; ++tries) {
      const Step step = randomStep(random, state, options);
      Result<FoldedState> next = apply(state, step, 1);
      if (!next || !next->collisions.empty()) continue;
      model.steps.push_back(step);
      state = std::move(next).value();
      if (state.lines.empty() || !random.chance(0.3)) continue;
      const std::string line = state.lines[random.below(state.lines.size())].name;
      const double amount = std::round(random.between(-180, 180));
      std::string wrong;
      try {
        const LineMotion how = motionTo(state, line, amount);
        if (how.motion.degrees == 0) continue;
        wrong = compare(state, how, tally) + follow(state, line, amount);
      } catch (const std::runtime_error&) {
        continue;
      }
      ++motions;
      ASSERT_EQ(wrong, "") << "seed " << seed << " " << line << " to " << amount << "\n"
                           << textOf(model);
    }
  }
  EXPECT_GT(tally.collides, kMotions / 50);
  EXPECT_GT(tally.free, kMotions / 50);
  EXPECT_LT(tally.undecided, kMotions / 50);
}

}  // namespace
}  // namespace kiri::test
