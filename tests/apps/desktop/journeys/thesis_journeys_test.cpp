// The figures of chapter 4 of the thesis, made with mouse and keyboard.
// SPDX-License-Identifier: MIT
#include <algorithm>

#include "core/paper/crease_pattern.h"
#include "editor/tools/layer_picker.h"
#include "tests/apps/desktop/journeys/journey.h"

namespace kiri::desktop {
namespace {

bool hasMark(const Marks& marks, MarkRole role) {
  return std::any_of(marks.begin(), marks.end(), [role](const Mark& mark) {
    if (const auto* path = std::get_if<PathMark>(&mark)) return path->role == role;
    if (const auto* point = std::get_if<PointMark>(&mark)) return point->role == role;
    return false;
  });
}

TEST_F(Journey, AShipIsFoldedWithATear) {  // Figure 4.4
  fresh(100);
  take(ToolId::Fold);
  drag(Pane::Model, {0, 100}, {100, 0});
  press(Key::Enter);
  ASSERT_EQ(count(), 1u) << session().notice().why;
  type(Qt::Key_U, Qt::ControlModifier);
  ASSERT_EQ(count(), 2u);
  take(ToolId::Tear);
  drag(Pane::Model, {0, 0}, {39.6, 39.6});
  press(Key::Enter);
  ASSERT_EQ(count(), 3u) << session().notice().why;
  ASSERT_TRUE(test::foldOnSheet(*this, {39.598, 39.598}, {0, 25.9633}, 'v', {1, 3}))
      << session().notice().why;
  ASSERT_TRUE(test::foldOnSheet(*this, {39.598, 39.598}, {25.9633, 0}, 'v', {3, 1}))
      << session().notice().why;
  type(Qt::Key_U, Qt::ControlModifier | Qt::ShiftModifier);
  ASSERT_EQ(count(), 6u) << session().notice().why;
  const FoldedState& ship = *session().document().state();
  EXPECT_TRUE(isFlat(ship));
  EXPECT_EQ(ship.pattern.facets.size(), 4u);
  EXPECT_EQ(piecesOf(ship.pattern), std::vector<std::uint32_t>(ship.pattern.facets.size(), 0));
  EXPECT_NEAR(areaOf(ship.pattern), 10000, 1e-6);
  EXPECT_LT(differenceFromExactPicture(), 0.02);
  picture("journey-ship");
}

TEST_F(Journey, AFoldACutAndAFoldFollowEachOther) {  // Figure 4.5
  fresh(100);
  ASSERT_TRUE(test::foldOnSheet(*this, {60, 0}, {60, 100}, 'v', {80, 50}));
  take(ToolId::StraightCut);
  drag(Pane::Model, {-20, 70}, {60, 40});
  click(Pane::Model, {30, 90});  // what stays is the other part
  press(Key::Enter);
  ASSERT_EQ(count(), 2u) << session().notice().why;
  const double left = areaOf(session().document().state()->pattern);
  EXPECT_LT(left, 10000);
  take(ToolId::Line);
  drag(Pane::Model, {10, 0}, {55, 41.875});
  press(Key::Enter);
  ASSERT_EQ(count(), 3u) << session().notice().why;
  EXPECT_NEAR(areaOf(session().document().state()->pattern), left, 1e-6);
  EXPECT_LT(differenceFromExactPicture(), 0.02);
  picture("journey-fold-cut-fold");
}

TEST_F(Journey, OnlyTheLowerLayerFoldsWithoutUnfolding) {  // Figure 4.3
  fresh(100);
  ASSERT_TRUE(test::foldOnSheet(*this, {30, 0}, {30, 100}, 'v', {10, 50}));
  take(ToolId::Fold);
  drag(Pane::Model, {50, 108}, {50, -8});
  holdControl(true);
  click(Pane::Model, {85, 50});  // Q joins
  click(Pane::Model, {55, 50});  // P leaves
  holdControl(false);
  press('m');
  press(Key::Enter);
  ASSERT_EQ(count(), 2u) << session().notice().why;
  const FoldedState& state = *session().document().state();
  EXPECT_EQ(state.pattern.facets.size(), 3u);
  const Vec3 p = state.poseOf(*facetAt(state.pattern, {10, 50})).apply(Vec2{10, 50});
  EXPECT_NEAR(distance(p, Vec3{50, 50, 0}), 0, 0.5) << "P lies where it lay";
}

TEST_F(Journey, AFoldThatWouldStretchThePaperIsRefusedWithItsReason) {  // Figure 4.2 c, d
  fresh(100);
  ASSERT_TRUE(test::foldOnSheet(*this, {50, 0}, {50, 100}, 'v', {10, 50}));
  take(ToolId::Fold);
  drag(Pane::Model, {40, 30}, {110, 30});
  set("layers", static_cast<double>(LayerMode::Top));
  EXPECT_TRUE(hasMark(session().marks(), MarkRole::Fault)) << "the hinge that fails is drawn";
  press(Key::Enter);
  EXPECT_EQ(count(), 1u);
  EXPECT_EQ(session().notice().kind, Notice::Kind::Refused);
  EXPECT_NE(session().notice().why.find("stretch"), std::string::npos);
  EXPECT_TRUE(session().canCommit()) << "what was drawn is still there";
  picture("journey-stretch");
  set("remedy", 0);
  press(Key::Enter);
  EXPECT_EQ(count(), 2u) << session().notice().why;
}

TEST_F(Journey, PaperThatMeetsPaperIsReportedAndNotForbidden) {  // Figure 4.2 a, b
  fresh(100);
  ASSERT_TRUE(test::foldOnSheet(*this, {50, 0}, {50, 100}, 'v', {10, 50}));
  take(ToolId::Line);
  drag(Pane::Model, {80, -4}, {80, 104});
  set("layers", static_cast<double>(LayerMode::All));
  press(Key::Enter);
  ASSERT_EQ(count(), 2u) << session().notice().why;
  const FoldLineId first = session().sliders().front().line;
  session().beginSlide(first);
  session().slide(0);
  settle();
  ASSERT_TRUE(session().slideShow());
  EXPECT_FALSE(session().slideShow()->collisions.empty());
  EXPECT_TRUE(hasMark(session().marks(), MarkRole::Collision));
  picture("journey-collision");
  session().endSlide(true);
  settle();
  EXPECT_EQ(count(), 3u) << "a warning, not a wall";
  EXPECT_EQ(session().notice().kind, Notice::Kind::Warning);
  EXPECT_FALSE(session().document().state()->collisions.empty());
}

TEST_F(Journey, ARunningFilmLeavesTheModelAsItIs) {  // A13, A14
  open("ship.kiri");
  const auto before = session().shown().state;
  type(Qt::Key_Space);
  ASSERT_TRUE(QTest::qWaitFor([&] { return session().isPlayerOpen(); }, 30000));
  ASSERT_TRUE(QTest::qWaitFor([&] { return session().player().seconds() > 0.5; }, 30000));
  EXPECT_NE(session().shown().state, before);
  type(Qt::Key_Escape);
  EXPECT_FALSE(session().isPlayerOpen());
  EXPECT_EQ(session().shown().state, before);
  EXPECT_FALSE(window->isWindowModified());
}

TEST_F(Journey, AnEarlierNumberIsChangedAndTheRestFollows) {
  fresh(100);
  ASSERT_TRUE(test::foldOnSheet(*this, {50, 0}, {50, 100}, 'v', {10, 50}));
  ASSERT_TRUE(test::foldOnSheet(*this, {50, 60}, {100, 60}, 'v', {75, 90}));
  Step first = session().document().model().steps.front();
  std::get<FoldStep>(first.action).angle = 90;
  session().change(editStep(0, first), {});
  settle();
  EXPECT_EQ(count(), 2u);
  EXPECT_FALSE(isFlat(*session().document().stateAfter(1)));
  type(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_TRUE(isFlat(*session().document().stateAfter(1))) << "undo takes back the edit";
}

}  // namespace
}  // namespace kiri::desktop
