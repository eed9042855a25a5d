// The fold tool, driven by events: grab, draw, layers, sides, what stays and what is dropped.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>

#include "core/model/apply.h"
#include "core/model/locate.h"
#include "editor/tools/layer_picker.h"
#include "tests/editor/tools/tool_driver.h"
#include "tests/support/model_text.h"
#include "tests/support/random_steps.h"
#include "tests/support/state_check.h"

namespace kiri::test {
namespace {

/// Where a place of the sheet lies.
Vec3 imageOf(const FoldedState& state, Vec2 paper) {
  return state.poseOf(*facetAt(state.pattern, paper)).apply(paper);
}

#define EXPECT_AT(point, X, Y, Z) \
  do {                            \
    const Vec3 seen = point;      \
    EXPECT_NEAR(seen.x, X, 1e-6); \
    EXPECT_NEAR(seen.y, Y, 1e-6); \
    EXPECT_NEAR(seen.z, Z, 1e-6); \
  } while (false)

const char* const kHalved = "square 100; fold valley 50,0 50,100 to 10,50";

TEST(FoldTool, DraggingACornerOntoAnotherFoldsTheDiagonal) {
  ToolDriver hand(ToolId::Fold, "square 100");
  hand.drag({1, 1}, {99, 99});
  ASSERT_TRUE(hand.proposal()->isComplete);
  EXPECT_TRUE(hand.key(Key::Enter).wantsCommit);
  const FoldedState& state = hand.state();
  ASSERT_EQ(state.pattern.facets.size(), 2U);
  EXPECT_AT(imageOf(state, {0, 0}), 100, 100, 0);
  EXPECT_AT(imageOf(state, {100, 0}), 100, 0, 0);
  EXPECT_AT(imageOf(state, {100, 100}), 100, 100, 0);
  EXPECT_TRUE(state.lines.front().isValley);
  EXPECT_FALSE(hand.tool().isBusy());
}

TEST(FoldTool, TheGrabbedPlaceComesToLieUnderThePointer) {
  Random random(7);
  for (int i = 0; i < 40; ++i) {
    ToolDriver hand(ToolId::Fold, "square 100");
    hand.snaps.isOn = false;
    const Vec2 from{random.between(2, 98), random.between(2, 98)};
    const Vec2 to{random.between(-30, 130), random.between(-30, 130)};
    hand.drag(from, to);
    if (!hand.proposal()) continue;  // hardly moved
    const auto after = hand.result();
    if (!after) {
      EXPECT_EQ(after.error().code, ErrorCode::TooThin);
      continue;
    }
    EXPECT_AT(imageOf(*after, from), to.x, to.y, 0);
    EXPECT_LE(stretchOf(*after), after->tolerance().match());
  }
}

TEST(FoldTool, DraggingAnEdgeOntoTheOppositeEdgeFoldsInHalf) {
  ToolDriver hand(ToolId::Fold, "square 100");
  hand.drag({0.5, 50}, {99.5, 50});
  const auto after = hand.result();
  ASSERT_TRUE(after) << after.error().message;
  EXPECT_AT(imageOf(*after, {0, 0}), 100, 0, 0);
  EXPECT_AT(imageOf(*after, {0, 100}), 100, 100, 0);
}

TEST(FoldTool, AnEdgeDraggedToANeighbourIsLaidAlongIt) {
  ToolDriver hand(ToolId::Fold, "square 100");
  hand.snaps.toMidpoints = false;
  hand.drag({0.5, 31}, {31.6, 0.5});
  const auto after = hand.result();
  ASSERT_TRUE(after) << after.error().message;
  EXPECT_AT(imageOf(*after, {0, 100}), 100, 0, 0);
  EXPECT_AT(imageOf(*after, {0, 60}), 60, 0, 0);
}

TEST(FoldTool, FromBehindAValleyStillComesTowardsTheEye) {
  ToolDriver hand(ToolId::Fold, "square 100");
  hand.look(Camera::Preset::Back);
  hand.drag({1, 1}, {99, 99});
  EXPECT_EQ(hand.field("type").value, 0);
  EXPECT_EQ(std::get<FoldStep>(hand.step().action).type, FoldType::Mountain);
  hand.set("angle", 90);
  const auto after = hand.result();
  ASSERT_TRUE(after);
  EXPECT_LT(imageOf(*after, {0, 0}).z, -60);
  hand.key('m');
  EXPECT_EQ(hand.field("type").value, 1);
  EXPECT_GT(imageOf(*hand.result(), {0, 0}).z, 60);
}

TEST(FoldTool, WalkingRoundTheModelDoesNotChangeTheFoldThatIsOffered) {
  ToolDriver hand(ToolId::Fold, "square 100");
  hand.drag({1, 1}, {99, 99});
  const std::string before = textOf(hand.step());
  hand.look(Camera::Preset::Back);
  EXPECT_EQ(textOf(hand.step()), before);
  EXPECT_EQ(hand.field("type").value, 1);  // what was a valley is seen from behind
}

TEST(FoldTool, ZoomAndOrbitDoNotChangeWhatIsMeant) {
  const auto folded = [](double zoom, double right, double up, Vec2 pan) {
    ToolDriver hand(ToolId::Fold, kHalved);
    hand.camera.turn(right, up);
    hand.camera.zoom({400, 300}, zoom);
    hand.camera.pan(pan);
    hand.drag({99.5, 0.5}, {50.5, 50});
    return textOf(hand.step());
  };
  const std::string plain = folded(1, 0, 0, {0, 0});
  EXPECT_EQ(folded(1.7, 0, 0, {30, -20}), plain);
  EXPECT_EQ(folded(1, 20, 30, {0, 0}), plain);
  EXPECT_EQ(folded(0.8, -35, 10, {-40, 10}), plain);
}

TEST(FoldTool, TheHandTakesTheTopFlapAlone) {
  ToolDriver hand(ToolId::Fold, kHalved);
  hand.drag({99.5, 0.5}, {75, 25});  // the free corner of the left half, which lies on top
  const auto after = hand.result();
  ASSERT_TRUE(after) << after.error().message;
  EXPECT_EQ(after->pattern.facets.size(), 3U);
  EXPECT_AT(imageOf(*after, {0, 0}), 75, 25, 0);
  EXPECT_AT(imageOf(*after, {100, 0}), 100, 0, 0);  // the lower layer rests
}

TEST(FoldTool, FromBehindTheTopFlapIsTheOneThatIsSeen) {
  ToolDriver hand(ToolId::Fold, kHalved);
  hand.look(Camera::Preset::Back);
  hand.drag({99.5, 0.5}, {75, 25});
  const auto after = hand.result();
  ASSERT_TRUE(after) << after.error().message;
  EXPECT_EQ(after->pattern.facets.size(), 3U);
  EXPECT_AT(imageOf(*after, {100, 0}), 75, 25, 0);
  EXPECT_AT(imageOf(*after, {0, 0}), 100, 0, 0);
}

TEST(FoldTool, PaperJoinedAcrossTheLineComesAlong) {
  ToolDriver hand(ToolId::Fold, kHalved);
  hand.drag({50.5, 0.5}, {75, 25});  // the corner at the fold: both halves hang together there
  const auto after = hand.result();
  ASSERT_TRUE(after) << after.error().message;
  EXPECT_EQ(after->pattern.facets.size(), 4U);
  EXPECT_AT(imageOf(*after, {50, 0}), 75, 25, 0);
  EXPECT_FALSE(hand.hasField("remedy"));
}

TEST(FoldTool, ShiftTakesAllLayersAndAltTheTopOne) {
  ToolDriver hand(ToolId::Fold, kHalved);
  hand.held.shift = true;
  hand.drag({99.5, 0.5}, {75, 25});
  EXPECT_EQ(hand.field("layers").value, static_cast<double>(LayerMode::All));
  EXPECT_EQ(hand.result()->pattern.facets.size(), 4U);
  hand.key(Key::Escape);
  hand.held = {};
  hand.held.alt = true;
  hand.drag({99.5, 0.5}, {75, 25});
  EXPECT_EQ(hand.field("layers").value, static_cast<double>(LayerMode::Top));
  EXPECT_EQ(hand.result()->pattern.facets.size(), 3U);
}

TEST(FoldTool, TheWheelWalksThroughTheLayers) {
  ToolDriver hand(ToolId::Fold,
                  "square 100; fold valley 50,0 50,100 to 10,50; "
                  "fold valley @model 50,50 100,50 to m:75,20");
  hand.drag({99.5, 50.5}, {80, 70});  // open corner of four layers
  hand.held.control = true;
  std::vector<std::size_t> counts = {hand.result()->pattern.facets.size()};
  for (int i = 0; i < 4; ++i) {
    hand.wheel({90, 60}, 1);
    const auto after = hand.result();
    if (after) counts.push_back(after->pattern.facets.size());
  }
  EXPECT_TRUE(std::is_sorted(counts.begin(), counts.end()));
  EXPECT_EQ(counts.back(), 8U);
  for (int i = 0; i < 9; ++i) hand.wheel({90, 60}, -1);
  EXPECT_EQ(hand.field("count").value, 1);
}

TEST(FoldTool, OnlyTheLowerLayerFoldsWhenItAloneIsPicked) {  // thesis Fig 4.3
  ToolDriver hand(ToolId::Fold, "square 100; fold valley 30,0 30,100 to 10,50");
  hand.drag({50, 110}, {50, -10});  // across the flap P and the paper Q below it
  hand.held.control = true;
  hand.click({85, 50});  // Q joins
  hand.click({55, 50});  // P leaves
  hand.held = {};
  EXPECT_EQ(hand.field("layers").value, static_cast<double>(LayerMode::Chosen));
  hand.key('m');
  const auto after = hand.result();
  ASSERT_TRUE(after) << after.error().message;
  EXPECT_EQ(after->pattern.facets.size(), 3U);
  EXPECT_AT(imageOf(*after, {0, 50}), 60, 50, 0);   // P is where it was, whole
  EXPECT_AT(imageOf(*after, {100, 50}), 0, 50, 0);  // Q folded behind
  EXPECT_EQ(*facetAt(after->pattern, {1, 50}), *facetAt(after->pattern, {29, 50}));
}

TEST(FoldTool, AHiddenLayerIsPickedFromTheFan) {
  // Three strips over each other on x 0..30; the middle one is hidden from both sides.
  ToolDriver hand(ToolId::Fold,
                  "rectangle 90 60; fold valley 60,0 60,60 to 80,30; "
                  "fold valley @model 30,-5 30,65 to m:45,30");
  ASSERT_EQ(hand.state().pattern.facets.size(), 3U);
  hand.drag({-10, 20}, {40, 20});
  hand.set("fan", 1);
  const auto cards = [&] {
    std::vector<Vec2> places;
    for (const Mark& mark : hand.tool().marks(hand.scope())) {
      const auto* text = std::get_if<TextMark>(&mark);
      if (text != nullptr && text->text.text == "%1")
        places.push_back(std::get<PixelPlace>(text->at).at);
    }
    return places;
  };
  ASSERT_EQ(cards().size(), 3U);
  const auto clickCard = [&](std::size_t which) {
    const Vec2 at = cards()[which];
    for (const PointerAction action : {PointerAction::Press, PointerAction::Release})
      hand.send(PointerEvent{action, Pane::Model, at, PointerButton::Left, {}, false});
  };
  hand.set("layers", static_cast<double>(LayerMode::Top));
  clickCard(0);  // leaves
  clickCard(1);  // joins
  const auto step = std::get<FoldStep>(hand.step().action);
  const auto chosen = std::get<ChosenLayers>(step.layers).facets;
  ASSERT_EQ(chosen.size(), 1U);
  const FacetId middle = *facetAt(hand.state().pattern, chosen[0].point);
  double above = 0;
  for (std::size_t f = 0; f < 3; ++f) above += hand.state().layers.isAbove(FacetId(f), middle);
  EXPECT_EQ(above, 1);
}

TEST(FoldTool, OnlyTheLobeThatIsGrabbedFolds) {
  ToolDriver hand(ToolId::Fold, "polygon 0,0 100,0 100,100 70,100 70,30 30,30 30,100 0,100");
  hand.drag({1, 99}, {1, 60});  // the crease would cross both lobes
  const auto after = hand.result();
  ASSERT_TRUE(after) << after.error().message;
  EXPECT_EQ(after->pattern.facets.size(), 2U);
  EXPECT_AT(imageOf(*after, {100, 100}), 100, 100, 0);
  EXPECT_LT(imageOf(*after, {0, 100}).y, 65);
}

TEST(FoldTool, SelectedFacetsBesideTheLineMustMove) {
  ToolDriver hand(ToolId::Fold, "square 100; fold valley 30,0 30,100 to 10,50; unfold all");
  hand.selection.set({selectedFacet(hand.state(), *facetAt(hand.state().pattern, {10, 50}))});
  hand.drag({60, 110}, {60, -10});  // the larger side, for the selected facet is on it
  const auto step = std::get<FoldStep>(hand.step().action);
  ASSERT_TRUE(std::holds_alternative<MovingFacets>(step.moving));
  const auto after = hand.result();
  ASSERT_TRUE(after) << after.error().message;
  EXPECT_AT(imageOf(*after, {10, 50}), 110, 50, 0);
}

// On paper that is folded flat without cuts nothing can hang together round the line: what the hand
// takes is always enough.
TEST(FoldTool, WhatTheHandTakesNeverStretchesFlatPaper) {
  Random random(11);
  RandomStepOptions options;
  options.hasCuts = options.hasAngles = false;
  int folds = 0;
  int refused = 0;
  for (int i = 0; i < 300; ++i) {
    FoldedState state = startOf(modelOf(i % 2 == 0 ? "square 100" : "disc 60"));
    for (std::size_t s = 0; s < 1 + random.below(5); ++s) {
      auto next = apply(state, randomStep(random, state, options), static_cast<int>(s) + 1);
      if (next && isFlat(*next)) state = std::move(*next);
    }
    ToolDriver hand(ToolId::Fold, state);
    if (random.chance(0.5)) hand.look(Camera::Preset::Back);
    const auto place = [&] { return Vec2{random.between(-60, 160), random.between(-60, 160)}; };
    hand.drag(place(), place());
    if (!hand.proposal()) continue;
    const auto after = hand.result();
    EXPECT_FALSE(hand.hasField("remedy"));
    if (!after) {
      // A sliver, or a line drawn along the rim; never a stretch.
      const bool isHonest =
          after.error().code == ErrorCode::TooThin || after.error().code == ErrorCode::MissesPaper;
      EXPECT_TRUE(isHonest) << after.error().message << "\n" << textOf(hand.step());
      ++refused;
      continue;
    }
    ++folds;
    EXPECT_LE(stretchOf(*after), after->tolerance().match());
  }
  EXPECT_GT(folds, 100);
  EXPECT_LT(refused, folds / 10);
}

TEST(FoldTool, ARefusedStretchShowsTheHingeAndTheRemedyWorks) {
  ToolDriver hand(ToolId::Fold, kHalved);
  hand.drag({40, 30}, {110, 30});  // across the crease of the first fold
  ASSERT_TRUE(hand.result());
  EXPECT_EQ(hand.count(MarkRole::Fault), 0U);
  hand.set("layers", static_cast<double>(LayerMode::Top));
  const auto refused = hand.result();
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ErrorCode::WouldStretch);
  EXPECT_GE(hand.count(MarkRole::Fault), 1U);
  ASSERT_TRUE(hand.hasField("remedy"));
  hand.push("remedy");
  EXPECT_EQ(hand.field("layers").value, static_cast<double>(LayerMode::Chosen));
  const auto after = hand.result();
  ASSERT_TRUE(after) << after.error().message;
  EXPECT_EQ(after->pattern.facets.size(), 4U);
  EXPECT_EQ(hand.count(MarkRole::Fault), 0U);
  EXPECT_FALSE(hand.hasField("remedy"));
}

TEST(FoldTool, WhatNoLayerCanMendIsShownWithoutARemedy) {  // thesis Fig 4.2 c, d
  ToolDriver hand(ToolId::Fold, "square 100; fold valley 90 50,0 50,100 to 10,50");
  hand.drag({40, 30}, {110, 30});
  const auto refused = hand.result();
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ErrorCode::WouldStretch);
  EXPECT_GE(hand.count(MarkRole::Fault), 1U);
  EXPECT_FALSE(hand.hasField("remedy"));
}

