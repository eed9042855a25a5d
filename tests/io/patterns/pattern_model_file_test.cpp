// Round trips: a state of a model as a FOLD file, read again, is the same state.
// SPDX-License-Identifier: MIT
#include "io/patterns/pattern_model_file.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "core/model/apply.h"
#include "core/model/facet_finder.h"
#include "core/model/replay.h"
#include "io/fold_writer.h"
#include "tests/support/example_files.h"
#include "tests/support/expect.h"
#include "tests/support/model_text.h"
#include "tests/support/random_steps.h"
#include "tests/support/sanitized.h"

namespace kiri::test {
namespace {

constexpr double kSame = 1e-9;

FoldedState endOf(const Model& model) {
  const Result<Replay> replayed = replay(model);
  if (!replayed) throw std::runtime_error(replayed.error().message);
  const auto state = replayed->after(model.steps.size());
  if (!state) throw std::runtime_error(state.error().message);
  return **state;
}

/// The angle of the hinge that holds a place of the sheet; none when no hinge does.
std::optional<double> angleAt(const CreasePattern& pattern, Vec2 p) {
  for (std::size_t e = 0; e < pattern.edges.size(); ++e) {
    if (pattern.edges[e].kind != EdgeKind::Hinge) continue;
    if (nearestOn(arcOf(pattern, EdgeId(e)), p).distance <= kSame * 100)
      return pattern.edges[e].angle;
  }
  return std::nullopt;
}

/// Every folded hinge of `a` has its place, ends and angle in `b`.
testing::AssertionResult hasHingesOf(const FoldedState& b, const FoldedState& a) {
  for (const Edge& edge : a.pattern.edges) {
    if (edge.kind != EdgeKind::Hinge || edge.angle == 0) continue;
    const Vec2 from = a.pattern[edge.from];
    const Vec2 to = a.pattern[edge.to];
    for (const double part : {0.25, 0.5, 0.75}) {
      const std::optional<double> angle = angleAt(b.pattern, lerp(from, to, part));
      if (!angle || std::abs(*angle - edge.angle) > kSame) {
        return testing::AssertionFailure()
               << "the crease from " << from.x << "," << from.y << " to " << to.x << "," << to.y
               << " of " << edge.angle << " degrees has " << angle.value_or(HUGE_VAL);
      }
    }
    for (const Vec2 end : {from, to}) {
      const bool isThere = std::any_of(
          b.pattern.vertices.begin(), b.pattern.vertices.end(),
          [&](Vec2 v) { return distance(v, end) <= kSame * a.tolerance().sheetSize(); });
      if (!isThere) return testing::AssertionFailure() << "no vertex " << end.x << "," << end.y;
    }
  }
  return testing::AssertionSuccess();
}

/// Whatever lies on each other in `b` does so in the same order in `a`.
testing::AssertionResult hasOrderOf(const FoldedState& b, const FoldedState& a) {
  const FacetFinder finder(a.pattern);
  for (const DrawnOrder& order : drawnOrdersOf(b)) {
    const std::optional<FacetId> upper = finder.at(order.upper);
    const std::optional<FacetId> lower = finder.at(order.lower);
    if (!upper || !lower) return testing::AssertionFailure() << "paper that was not there";
    if (*upper == *lower) continue;
    if (!a.layers.areCoplanar(*upper, *lower))
      return testing::AssertionFailure() << "facets that lay in different planes";
    const Vec3 up = a.layers.sets()[a.layers.setOf(*lower)].normal;
    const bool isUp = dot(up, a.poseOf(*lower).normal()) > 0;
    if (a.layers.isAbove(*upper, *lower) != (isUp == order.isFront)) {
      return testing::AssertionFailure()
             << "the facets at " << order.upper.x << "," << order.upper.y << " and "
             << order.lower.x << "," << order.lower.y << " have changed their order";
    }
  }
  return testing::AssertionSuccess();
}

/// What a FOLD file of the state is as a model again.
Result<PatternModel> throughFold(const FoldedState& state) {
  const Exported file = writeFold(state, {}, {});
  const Result<PatternFile> read = readPattern(file.text, "a.fold");
  if (!read) return read.error();
  return modelOfFile(*read);
}

void expectRoundTrip(const FoldedState& state, const std::string& name) {
  SCOPED_TRACE(name);
  const Result<PatternModel> again = throughFold(state);
  ASSERT_TRUE(again.isOk()) << again.error().message;
  for (const std::string& note : again->notes) {
    EXPECT_EQ(note.find("the model is flat"), std::string::npos) << note;
    EXPECT_EQ(note.find("was not taken"), std::string::npos) << note;
  }
  const FoldedState end = endOf(again->model);
  EXPECT_TRUE(hasHingesOf(end, state));
  EXPECT_TRUE(hasHingesOf(state, end));
  if (pieceCount(state) == 1) EXPECT_TRUE(hasOrderOf(end, state));
}

TEST(PatternRoundTrip, EveryExampleComesBackFromFold) {
  ASSERT_GE(exampleFiles().size(), 10u);
  for (const std::filesystem::path& path : exampleFilesThatTakeLong()) {
    const Model model = modelInFile(path);
    const Result<Replay> replayed = replay(model);
    ASSERT_TRUE(replayed.isOk());
    for (std::size_t i = 0; i < model.steps.size(); ++i) {
      const FoldedState& state = *replayed->outcomes[i].state;
      const bool hasCurves = !state.pattern.curves.empty();
      if (hasCurves || pieceCount(state) > 1 || !state.collisions.empty()) continue;
      expectRoundTrip(state, path.filename().string() + " after step " + std::to_string(i + 1));
    }
  }
}

TEST(PatternRoundTrip, RandomStepsComeBackFromFold) {
  RandomStepOptions options;
  options.hasCuts = false;
  options.hasTears = false;
  std::size_t states = 0;
  for (std::uint64_t seed = 1; seed <= casesOf<std::uint64_t>(8, 2); ++seed) {
    Random random(seed);
    const Model sheet = randomSheet(random);
    FoldedState state = startOf(sheet);
    if (!state.pattern.curves.empty()) continue;
    for (int tries = 0; tries < 30; ++tries) {
      const Step step = randomStep(random, state, options);
      Result<FoldedState> next = apply(state, step, tries + 1);
      if (!next || !next->collisions.empty()) continue;
      state = std::move(*next);
      if (state.lines.empty()) continue;
      expectRoundTrip(state, "seed " + std::to_string(seed) + ", try " + std::to_string(tries));
      ++states;
      if (testing::Test::HasFailure()) return;
    }
  }
  EXPECT_GT(states, casesOf(20u, 5u));
}

TEST(PatternModelFile, AUnitWithoutASizeIsGuessedAndTold) {
  PatternFile file;
  const double sides[][4] = {{0, 0, 1, 0}, {1, 0, 1, 1}, {1, 1, 0, 1}, {0, 1, 0, 0}};
  for (const auto& s : sides)
    file.drawing.lines.push_back({{s[0], s[1]}, {s[2], s[3]}, Assignment::Border, std::nullopt});
  file.drawing.lines.push_back({{0, 0}, {1, 1}, Assignment::Valley, std::nullopt});
  const Result<PatternModel> guessed = modelOfFile(file);
  ASSERT_TRUE(guessed.isOk()) << guessed.error().message;
  EXPECT_EQ(guessed->model.sheet.width, 150);
  ASSERT_EQ(guessed->notes.size(), 1u);
  EXPECT_NE(guessed->notes[0].find("150 mm"), std::string::npos);
  file.mmPerUnit = 25.4;
  const Result<PatternModel> told = modelOfFile(file);
  EXPECT_EQ(told->model.sheet.width, 25.4);
  EXPECT_TRUE(told->notes.empty());
}

TEST(PatternModelFile, AStateHasItsAnglesAndOrdersInTheFile) {
  const Model model = modelOf(
      "square 100; fold A valley 50,0 50,100 left; fold B valley 120 "
      "@model 40,50 110,50 left; unfold B");
  const PatternFile lying = patternFileOf(endOf(model), model);
  EXPECT_EQ(lying.mmPerUnit, 1);
  EXPECT_FALSE(lying.drawing.orders.empty());
  const auto count = [](const PatternFile& file, Assignment a) {
    return std::count_if(file.drawing.lines.begin(), file.drawing.lines.end(),
                         [a](const DrawnCrease& line) { return line.assignment == a; });
  };
  EXPECT_EQ(count(lying, Assignment::Flat), 2);
  const PatternFile asItLies = patternFileOf(endOf(model), model, true);
  EXPECT_EQ(count(asItLies, Assignment::Flat), 2) << "B is open, and the rest is folded without it";
  EXPECT_FALSE(asItLies.drawing.orders.empty());
  const PatternFile folded = patternFileOf(after(endOf(model), "unfold A"), model, true);
  EXPECT_EQ(count(folded, Assignment::Flat), 0);
  EXPECT_TRUE(folded.drawing.orders.empty());
}

}  // namespace
}  // namespace kiri::test
