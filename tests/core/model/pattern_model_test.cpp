// Crease patterns as models: the sheet, the creases, the folded state and the way there.
// SPDX-License-Identifier: MIT
#include "core/model/pattern_model.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/creases/repair.h"
#include "core/model/apply.h"
#include "core/model/replay.h"
#include "core/model/timeline.h"
#include "tests/support/expect.h"
#include "tests/support/model_text.h"
#include "tests/support/order_check.h"
#include "tests/support/pattern_text.h"
#include "tests/support/state_check.h"

namespace kiri::test {
namespace {

AssignedPattern withAngles(FoldedState flat, const std::vector<double>& angles) {
  for (std::size_t e = 0; e < angles.size(); ++e) {
    if (flat.pattern.edges[e].kind == EdgeKind::Hinge) flat.pattern.edges[e].angle = angles[e];
  }
  return assignedPatternOf(flat);
}

AssignedPattern miura(int columns, int rows) {
  const Corrugation sheet = corrugationOf(columns, rows, 60);
  return withAngles(sheet.state, sheet.folded);
}

/// A square of 100 mm with creases from its middle to corners and middles of sides, the first to
/// the right, then counter-clockwise.
AssignedPattern eightRays(const std::vector<double>& angles) {
  const std::vector<Vec2> rim{{100, 50}, {100, 100}, {50, 100}, {0, 100},
                              {0, 50},   {0, 0},     {50, 0},   {100, 0}};
  std::vector<Vec2> vertices{{50, 50}};
  std::vector<DrawnEdge> edges;
  for (std::size_t i = 0; i < rim.size(); ++i) {
    vertices.push_back(rim[i]);
    edges.push_back({0, i + 1});
  }
  for (std::size_t i = 0; i < rim.size(); ++i)
    edges.push_back({i + 1, (i + 1) % rim.size() + 1, EdgeKind::Border});
  std::vector<double> all = angles;
  all.resize(edges.size(), 0);
  return withAngles(drawnState(vertices, edges), all);
}

/// Mountains along the middles, two valleys on a diagonal: the preliminary base is that turned
/// over. Flat folding needs six creases.
AssignedPattern squareBase() { return eightRays({-180, 180, -180, 0, -180, 180, -180, 0}); }
AssignedPattern waterbombBase() { return eightRays({-180, 180, 0, 180, -180, 180, 0, 180}); }

PatternModel made(const AssignedPattern& creases, const PatternModelOptions& options = {}) {
  Result<PatternModel> model = modelOf(creases, options);
  if (!model) throw std::runtime_error(model.error().message);
  return std::move(*model);
}

FoldedState lastOf(const Model& model) {
  const Result<Replay> replayed = replay(model);
  if (!replayed) throw std::runtime_error(replayed.error().message);
  const auto state = replayed->after(model.steps.size());
  if (!state) throw std::runtime_error(state.error().message);
  return **state;
}

const PatternStep& patternStepOf(const Model& model) {
  return std::get<PatternStep>(model.steps.front().action);
}

class FlatModels : public testing::TestWithParam<int> {};

AssignedPattern sample(int number) {
  switch (number) {
    case 0:
      return miura(2, 2);
    case 1:
      return miura(6, 5);
    case 2:
      return squareBase();
    default:
      return waterbombBase();
  }
}

TEST_P(FlatModels, FoldFlatWithoutAFault) {
  const AssignedPattern creases = sample(GetParam());
  const PatternModel model = made(creases);
  const FoldedState state = lastOf(model.model);
  EXPECT_TRUE(isClean(state));
  EXPECT_TRUE(isFlat(state));
  EXPECT_TRUE(orderViolations(state).empty()) << joined(orderViolations(state));
  EXPECT_EQ(facetCount(state), creases.pattern.facets.size());
  EXPECT_NEAR(areaOf(state), areaOf(creases.pattern), 1e-6);
}

TEST_P(FlatModels, KeepVerticesAnglesAndCreases) {
  const AssignedPattern creases = sample(GetParam());
  const FoldedState state = lastOf(made(creases).model);
  for (std::size_t e = 0; e < creases.pattern.edges.size(); ++e) {
    const Edge& wanted = creases.pattern.edges[e];
    if (wanted.kind != EdgeKind::Hinge) continue;
    const Vec2 a = creases.pattern[wanted.from];
    const Vec2 b = creases.pattern[wanted.to];
    const auto there =
        std::find_if(state.pattern.edges.begin(), state.pattern.edges.end(), [&](const Edge& edge) {
          return state.pattern[edge.from] == a && state.pattern[edge.to] == b;
        });
    ASSERT_NE(there, state.pattern.edges.end()) << e;
    EXPECT_EQ(there->kind, EdgeKind::Hinge);
    EXPECT_EQ(there->angle, wanted.angle);
  }
}

TEST_P(FlatModels, FoldRigidlyAndSayNothingOfBending) {
  const PatternModel model = made(sample(GetParam()));
  ASSERT_TRUE(model.way.has_value());
  EXPECT_EQ(*model.way, PatternWay::Rigid);
  EXPECT_TRUE(model.notes.empty()) << model.notes.front();
  const Result<Timeline> time = Timeline::of(model.model);
  ASSERT_TRUE(time.isOk());
  ASSERT_EQ(time->movementsOf(0).size(), 1u);
  const FoldedState half = *stateBetween(model.model, 0.5);
  EXPECT_FALSE(isFlat(half));
  EXPECT_TRUE(isSound(half));
}

INSTANTIATE_TEST_SUITE_P(Samples, FlatModels, testing::Values(0, 1, 2, 3));

/// A map of columns x rows squares, every crease unassigned.
AssignedPattern mapOf(int columns, int rows) {
  const auto corner = [&](int c, int r) { return static_cast<std::size_t>(r * (columns + 1) + c); };
  std::vector<Vec2> vertices;
  std::vector<DrawnEdge> edges;
  for (int r = 0; r <= rows; ++r) {
    for (int c = 0; c <= columns; ++c) {
      vertices.push_back({c * 20.0, r * 20.0});
      const auto kind = [](bool isRim) { return isRim ? EdgeKind::Border : EdgeKind::Hinge; };
      if (c > 0) edges.push_back({corner(c - 1, r), corner(c, r), kind(r == 0 || r == rows), 180});
      if (r > 0)
        edges.push_back({corner(c, r - 1), corner(c, r), kind(c == 0 || c == columns), 180});
    }
  }
  AssignedPattern map = assignedPatternOf(drawnState(vertices, edges));
  for (Assignment& a : map.assignments) {
    if (a == Assignment::Valley) a = Assignment::Unassigned;
  }
  return map;
}

TEST(PatternModel, CreasesThatNobodyAssignedAreSolvedFor) {
  const PatternModel model = made(mapOf(4, 3));
  const FoldedState state = lastOf(model.model);
  EXPECT_TRUE(isClean(state));
  EXPECT_TRUE(orderViolations(state).empty()) << joined(orderViolations(state));
  EXPECT_EQ(patternStepOf(model.model).creases[0].assignment, Assignment::Unassigned);
}

TEST(PatternModel, AMapIsFoldedLineByLine) {
  const PatternModel model = made(mapOf(2, 2));
  ASSERT_TRUE(model.way.has_value());
  EXPECT_EQ(*model.way, PatternWay::OneByOne);
  EXPECT_TRUE(model.notes.empty()) << model.notes.front();
  const Timeline time = *Timeline::of(model.model);
  ASSERT_EQ(time.movementsOf(0).size(), 2u);
  EXPECT_TRUE(haveSameOrder(stateDuring(time.movementsOf(0).back(), 1), lastOf(model.model)));
  EXPECT_TRUE(isClean(*stateBetween(model.model, 0.25)));
}

TEST(PatternModel, WherePaperMustBendItIsSaid) {
  // The rabbit ears of a bird base hold each other: its facets are rigid flat and folded only.
  const double r = 50 * (std::sqrt(2.0) - 1);
  const std::vector<Vec2> v{{50, 50},      {0, 0},        {100, 0},  {100, 100}, {0, 100},
                            {50, 0},       {100, 50},     {50, 100}, {0, 50},    {50, r},
                            {100 - r, 50}, {50, 100 - r}, {r, 50}};
  std::vector<DrawnEdge> edges;
  for (std::size_t i = 0; i < 4; ++i) {
    const std::size_t next = (i + 1) % 4;
    edges.push_back({1 + i, 5 + i, EdgeKind::Border});
    edges.push_back({5 + i, 1 + next, EdgeKind::Border});
    for (const std::size_t from : {std::size_t{0}, 1 + i, 1 + next, 5 + i})
      edges.push_back({from, 9 + i, EdgeKind::Hinge, 180});
    edges.push_back({0, 1 + i, EdgeKind::Hinge, 180});
  }
  AssignedPattern creases = assignedPatternOf(drawnState(v, edges));
  for (Assignment& a : creases.assignments) {
    if (a == Assignment::Valley) a = Assignment::Unassigned;
  }
  const PatternModel model = made(creases);
  EXPECT_TRUE(isClean(lastOf(model.model)));
  ASSERT_TRUE(model.way.has_value());
  EXPECT_EQ(*model.way, PatternWay::MustBend);
  ASSERT_EQ(model.notes.size(), 1u);
  EXPECT_EQ(model.notes[0].rfind("the paper must bend", 0), 0u);
  EXPECT_EQ(model.model.steps[0].notes, model.notes[0]);
  EXPECT_TRUE(Timeline::of(model.model)->movementsOf(0).empty());
}

TEST(PatternModel, AWrongOrderIsACollisionNotARefusal) {
  PatternModel model = made(miura(3, 3));
  PatternStep& step = std::get<PatternStep>(model.model.steps[0].action);
  std::swap(step.layers[0], step.layers[4]);
  const FoldedState state = lastOf(model.model);
  ASSERT_EQ(state.collisions.size(), 1u);
  EXPECT_EQ(state.collisions[0].step, 1u);
  EXPECT_EQ(state.collisions[0].moment, CollisionMoment::End);
}

TEST(PatternModel, LayersThatNameNoFacetAreRefusedWithAPlace) {
  PatternModel model = made(miura(2, 2));
  const FoldedState sheet = *replay(model.model)->start;
  Step step = model.model.steps[0];
  PatternStep& pattern = std::get<PatternStep>(step.action);
  const PatternStep good = pattern;
  pattern.layers.pop_back();
  EXPECT_TRUE(failsWith(apply(sheet, step, 1), ErrorCode::NotFound, "leave out the facet at"));
  pattern.layers.push_back(pattern.layers.front());
  EXPECT_TRUE(failsWith(apply(sheet, step, 1), ErrorCode::BadValue, "twice"));
  pattern.layers.back() = {-500, 0};
  EXPECT_TRUE(failsWith(apply(sheet, step, 1), ErrorCode::NotFound, "no paper"));
  pattern = good;
  pattern.resting = Vec2{-500, 0};
  EXPECT_TRUE(failsWith(apply(sheet, step, 1), ErrorCode::NotFound, "the facet that rests"));
}

TEST(PatternModel, OpensWithTheLayersThatWereFound) {
  const PatternModel model = made(miura(4, 4));
  EXPECT_EQ(patternStepOf(model.model).layers.size(), 16u);
  EXPECT_EQ(model.model.opening, Sequence::Together);
  EXPECT_TRUE(isSameState(lastOf(model.model), lastOf(model.model)));
}

TEST(PatternModel, ASquareAtTheOriginIsASquareSheet) {
  const PatternModel model = made(squareBase());
  EXPECT_EQ(model.model.sheet.shape, SheetSpec::Shape::Square);
  EXPECT_EQ(model.model.sheet.width, 100);
  EXPECT_EQ(made(miura(2, 2)).model.sheet.shape, SheetSpec::Shape::Polygon);
}

TEST(PatternModel, IsScaledToTheLongestSide) {
  PatternModelOptions options;
  options.longestSide = 25;
  const PatternModel model = made(squareBase(), options);
  EXPECT_EQ(model.model.sheet.width, 25);
  EXPECT_TRUE(isClean(lastOf(model.model)));
}

TEST(PatternModel, StaysFlatWhereItCannotFoldAndSaysWhy) {
  const AssignedPattern creases = eightRays({-180, 180, -180, 0, -180, 180, 0, 0});
  const PatternModel model = made(creases);
  EXPECT_FALSE(patternStepOf(model.model).isFolded);
  ASSERT_EQ(model.notes.size(), 1u);
  EXPECT_EQ(model.notes[0].rfind("the model is flat, with its creases: ", 0), 0u);
  const FoldedState state = lastOf(model.model);
  EXPECT_TRUE(isClean(state));
  EXPECT_EQ(state.lines.size(), 3u);
}

std::vector<Assignment> foldedCreases(const FoldedState& state) {
  const AssignedPattern creases = assignedPatternOf(state, true);
  std::vector<Assignment> folded;
  for (std::size_t e = 0; e < creases.assignments.size(); ++e) {
    if (creases.pattern.edges[e].kind == EdgeKind::Hinge) folded.push_back(creases.assignments[e]);
  }
  std::sort(folded.begin(), folded.end());
  return folded;
}

TEST(AsFolded, GivesTheCreasesOfAnOpenModelTheAnglesTheyHad) {
  const FoldedState open = run("square 100; fold a mountain 120 50,0 50,100 left; unfold all");
  const FoldedState folded = asFolded(open);
  for (const Edge& edge : folded.pattern.edges) {
    if (edge.kind == EdgeKind::Hinge) EXPECT_EQ(edge.angle, -120);
  }
  const FoldedState ajar =
      run("square 100; fold a mountain 120 50,0 50,100 left; unfold all;"
          "fold b valley 20 0,50 100,50 left");
  EXPECT_EQ(foldedCreases(ajar),
            (std::vector<Assignment>{Assignment::Mountain, Assignment::Mountain, Assignment::Valley,
                                     Assignment::Valley}));
}

TEST(AsFolded, LeavesCreasesThatOnlyHelpedOnTheWayToAFoldedModelFlat) {
  const FoldedState folded =
      run("square 100; fold guide valley 50,0 50,100 left; unfold guide;"
          "fold half valley 0,50 100,50 left");
  EXPECT_EQ(foldedCreases(folded), (std::vector<Assignment>{Assignment::Valley, Assignment::Valley,
                                                            Assignment::Flat, Assignment::Flat}));
}

TEST(DrawingOf, FacetsWithCurvedEdgesNeedsNoRepair) {
  // Either half has the curve as a border; one of them runs along it backwards.
  const FoldedState cut =
      run("square 100; fold half valley 50,0 50,100 left;"
          "curve @model 40,80 60,95 80,60 110,40 keep m:55,5; unfold all");
  ASSERT_FALSE(cut.pattern.curves.empty());
  const Result<RepairedPattern> pattern = patternOf(drawingOf(assignedPatternOf(cut)));
  ASSERT_TRUE(pattern) << pattern.error().message;
  for (const Repair& repair : pattern->repairs) ADD_FAILURE() << repair.message;
  EXPECT_EQ(pattern->creases.pattern.facets.size(), cut.pattern.facets.size());
}

TEST(PatternModel, PartlyFoldedPatternsKeepTheirAngles) {
  const Corrugation sheet = corrugationOf(3, 3, 60);
  PatternModel rigid = made(withAngles(sheet.state, sheet.folded));
  const FoldedState half = *stateBetween(rigid.model, 0.5);
  const PatternModel again = made(assignedPatternOf(half));
  const FoldedState state = lastOf(again.model);
  EXPECT_TRUE(isSound(state));
  EXPECT_FALSE(isFlat(state));
  EXPECT_TRUE(again.notes.empty()) << again.notes.front();
}

TEST(PatternModel, UnfoldsAndFoldsAgain) {
  const FoldedState state = lastOf(made(miura(4, 3)).model);
  const Result<FoldedState> open =
      apply(state, Step{UnfoldStep{{}, Sequence::Together}, "", "", ""}, 2);
  ASSERT_TRUE(open.isOk()) << open.error().message;
  EXPECT_TRUE(isClean(*open));
  const Result<FoldedState> again =
      apply(*open, Step{RefoldStep{{}, Sequence::Together}, "", "", ""}, 3);
  ASSERT_TRUE(again.isOk()) << again.error().message;
  EXPECT_TRUE(isClean(*again));
  EXPECT_TRUE(isFlat(*again));
}

TEST(PatternModel, OrdersOfAFileAreTaken) {
  const AssignedPattern creases = miura(4, 3);
  const FoldedState state = lastOf(made(creases).model);
  PatternModelOptions options;
  options.orders = drawnOrdersOf(state);
  const PatternModel again = made(creases, options);
  EXPECT_TRUE(again.notes.empty()) << again.notes.front();
  EXPECT_TRUE(haveSameOrder(lastOf(again.model), state));
}

TEST(PatternModel, TakesTheLargestOfSeveralPieces) {
  const std::vector<Vec2> v{{0, 0},  {10, 0}, {20, 0},  {20, 10}, {10, 10}, {0, 10},
                            {30, 0}, {35, 0}, {35, 10}, {30, 10}, {20, 5}};
  // Two squares with a crease between them, and a slip of paper that hangs on by nothing.
  AssignedPattern creases = assignedPatternOf(drawnState(v, {{0, 1, EdgeKind::Border},
                                                             {1, 2, EdgeKind::Border},
                                                             {2, 10, EdgeKind::Border},
                                                             {10, 3, EdgeKind::Border},
                                                             {3, 4, EdgeKind::Border},
                                                             {4, 5, EdgeKind::Border},
                                                             {5, 0, EdgeKind::Border},
                                                             {1, 4, EdgeKind::Hinge, 180},
                                                             {10, 6},
                                                             {6, 7, EdgeKind::Border},
                                                             {7, 8, EdgeKind::Border},
                                                             {8, 9, EdgeKind::Border},
                                                             {9, 6, EdgeKind::Border}}));
  const PatternModel model = made(creases);
  ASSERT_FALSE(model.notes.empty());
  EXPECT_NE(model.notes[0].find("2 pieces"), std::string::npos) << model.notes[0];
  EXPECT_EQ(facetCount(lastOf(model.model)), 2u);
}

}  // namespace
}  // namespace kiri::test
