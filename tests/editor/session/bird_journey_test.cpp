// The bird of the thesis, with its added edges and tears, by hand alone.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "editor/tools/layer_picker.h"
#include "tests/editor/session/hand.h"
#include "tests/support/example_files.h"
#include "tests/support/expect.h"
#include "tests/support/order_check.h"

namespace kiri {
namespace {

using test::Hand;
using test::Sitter;

/// The sheet of examples/origami_bird.kiri under the hand, and the example to compare with.
class BirdJourney : public testing::Test {
 protected:
  void SetUp() override {
    Result<Document> document = Document::create(test::modelOfExample("origami_bird"));
    ASSERT_TRUE(document.isOk());
    told = std::make_unique<Document>(std::move(*document));
    Model bare;
    bare.sheet = told->model().sheet;
    hand.open(bare);
  }
  /// The paper lies as in the example after its next step; lines that were drawn without a snap
  /// are a pixel off.
  void expectNext() {
    const FoldedState& mine = *hand.session.document().state();
    const FoldedState& its = *told->stateAfter(++step);
    ASSERT_EQ(mine.pattern.facets.size(), its.pattern.facets.size()) << "step " << step;
    EXPECT_EQ(mine.collisions.size(), its.collisions.size()) << "step " << step;
    for (const EdgeKind kind : {EdgeKind::Hinge, EdgeKind::Tear})
      EXPECT_EQ(test::edgeCount(mine, kind), test::edgeCount(its, kind)) << "step " << step;
    for (std::size_t f = 0; f < its.pattern.facets.size(); ++f) {
      const Vec2 inside = interiorPointOf(its.pattern, FacetId(f));
      EXPECT_LT(distance(test::modelOf(mine, inside), test::modelOf(its, inside)), 0.5)
          << "step " << step;
    }
  }
  void enter() {
    const std::size_t before = hand.stepCount();
    person.press(Key::Enter);
    ASSERT_EQ(hand.stepCount(), before + 1) << hand.session.notice().why;
    expectNext();
  }
  void fold(Vec2 from, Vec2 to, char type = 'v') {
    person.take(ToolId::Fold);
    person.drag(Pane::Model, from, to, false);
    person.press(type);
    enter();
  }
  /// A fold line from a place that snaps to one that does not, and Enter.
  void foldAlong(Vec2 from, Vec2 to, char type) {
    person.take(ToolId::Line);
    person.drag(Pane::Model, from, to, true);
    person.press(type);
    for (const Field& field : hand.session.fields()) {
      if (field.id == "remedy") person.set("remedy", 0);  // the layers that must come along
    }
    enter();
  }
  void pick(Vec2 at) {
    person.take(ToolId::Select);
    person.click(Pane::Model, at);
  }
  void refold(const std::string& name) {
    for (const FoldSlider& slider : hand.session.sliders()) {
      if (slider.name != name) continue;
      hand.session.beginSlide(slider.line);
      hand.session.slide(180);
      hand.session.endSlide(true);
      return;
    }
    ADD_FAILURE() << name;
  }
  /// Figure 7.11b to f, on the upper (1) or lower (-1) half.
  void foldHalf(double side) {
    foldAlong({-30, side * 90}, {30, side * 90}, 'v');
    person.take(ToolId::AddEdge);
    person.drag(Pane::Model, {0, side * 90}, {0, 0}, false);
    enter();
    person.take(ToolId::Tear);
    person.drag(Pane::Model, {0, side * 90}, {0, side * 41.2}, false);
    enter();
    const double onEdge = 40 * std::sqrt(2.0);  // as far from the corner along the diagonal
    fold({60, side * 40}, {100 - onEdge, 0});
    fold({-60, side * 40}, {onEdge - 100, 0});
  }
  void foldNeck(double side) {
    pick({95, side});
    foldAlong({24, 0}, {72.5, side * 35.3}, 'm');
  }
  void foldWingOut(double side) {
    pick({10, side * 15});
    foldAlong({0, side * 41.4}, {-27, 0}, 'v');
  }

  DirectRunner runner;
  Hand hand{runner};
  Sitter person{hand};
  std::unique_ptr<Document> told;
  std::size_t step = 0;  ///< of the example
};

TEST_F(BirdJourney, TheBirdMadeByHandIsTheExamplesBird) {  // Figure 7.11
  fold({0, -100}, {0, 100}, 'm');
  person.command("unfold-all");
  expectNext();
  foldHalf(1);
  foldHalf(-1);
  person.take(ToolId::Tear);
  person.drag(Pane::Model, {100, 0}, {24, 0}, true);
  enter();
  foldNeck(1);
  foldWingOut(1);
  person.command("unfold-all");
  expectNext();
  for (const char* name : {"fold 3", "fold 6", "fold 7", "fold 8", "fold 11", "fold 12"})
    refold(name);
  expectNext();
  refold("fold 14");
  expectNext();
  refold("fold 15");
  expectNext();
  foldNeck(-1);
  foldWingOut(-1);
  refold("fold 1");
  expectNext();
  person.take(ToolId::Mend);
  person.click(Pane::Model, {35.7, 36.1});
  expectNext();
  person.take(ToolId::Line);
  person.drag(Pane::Model, {13.58, 35.37}, {66.56, 63.54}, true);
  person.press('v');
  person.set("layers", static_cast<double>(LayerMode::All));
  enter();
  const FoldedState& bird = *hand.session.document().state();
  EXPECT_TRUE(isFlat(bird));
  EXPECT_EQ(test::orderViolations(bird), std::vector<std::string>());
}

}  // namespace
}  // namespace kiri
