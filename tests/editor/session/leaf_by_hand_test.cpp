// Each process of section 7.1 of the thesis, done by hand, gives the example's leaf.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <string>
#include <variant>

#include "tests/editor/session/hand.h"
#include "tests/support/example_files.h"
#include "tests/support/expect.h"

namespace kiri {
namespace {

using test::Hand;
using test::Sitter;

/// The hand does what each step of the example says; lines, tears and curves are drawn, from a
/// snapped start, and so a pixel off.
class LeafByHand : public testing::TestWithParam<const char*> {
 protected:
  void SetUp() override {
    Result<Document> document = Document::create(test::modelOfExample(GetParam()));
    ASSERT_TRUE(document.isOk());
    told = std::make_unique<Document>(std::move(*document));
    Model bare;
    bare.sheet = told->model().sheet;
    bare.opening = Sequence::Together;
    hand.open(bare);
  }
  const FoldedState& mine() { return *hand.session.document().state(); }

  void enter() {
    const std::size_t before = hand.stepCount();
    person.press(Key::Enter);
    if (hand.stepCount() == before) person.press(Key::Enter);  // the first ended a curve
  }
  /// A valley of a step is a mountain on the sheet where the paper lies turned over.
  void make(const FoldStep& fold) {
    const Vec2 from = fold.line.from;
    const Vec2 to = fold.line.to;
    Vec2 moving = lerp(from, to, 0.5) + normalized(perpendicular(to - from)) * 10;
    if (const auto* point = std::get_if<MovingPoint>(&fold.moving)) moving = point->place.point;
    const Vec2 on = fold.line.facet ? *fold.line.facet : moving;
    const bool isTurned = mine().poseOf(test::facetOf(mine(), on)).normal().z < 0;
    const char type = (fold.type == FoldType::Valley) != isTurned ? 'v' : 'm';
    EXPECT_TRUE(test::foldOnSheet(person, from, to, type, moving)) << hand.session.notice().why;
  }
  void make(const TearStep& tear) {
    person.take(ToolId::Tear);
    person.drag(Pane::Model, tear.path.points.front(), tear.path.points.back(), true);
    enter();
  }
  void make(const StraightCutStep& cut) {
    person.take(ToolId::StraightCut);
    person.drag(Pane::Model, cut.line.from, cut.line.to, true);
    enter();
  }
  void make(const CurveCutStep& cut) {
    person.take(ToolId::CurveCut);
    person.holdControl(true);
    for (const Vec2 control : cut.controls) person.click(Pane::Model, control);
    person.holdControl(false);
    enter();
  }
  void make(const UnfoldStep&) { person.command("unfold-all"); }
  void make(const RefoldStep&) { person.command("refold-all"); }
  void make(const MendStep&) {
    person.take(ToolId::Mend);
    person.set("all", 0);
  }
  template <typename Other>
  void make(const Other&) {
    ADD_FAILURE() << "the hand has not learned this";
  }

  DirectRunner runner;
  Hand hand{runner};
  Sitter person{hand};
  std::unique_ptr<Document> told;
};

TEST_P(LeafByHand, IsTheExamplesLeaf) {
  for (std::size_t i = 0; i < told->model().steps.size(); ++i) {
    std::visit([this](const auto& action) { make(action); }, told->model().steps[i].action);
    ASSERT_EQ(hand.stepCount(), i + 1) << hand.session.notice().why;
    const FoldedState& its = *told->stateAfter(i + 1);
    ASSERT_EQ(mine().pattern.facets.size(), its.pattern.facets.size()) << "step " << i + 1;
    EXPECT_EQ(mine().collisions.size(), its.collisions.size()) << "step " << i + 1;
    EXPECT_NEAR(test::areaOf(mine()) / test::areaOf(its), 1, 0.01) << "step " << i + 1;
    for (std::size_t f = 0; f < its.pattern.facets.size(); ++f) {
      const Vec2 inside = interiorPointOf(its.pattern, FacetId(f));
      EXPECT_LT(distance(test::modelOf(mine(), inside), test::modelOf(its, inside)), 2)
          << "step " << i + 1;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Of, LeafByHand,
                         testing::Values("leaf_palmate", "leaf_petiole_inside",
                                         "leaf_secondary_lobes"),
                         [](const auto& leaf) { return std::string(leaf.param); });

}  // namespace
}  // namespace kiri
