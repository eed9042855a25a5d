// Models of the thesis, made by hand from their sheet, are the models of the gallery.
// SPDX-License-Identifier: MIT
#include <cmath>

#include "editor/tools/curve_shape.h"
#include "editor/tools/layer_picker.h"
#include "tests/apps/desktop/journeys/journey.h"
#include "tests/support/example_files.h"
#include "tests/support/expect.h"

namespace kiri::desktop {
namespace {

/// A model of examples/, and its sheet under the hand.
class ByHand : public Journey {
 protected:
  /// Opens the bare sheet of the example, in its colours.
  void begin(const std::string& name) {
    Result<Document> document = Document::create(test::modelOfExample(name));
    ASSERT_TRUE(document.isOk());
    told = std::make_unique<Document>(std::move(*document));
    Model bare;
    bare.sheet = told->model().sheet;
    bare.front = told->model().front;
    bare.back = told->model().back;
    bare.opening = told->model().opening;
    window->files().openModel(bare);
    settle();
    session().fitAll();
    settle();
  }
  /// The flap at `from` goes to `to`.
  void foldOver(Vec2 from, Vec2 to, LayerMode layers = LayerMode::Hand) {
    take(ToolId::Fold);
    drag(Pane::Model, from, to);
    if (layers != LayerMode::Hand) set("layers", static_cast<double>(layers));
    enter();
  }
  void foldAlong(Vec2 from, Vec2 to, char type, LayerMode layers) {
    take(ToolId::Line);
    drag(Pane::Model, from, to);
    press(type);
    set("layers", static_cast<double>(layers));
    enter();
  }
  void enter() {
    picture(pictureName("drawn"));
    const std::size_t before = count();
    press(Key::Enter);
    ASSERT_EQ(count(), before + 1) << session().notice().why;
    picture(pictureName("done"));
  }
  /// Points along the curve that the example cuts.
  std::vector<Vec2> curveOfExample() const {
    for (const Step& step : told->model().steps) {
      if (const auto* cut = std::get_if<CurveCutStep>(&step.action))
        return polyline(splineOf(cut->controls, false), 8);
    }
    return {};
  }
  QString pictureName(const char* what) {
    const auto* info = ::testing::UnitTest::GetInstance()->current_test_info();
    return QString("%1-%2-%3").arg(info->name()).arg(count()).arg(what);
  }

  /// Facet for facet the paper lies where it lies in the example after so many steps, in the same
  /// order.
  void expectLiesAlike(std::size_t steps, double within) {
    const FoldedState& mine = *session().document().stateAfter(steps);
    const FoldedState& its = *told->stateAfter(steps);
    ASSERT_EQ(mine.pattern.facets.size(), its.pattern.facets.size());
    for (std::size_t f = 0; f < its.pattern.facets.size(); ++f) {
      const Vec2 a = interiorPointOf(its.pattern, FacetId(f));
      const Vec3 place = test::modelOf(its, a);
      EXPECT_LT(distance(test::modelOf(mine, a), place), within * its.tolerance().sheetSize());
      for (std::size_t g = 0; g < its.pattern.facets.size(); ++g) {
        const Vec2 here = its.poses[g].pullBack(place);
        const Region paper = regionOf(its.pattern, FacetId(g));
        if (f == g || locate(paper, here, its.tolerance().match()) != Where::Inside) continue;
        const Vec2 b = interiorPointOf(its.pattern, FacetId(g));
        EXPECT_EQ(test::isAbove(mine, a, b), test::isAbove(its, a, b))
            << a.x << "," << a.y << " and " << b.x << "," << b.y;
        ++compared;
      }
    }
  }
  void expectSameKinds() {
    std::vector<std::size_t> mine;
    std::vector<std::size_t> its;
    for (const Step& step : session().document().model().steps) mine.push_back(step.action.index());
    for (const Step& step : told->model().steps) its.push_back(step.action.index());
    EXPECT_EQ(mine, its);
  }