TEST(FoldTool, ACollisionIsMarkedAndTheFoldCanBeMadeAllTheSame) {
  ToolDriver hand(ToolId::Fold, "square 100; fold valley 30,0 30,100 to 10,50");
  hand.drag({50, 110}, {50, -10});
  hand.held.control = true;
  hand.click({85, 50});
  hand.click({55, 50});
  hand.held = {};
  hand.key('v');  // Q rises through P
  EXPECT_GE(hand.count(MarkRole::Collision), 1U);
  EXPECT_TRUE(hand.key(Key::Enter).wantsCommit);
  ASSERT_EQ(hand.steps().size(), 1U);
  EXPECT_FALSE(hand.state().collisions.empty());
}

TEST(FoldTool, ATypedAngleIsTheAngleOfTheFold) {
  ToolDriver hand(ToolId::Fold, "square 100");
  hand.drag({1, 1}, {99, 99});
  hand.set("angle", 90);
  hand.set("name", "diagonal");
  ASSERT_TRUE(hand.commit());
  ASSERT_EQ(hand.state().lines.size(), 1U);
  EXPECT_EQ(hand.state().lines[0].name, "diagonal");
  EXPECT_DOUBLE_EQ(amountOf(hand.state(), FoldLineId(0)).value(), 90);
  EXPECT_NEAR(imageOf(hand.state(), {0, 0}).z, std::sqrt(5000), 1e-9);
}

