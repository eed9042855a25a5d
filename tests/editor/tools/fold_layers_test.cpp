// Which layers a fold takes: by hand, by keys, by picking, and what must come along.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/model/apply.h"
#include "editor/tools/layer_picker.h"
#include "tests/editor/tools/examples.h"
#include "tests/editor/tools/images.h"
#include "tests/editor/tools/tool_driver.h"
#include "tests/support/model_text.h"
#include "tests/support/random_steps.h"

namespace kiri::test {
namespace {

const char* const kHalvedSheet = "square 100; fold valley 50,0 50,100 to 10,50";

TEST(FoldLayers, TheHandTakesTheTopFlapAlone) {
  ToolDriver hand(ToolId::Fold, kHalvedSheet);
  hand.drag({99.5, 0.5}, {75, 25});  // the free corner of the left half, which lies on top
  const auto after = hand.result();
  ASSERT_TRUE(after) << after.error().message;
  EXPECT_EQ(after->pattern.facets.size(), 3U);
  EXPECT_AT(imageOf(*after, {0, 0}), 75, 25, 0);
  EXPECT_AT(imageOf(*after, {100, 0}), 100, 0, 0);  // the lower layer rests
}

TEST(FoldLayers, FromBehindTheTopFlapIsTheOneThatIsSeen) {
  ToolDriver hand(ToolId::Fold, kHalvedSheet);
  hand.look(Camera::Preset::Back);
  hand.drag({99.5, 0.5}, {75, 25});
  const auto after = hand.result();
  ASSERT_TRUE(after) << after.error().message;
  EXPECT_EQ(after->pattern.facets.size(), 3U);
  EXPECT_AT(imageOf(*after, {100, 0}), 75, 25, 0);
  EXPECT_AT(imageOf(*after, {0, 0}), 100, 0, 0);
}

TEST(FoldLayers, PaperJoinedAcrossTheLineComesAlong) {
  ToolDriver hand(ToolId::Fold, kHalvedSheet);
  hand.drag({50.5, 0.5}, {75, 25});  // the corner at the fold: both halves hang together there
  const auto after = hand.result();
  ASSERT_TRUE(after) << after.error().message;
  EXPECT_EQ(after->pattern.facets.size(), 4U);
  EXPECT_AT(imageOf(*after, {50, 0}), 75, 25, 0);
  EXPECT_FALSE(hand.hasField("remedy"));
}

TEST(FoldLayers, ShiftTakesAllLayersAndAltTheTopOne) {
  ToolDriver hand(ToolId::Fold, kHalvedSheet);
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

TEST(FoldLayers, AllLayersThatFoldFreelyMissNone) {  // Figure 7.18e
  ToolDriver hand(ToolId::Fold, exampleOf("kirigami_star").after(4));
  hand.drag({30, 30}, {60, 60 - 30 * std::sqrt(2.0)});
  hand.set("layers", static_cast<double>(LayerMode::All));
  ASSERT_TRUE(hand.result());
  EXPECT_FALSE(hand.hasField("remedy"));
  EXPECT_EQ(hand.result()->pattern.facets.size(), 16U);
}

TEST(FoldLayers, TheWheelWalksThroughTheLayers) {
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

TEST(FoldLayers, OnlyTheLowerLayerFoldsWhenItAloneIsPicked) {  // thesis Fig 4.3
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

TEST(FoldLayers, AHiddenLayerIsPickedFromTheFan) {
  // Three strips over each other on x 0..30; the middle one is hidden from both sides.
  ToolDriver hand(ToolId::Fold,
                  "rectangle 90 60; fold valley 60,0 60,60 to 80,30; "
                  "fold valley @model 30,-5 30,65 to m:45,30");
  ASSERT_EQ(hand.state().pattern.facets.size(), 3U);
  hand.drag({-10, 20}, {40, 20});
  hand.key('k');
  EXPECT_EQ(hand.field("fan").value, 1);
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

TEST(FoldLayers, OnlyTheLobeThatIsGrabbedFolds) {
  ToolDriver hand(ToolId::Fold, "polygon 0,0 100,0 100,100 70,100 70,30 30,30 30,100 0,100");
  hand.drag({1, 99}, {1, 60});  // the crease would cross both lobes
  const auto after = hand.result();
  ASSERT_TRUE(after) << after.error().message;
  EXPECT_EQ(after->pattern.facets.size(), 2U);
  EXPECT_AT(imageOf(*after, {100, 100}), 100, 100, 0);
  EXPECT_LT(imageOf(*after, {0, 100}).y, 65);
}

TEST(FoldLayers, SelectedFacetsBesideTheLineMustMove) {
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
TEST(FoldLayers, WhatTheHandTakesNeverStretchesFlatPaper) {
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

TEST(FoldLayers, ARefusedStretchShowsTheHingeAndTheRemedyWorks) {
  ToolDriver hand(ToolId::Fold, kHalvedSheet);
  hand.drag({40, 30}, {110, 30});  // across the crease of the first fold
  ASSERT_TRUE(hand.result());
  hand.set("layers", static_cast<double>(LayerMode::Top));
  const auto refused = hand.result();
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ErrorCode::WouldStretch);
  EXPECT_FALSE(refused.error().witness.segments.empty()) << "the session marks it";
  ASSERT_TRUE(hand.hasField("remedy"));
  hand.push("remedy");
  EXPECT_EQ(hand.field("layers").value, static_cast<double>(LayerMode::Chosen));
  const auto after = hand.result();
  ASSERT_TRUE(after) << after.error().message;
  EXPECT_EQ(after->pattern.facets.size(), 4U);
  EXPECT_FALSE(hand.hasField("remedy"));
}

TEST(FoldLayers, WhatNoLayerCanMendIsShownWithoutARemedy) {  // thesis Fig 4.2 c, d
  ToolDriver hand(ToolId::Fold, "square 100; fold valley 90 50,0 50,100 to 10,50");
  hand.drag({40, 30}, {110, 30});
  const auto refused = hand.result();
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ErrorCode::WouldStretch);
  EXPECT_FALSE(refused.error().witness.segments.empty()) << "the session marks it";
  EXPECT_FALSE(hand.hasField("remedy"));
}

TEST(FoldLayers, SelectedFacetsAreTheLayersAndASelectedPointTheSide) {
  ToolDriver hand(ToolId::Fold, kHalvedSheet);
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

}  // namespace
}  // namespace kiri::test
