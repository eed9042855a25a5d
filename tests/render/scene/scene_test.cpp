// Pictures of models, patterns and steps.
// SPDX-License-Identifier: MIT
#include "render/scene/scene.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>

#include "core/model/replay.h"
#include "render/scene/model_scene.h"
#include "render/scene/pattern_scene.h"
#include "render/scene/sheet_scene.h"
#include "tests/support/model_text.h"

namespace kiri {
namespace {

const Group* find(const Scene& scene, const std::string& id) {
  for (const Group& group : scene.groups) {
    if (group.id == id) return &group;
  }
  return nullptr;
}

std::size_t countKind(const Scene& scene, const std::string& kind) {
  std::size_t count = 0;
  for (const Group& group : scene.groups) {
    for (const Item& item : group.items) count += item.kind == kind ? 1U : 0U;
  }
  return count;
}

Box boxOfFills(const Group& group) {
  Region all;
  for (const Item& item : group.items) {
    for (const Loop& loop : std::get<FillItem>(item.shape).loops) all.loops.push_back(loop);
  }
  return boundsOf(all);
}

TEST(ModelScene, PageIsTheModelInTrueSizeWithItsMargin) {
  const Scene scene = modelScene(test::run("rectangle 80 60"), {}, frontView(), {7, 1, "sheet"});
  EXPECT_NEAR(scene.width, 94, 1e-9);
  EXPECT_NEAR(scene.height, 74, 1e-9);
  EXPECT_EQ(scene.title, "sheet");
  const Box box = boxOfFills(*find(scene, "paper"));
  EXPECT_NEAR(box.low.x, 7, 1e-9);
  EXPECT_NEAR(box.high.y, 67, 1e-9);
}

TEST(ModelScene, ScaleEnlargesPaperButNotLines) {
  const FoldedState state = test::run("square 50");
  const Scene scene = modelScene(state, {}, frontView(), {5, 2, ""});
  EXPECT_NEAR(scene.width, 110, 1e-9);
  const Item& edge = find(scene, "edges")->items.front();
  EXPECT_EQ(std::get<StrokeItem>(edge.shape).stroke.width, Appearance{}.edgeWidth);
}

TEST(ModelScene, FoldedFlapShowsItsBackColour) {
  Appearance looks;
  looks.front.color = {1, 2, 3};
  looks.back.color = {9, 8, 7};
  const FoldedState state = test::run("square 100; fold valley 30,0 30,100 left");
  const Scene front = modelScene(state, looks, frontView());
  EXPECT_EQ(countKind(front, "front"), 1U);
  EXPECT_EQ(countKind(front, "back"), 1U);
  for (const Item& item : find(front, "paper")->items) {
    EXPECT_EQ(std::get<FillItem>(item.shape).fill.color,
              item.kind == "front" ? looks.front.color : looks.back.color);
  }
  const Scene back = modelScene(state, looks, backView());
  EXPECT_EQ(countKind(back, "front"), 0U);
}

TEST(ModelScene, CreaseThatLiesFlatAgainIsThinAndCanBeLeftOut) {
  const FoldedState state = test::run("square 100; fold valley 30,0 30,100 left; unfold all");
  Appearance looks;
  const Scene scene = modelScene(state, looks, frontView());
  ASSERT_NE(find(scene, "creases"), nullptr);
  EXPECT_EQ(std::get<StrokeItem>(find(scene, "creases")->items.front().shape).stroke.width,
            looks.creaseWidth);
  looks.showCreases = false;
  EXPECT_EQ(find(modelScene(state, looks, frontView()), "creases"), nullptr);
  looks.showEdges = false;
  EXPECT_EQ(find(modelScene(state, looks, frontView()), "edges"), nullptr);
}

TEST(ModelScene, SeamsLieBelowThePaperAndInsideTheSilhouette) {
  const FoldedState state = test::run("square 100; fold valley 30,0 45,100 left; unfold all");
  const Scene scene = modelScene(state, {}, frontView());
  ASSERT_GE(scene.groups.size(), 2U);
  EXPECT_EQ(scene.groups[0].id, "seams");
  EXPECT_EQ(scene.groups[1].id, "paper");
  ASSERT_EQ(scene.groups[0].clip.size(), 1U);
  EXPECT_NEAR(signedAreaOf(scene.groups[0].clip[0]), 10000, 1e-6);
}

TEST(ModelScene, TextureFoldsWithThePaper) {
  Appearance looks;
  looks.textureBox = {{0, 0}, {100, 100}};
  const auto image = std::make_shared<Image>(Image{1, 1, {0, 0, 0, 255}});
  looks.front.texture = looks.back.texture = image;
  const FoldedState state = test::run("square 100; fold valley 30,0 30,100 left");
  const Scene scene = modelScene(state, looks, frontView(), {0, 1, ""});
  for (const Item& item : find(scene, "paper")->items) {
    const Affine& map = std::get<FillItem>(item.shape).fill.imageToScene;
    const Vec2 lowerLeft = map.apply({0, 0});
    if (item.kind == "front") {
      EXPECT_NEAR(lowerLeft.x, -30, 1e-9);  // the page begins at the fold
      EXPECT_GT(map.a * map.d - map.b * map.c, 0);
    } else {
      // Seen on the flap: the back's image is upright, its left edge where the sheet's right edge
      // would lie.
      EXPECT_NEAR(lowerLeft.x, -70, 1e-9);
      EXPECT_GT(map.a * map.d - map.b * map.c, 0) << "the back's own image is not mirrored";
    }
  }
}

TEST(ModelScene, GridHasALineEveryTenMillimetresOfPaper) {
  Appearance looks;
  looks.gridSpacing = 10;
  const Scene scene = modelScene(test::run("square 100"), looks, frontView(), {0, 1, ""});
  ASSERT_NE(find(scene, "grid"), nullptr);
  EXPECT_EQ(std::get<StrokeItem>(find(scene, "grid")->items.front().shape).chains.size(), 22U);
}

TEST(PatternScene, MountainAndValleyStandInTheirGroupsWithFoldAngles) {
  const FoldedState state = test::run(
      "square 100; fold valley 30,0 30,100 left; fold mountain 70,0 70,100 right; edge 30,50 "
      "70,50");
  const Scene scene = patternScene(state, {});
  for (const char* id : {"print", "cut", "mountain", "valley", "flat"})
    EXPECT_NE(find(scene, id), nullptr) << id;
  EXPECT_EQ(countKind(scene, "valley"), 2U);  // the new edge cut each hinge in two
  EXPECT_EQ(countKind(scene, "mountain"), 2U);
  const auto& data = find(scene, "mountain")->items.front().data;
  EXPECT_EQ(data[0].second, "M");
  EXPECT_EQ(data[1].second, "-180");
  EXPECT_EQ(find(scene, "flat")->items.front().data[0].second, "F");
}

TEST(PatternScene, ThesisColoursMakeMountainsBlueAndValleysRed) {
  const FoldedState state =
      test::run("square 100; fold valley 30,0 30,100 left; fold mountain 70,0 70,100 right");
  const auto colour = [&](const Appearance& looks, const char* id) {
    return std::get<StrokeItem>(find(patternScene(state, looks), id)->items.front().shape)
        .stroke.color;
  };
  Appearance looks;
  EXPECT_GT(colour(looks, "mountain").blue, 150);
  EXPECT_GT(colour(looks, "valley").red, 150);
  looks.lineStyle = LineStyle::Program;
  EXPECT_EQ(colour(looks, "mountain"), (Color{255, 0, 0}));
  EXPECT_EQ(colour(looks, "valley"), (Color{0, 0, 255}));
  looks.lineStyle = LineStyle::Diagram;
  const auto stroke = [&](const char* id) {
    return std::get<StrokeItem>(find(patternScene(state, looks), id)->items.front().shape).stroke;
  };
  EXPECT_EQ(stroke("valley").dashes.size(), 2U);
  EXPECT_EQ(stroke("mountain").dashes.size(), 6U);
}

TEST(PatternScene, CutContoursAreClosedOnceForEachRim) {
  const FoldedState state = test::run(
      "polygon 0,0 100,0 100,100 0,100 hole 40,40 60,40 60,60 40,60; fold valley 20,0 20,100 left; "
      "unfold all");
  const Scene scene = patternScene(state, {});
  const Group& cut = *find(scene, "cut");
  ASSERT_EQ(cut.items.size(), 2U);
  double area = 0;
  for (const Item& item : cut.items) {
    const auto& chains = std::get<StrokeItem>(item.shape).chains;
    ASSERT_EQ(chains.size(), 1U);
    EXPECT_EQ(chains[0].front().start, chains[0].back().end);
    area += signedAreaOf(chains[0]);
  }
  EXPECT_NEAR(area, 10000 - 400, 1e-6);
}

TEST(PatternScene, TearIsALineOfTheCutGroup) {
  const FoldedState state =
      test::run("square 100; fold valley 50,0 50,100 left; unfold all; tear 50,0 50,100");
  const Scene scene = patternScene(state, {});
  EXPECT_EQ(countKind(scene, "tear"), 1U);
  EXPECT_EQ(countKind(scene, "border"), 1U) << "the rim of the paper goes past the tear";
}

TEST(PatternScene, LinesOnlyHasNoPaper) {
  EXPECT_EQ(find(patternScene(test::run("square 10"), {}, {5, 1, "", PatternFill::None}), "print"),
            nullptr);
}

Result<Scene> sheetOf(const std::string& text, const SheetSceneOptions& options = {}) {
  const Model model = test::modelOf(text);
  const Result<Replay> steps = replay(model);
  return sheetScene(model, *steps, appearanceOf(model), options);
}

const std::string kThreeSteps =
    "square 100; fold valley 30,0 30,100 left; fold mountain 70,0 70,100 right; unfold all";

TEST(SheetScene, HasOnePanelForEachStateAndTheNextLineOnEach) {
  const Result<Scene> scene = sheetOf(kThreeSteps);
  ASSERT_TRUE(scene.isOk());
  EXPECT_EQ(countKind(*scene, "number"), 4U);
  EXPECT_EQ(countKind(*scene, "valley"), 1U);
  EXPECT_EQ(countKind(*scene, "mountain"), 1U);
  ASSERT_NE(find(*scene, "panel-0-line"), nullptr);
  EXPECT_EQ(find(*scene, "panel-2-line"), nullptr);
}

TEST(SheetScene, IdsAreUnique) {
  const Result<Scene> scene = sheetOf(kThreeSteps);
  std::set<std::string> ids;
  for (const Group& group : scene->groups) {
    EXPECT_TRUE(ids.insert(group.id).second) << group.id;
    for (const Item& item : group.items)
      EXPECT_TRUE(item.id.empty() || ids.insert(item.id).second) << item.id;
  }
}

TEST(SheetScene, SeenFromBehindAValleyIsAMountain) {
  SheetSceneOptions options;
  options.view = backView();
  options.states = {0};
  const Result<Scene> scene = sheetOf(kThreeSteps, options);
  EXPECT_EQ(countKind(*scene, "mountain"), 1U);
  EXPECT_EQ(countKind(*scene, "valley"), 0U);
}

TEST(SheetScene, LineLiesOnTheFoldOfThePanel) {
  SheetSceneOptions options;
  options.states = {0};
  const Result<Scene> scene = sheetOf(kThreeSteps, options);
  const Box paper = boxOfFills(*find(*scene, "panel-0-paper"));
  const Arc line =
      std::get<StrokeItem>(find(*scene, "panel-0-line")->items.back().shape).chains[0][0];
  const double width = paper.high.x - paper.low.x;
  EXPECT_NEAR(line.start.x, paper.low.x + 0.3 * width, 1e-9);
  EXPECT_NEAR(line.start.y, paper.low.y, 1e-9);
  EXPECT_NEAR(line.end.y, paper.high.y, 1e-9);
}

TEST(SheetScene, AllPanelsHaveOneScaleAndStayOnThePage) {
  for (const int columns : {0, 1, 2, 3, 10}) {
    SheetSceneOptions options;
    options.columns = columns;
    const Result<Scene> scene = sheetOf(kThreeSteps, options);
    ASSERT_TRUE(scene.isOk());
    for (int i = 0; i <= 3; ++i) {
      const Box box = boxOfFills(*find(*scene, "panel-" + std::to_string(i) + "-paper"));
      EXPECT_GE(box.low.x, 0);
      EXPECT_GE(box.low.y, 0);
      EXPECT_LE(box.high.x, scene->width);
      EXPECT_LE(box.high.y, scene->height);
      const Box first = boxOfFills(*find(*scene, "panel-0-paper"));
      EXPECT_NEAR(box.high.y - box.low.y, first.high.y - first.low.y, 1e-9);
    }
  }
}

TEST(SheetScene, StateThatTheModelLacksIsAnError) {
  SheetSceneOptions options;
  options.states = {0, 9};
  const Result<Scene> scene = sheetOf(kThreeSteps, options);
  ASSERT_FALSE(scene.isOk());
  EXPECT_NE(scene.error().message.find("after step 9"), std::string::npos);
  options = {};
  options.pageWidth = 10;
  EXPECT_FALSE(sheetOf(kThreeSteps, options).isOk());
}

TEST(SheetScene, StepThatDoesNotApplyIsTheError) {
  const Result<Scene> scene = sheetOf("square 100; fold valley 300,0 300,100 left");
  ASSERT_FALSE(scene.isOk());
  EXPECT_EQ(scene.error().message.rfind("step 1: ", 0), 0U) << scene.error().message;
}

TEST(SheetScene, LastStepCaptionNamesWhatWasDone) {
  Model model = test::modelOf(kThreeSteps);
  model.steps[0].title = "in from the left";
  const Result<Replay> steps = replay(model);
  SheetSceneOptions options;
  options.states = {1};
  options.caption = PanelCaption::LastStep;
  const Result<Scene> scene = sheetScene(model, *steps, appearanceOf(model), options);
  EXPECT_EQ(find(*scene, "panel-1-line"), nullptr);
  std::string words;
  for (const Item& item : find(*scene, "panel-1-text")->items)
    words += std::get<TextItem>(item.shape).text + " ";
  EXPECT_EQ(words, "1 in from the left ");
}

TEST(OnModel, LineOnTheBackOfAFoldedFlapLiesWhereTheFlapLies) {
  const FoldedState state = test::run("square 100; fold valley 30,0 30,100 left");
  const auto segment = onModel(state, {Frame::Paper, {10, 0}, {10, 100}, Vec2{10, 50}});
  ASSERT_TRUE(segment.has_value());
  EXPECT_NEAR(segment->from.x, 50, 1e-9);
  EXPECT_FALSE(onModel(state, {Frame::Paper, {10, 0}, {10, 100}, Vec2{500, 50}}).has_value());
}

TEST(Affine, ComposesRightToLeft) {
  const Affine turn{0, 1, -1, 0, 0, 0};
  const Affine move{1, 0, 0, 1, 5, 0};
  EXPECT_EQ(compose(move, turn).apply({1, 0}), (Vec2{5, 1}));
  EXPECT_EQ(compose(turn, move).apply({1, 0}), (Vec2{0, 6}));
}

}  // namespace
}  // namespace kiri