TEST(FoldTool, TabTurnsTheOtherSide) {
  ToolDriver hand(ToolId::Fold, "square 100");
  hand.drag({30, -10}, {30, 110});
  EXPECT_AT(imageOf(*hand.result(), {0, 50}), 60, 50, 0);  // the smaller side
  hand.key(Key::Tab);
  EXPECT_AT(imageOf(*hand.result(), {0, 50}), 0, 50, 0);
  EXPECT_AT(imageOf(*hand.result(), {100, 50}), -40, 50, 0);
  hand.push("side");
  EXPECT_AT(imageOf(*hand.result(), {0, 50}), 60, 50, 0);
}

TEST(FoldTool, TheDrawnLineStaysAndIsMovedByItsHandles) {
  ToolDriver hand(ToolId::Fold, "square 100");
  hand.snaps.isOn = false;
  hand.drag({30, -10}, {30, 110});
  hand.drag({30, 110}, {60, 110});                          // its far end
  hand.drag({30, -10}, {60, -10});                          // its near end
  EXPECT_AT(imageOf(*hand.result(), {0, 50}), 120, 50, 0);  // still the side that moved before
  hand.drag({60, 50}, {20, 50});                            // the middle: in parallel
  EXPECT_AT(imageOf(*hand.result(), {0, 50}), 40, 50, 0);
}