  std::unique_ptr<Document> told;  ///< the example
  int compared = 0;                ///< pairs of facets that lie on each other
};

TEST_F(ByHand, TheCupFoldedByHandIsTheExamplesCup) {  // Figure 7.16
  begin("origami_cup");
  const Vec2 left{-41.4214, 58.5786};  // where the level edge meets the sides
  const Vec2 right{41.4214, 58.5786};
  foldOver({0, -100}, {0, 100});
  foldOver({-100, 0}, right);
  take(ToolId::Tear);
  drag(Pane::Model, {100, 0}, {17.4, 0});
  enter();
  foldOver({100, 0}, left, LayerMode::Top);
  foldAlong(left, right, 'v', LayerMode::Top);
  foldOver({100, 0}, left);
  command("mend-all");
  foldAlong(left, right, 'm', LayerMode::Top);
  expectSameKinds();
  expectLiesAlike(8, 1e-9);
  EXPECT_GE(compared, 30);
}

/// The leaf of Figure 1.2 with its margin drawn in one stroke.
class LeafByHand : public ByHand {
 protected:
  static constexpr Vec2 kPetiole{75, 0};

  /// A fold from the petiole, drawn on the sheet as far as the hand is sure, then its direction
  /// typed; the paper at `moving` goes.
  void foldFromPetiole(double direction, char type, Vec2 moving) {
    take(ToolId::Line);
    const double radians = direction * std::acos(-1.0) / 180;
    const Vec2 along{std::cos(radians), std::sin(radians)};
    drag(Pane::Sheet, kPetiole, kPetiole + along * 60, true);
    press(type);
    set("direction", direction);
    const Shown shown = session().shown();
    const auto facet = facetAt(shown.state->pattern, moving);
    ASSERT_TRUE(facet && facet->index < shown.tints.size());
    if (shown.tints[facet->index] != FacetTint::Pale) press(Key::Tab);
    enter();
  }
};

TEST_F(LeafByHand, ALeafFoldedAndCutByHandIsTheExamplesLeaf) {  // Figure 1.2
  begin("leaf_three_lobes");
  foldFromPetiole(90, 'm', {40, 75});
  command("unfold-all");
  for (const double side : {1.0, -1.0}) {
    foldFromPetiole(90 - side * 24, 'v', {75 + side * 20, 10});
    foldFromPetiole(90 - side * 44, 'm', {75 + side * 30, 5});
  }
  command("refold-all");
  ASSERT_EQ(count(), 7u) << session().notice().why;
  expectLiesAlike(7, 1e-6);
  EXPECT_GE(compared, 20);

  take(ToolId::CurveCut);
  stroke(Pane::Model, curveOfExample());
  enter();
  command("unfold-all");
  expectSameKinds();
  expectLiesAlike(9, 1e-6);
  const CreasePattern& leaf = session().document().state()->pattern;
  EXPECT_NEAR(areaOf(leaf) / areaOf(told->state()->pattern), 1, 0.005);
  EXPECT_TRUE(session().document().state()->collisions.empty());
}

TEST_F(ByHand, AStarFoldedAndCutTwiceByHandIsTheExamplesStar) {  // Figure 7.18
  begin("kirigami_star");
  foldOver({120, 0}, {0, 0});
  foldOver({0, 120}, {0, 0});
  take(ToolId::StraightCut);
  holdControl(true);
  drag(Pane::Model, {42, 64}, {64, 42});
  holdControl(false);
  enter();
  foldOver({0, 60}, {60, 0}, LayerMode::All);
  // The diagonal onto the edge at the right.
  foldOver({30, 30}, {60, 60 - 30 * std::sqrt(2.0)}, LayerMode::All);
  expectLiesAlike(5, 0.01);
  take(ToolId::CurveCut);
  stroke(Pane::Model, curveOfExample());
  enter();
  command("unfold-all");
  expectSameKinds();
  expectLiesAlike(7, 0.01);
  const FoldedState& star = *session().document().state();
  EXPECT_NEAR(areaOf(star.pattern) / areaOf(told->state()->pattern), 1, 0.01);
  EXPECT_EQ(piecesOf(star.pattern), piecesOf(told->state()->pattern));
}

}  // namespace
}  // namespace kiri::desktop