TEST(FoldTool, AClickElsewhereKeepsTheProposalAndADragStartsAnew) {
  ToolDriver hand(ToolId::Fold, "square 100");
  hand.drag({1, 1}, {40, 40});
  const std::string before = textOf(hand.step());
  hand.click({70, 30});
  EXPECT_EQ(textOf(hand.step()), before);
  hand.drag({99, 99}, {60, 60});
  EXPECT_NE(textOf(hand.step()), before);
  EXPECT_AT(imageOf(*hand.result(), {0, 0}), 0, 0, 0);
}

TEST(FoldTool, TheHeldCornerCanBeTakenAgain) {
  ToolDriver hand(ToolId::Fold, "square 100");
  hand.snaps.isOn = false;
  hand.drag({2, 2}, {40, 40});
  hand.drag({40, 40}, {30, 60});
  EXPECT_AT(imageOf(*hand.result(), {2, 2}), 30, 60, 0);
}

TEST(FoldTool, ADoubleClickMakesTheFold) {
  ToolDriver hand(ToolId::Fold, "square 100");
  hand.drag({1, 1}, {99, 99});
  hand.click({50, 50});
  EXPECT_TRUE(hand.doubleClick({50, 50}).wantsCommit);
  EXPECT_EQ(hand.steps().size(), 1U);
}

TEST(FoldTool, EscapeAndResetLeaveNothing) {
  ToolDriver hand(ToolId::Fold, kHalved);
  for (const bool byKey : {true, false}) {
    hand.drag({99.5, 0.5}, {75, 25});
    ASSERT_TRUE(hand.proposal());
    if (byKey) {
      EXPECT_TRUE(hand.key(Key::Escape).isHandled);
    } else {
      hand.tool().reset();
    }
    EXPECT_FALSE(hand.proposal());
    EXPECT_FALSE(hand.tool().isBusy());
    EXPECT_TRUE(hand.tool().marks(hand.scope()).empty());
    EXPECT_TRUE(hand.tool().tints(hand.scope()).empty());
    EXPECT_TRUE(hand.tool().fields(hand.scope()).empty());
    EXPECT_FALSE(hand.key(Key::Escape).isHandled);
  }
}

TEST(FoldTool, WhileTheHandDrawsTheProposalIsNotComplete) {
  ToolDriver hand(ToolId::Fold, "square 100");
  hand.press({1, 1});
  EXPECT_FALSE(hand.proposal());
  hand.moveTo({40, 40});
  ASSERT_TRUE(hand.proposal());
  EXPECT_FALSE(hand.proposal()->isComplete);
  EXPECT_FALSE(hand.key(Key::Enter).wantsCommit);
}

TEST(FoldTool, OnTheSheetALineFoldsTheFacetUnderItsMiddle) {
  ToolDriver hand(ToolId::Fold, kHalved);
  hand.pane = Pane::Sheet;
  hand.drag({-5, 10}, {15, -10});  // across a corner of the left half, which lies on top
  const auto after = hand.result();
  ASSERT_TRUE(after) << after.error().message;
  EXPECT_EQ(after->pattern.facets.size(), 3U);
  EXPECT_AT(imageOf(*after, {0, 0}), 95, 5, 0);
}

TEST(FoldTool, OnTheSheetAValleyFoldsTheFrontsTogether) {
  ToolDriver hand(ToolId::Fold, kHalved);
  hand.pane = Pane::Sheet;
  hand.drag({-5, 10}, {15, -10});
  EXPECT_EQ(hand.field("type").value, 0);
  const auto after = hand.result();
  ASSERT_TRUE(after);
  for (const Edge& edge : after->pattern.edges) {
    if (edge.kind != EdgeKind::Hinge || edge.line != FoldLineId(1)) continue;
    EXPECT_EQ(edge.angle, 180);
  }
}

TEST(FoldTool, SelectedFacetsAreTheLayersAndASelectedPointTheSide) {
  ToolDriver hand(ToolId::Fold, kHalved);
  hand.selection.set({selectedFacet(hand.state(), *facetAt(hand.state().pattern, {90, 50})),
                      Selected{SelectedKind::Point, {60, 50}, {}, {}}});
  hand.drag({75, 110},
            {75, -10});  // the selected facet lies below; its part near the fold is to move
  const auto step = std::get<FoldStep>(hand.step().action);
  const auto* chosen = std::get_if<ChosenLayers>(&step.layers);
  ASSERT_NE(chosen, nullptr);
  ASSERT_EQ(chosen->facets.size(), 1U);
  EXPECT_GT(chosen->facets[0].point.x, 50);
  const auto* point = std::get_if<MovingPoint>(&step.moving);
  ASSERT_NE(point, nullptr);
  EXPECT_LT(point->place.point.x, 75);
}

TEST(FoldTool, StepsNamePlacesOnThePaperOnly) {
  ToolDriver hand(ToolId::Fold, kHalved);
  hand.drag({99.5, 0.5}, {75, 25});
  const auto step = std::get<FoldStep>(hand.step().action);
  EXPECT_EQ(step.line.frame, Frame::Paper);
  EXPECT_TRUE(step.line.facet.has_value());
  for (const Place& place : std::get<ChosenLayers>(step.layers).facets)
    EXPECT_EQ(place.frame, Frame::Paper);
  EXPECT_EQ(std::get<MovingPoint>(step.moving).place.frame, Frame::Paper);
}

TEST(FoldTool, HintsAndCursorsSayWhatTheHandCanDo) {
  ToolDriver hand(ToolId::Fold, "square 100");
  const Phrase idle = hand.tool().hint(hand.scope());
  hand.hover({50, 50});
  EXPECT_EQ(hand.tool().cursor(hand.scope()), CursorShape::Hand);
  hand.hover({-20, 50});
  EXPECT_EQ(hand.tool().cursor(hand.scope()), CursorShape::Cross);
  hand.press({1, 1});
  hand.moveTo({40, 40});
  EXPECT_EQ(hand.tool().cursor(hand.scope()), CursorShape::ClosedHand);
  const Phrase grabbing = hand.tool().hint(hand.scope());
  hand.release({40, 40});
  const Phrase resting = hand.tool().hint(hand.scope());
  EXPECT_FALSE(idle.isEmpty());
  EXPECT_NE(idle, grabbing);
  EXPECT_NE(grabbing, resting);
  EXPECT_GE(hand.count(MarkRole::Ghost), 1U);
  EXPECT_GE(hand.count(MarkRole::Handle), 3U);
  EXPECT_GE(hand.count(MarkRole::Valley), 2U);
}

}  // namespace
}  // namespace kiri::test
