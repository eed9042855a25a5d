// Any tool takes any events in any order: no defect, and what it offers applies or says why not.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "core/model/apply.h"
#include "core/model/model.h"
#include "tests/editor/tools/tool_driver.h"
#include "tests/support/model_text.h"
#include "tests/support/random_steps.h"
#include "tests/support/state_check.h"

namespace kiri::test {
namespace {

const ToolId kTools[] = {ToolId::Fold,   ToolId::Line,    ToolId::Angle,       ToolId::AddEdge,
                         ToolId::Tear,   ToolId::Mend,    ToolId::StraightCut, ToolId::CurveCut,
                         ToolId::Select, ToolId::Measure, ToolId::TopLayer};

FoldedState randomState(Random& random) {
  const Model model = randomSheet(random);
  FoldedState state = startOf(model);
  RandomStepOptions options;
  options.facetLimit = 16;
  const std::size_t steps = random.below(6);
  for (std::size_t i = 0; i < steps; ++i) {
    auto next = apply(state, randomStep(random, state, options), static_cast<int>(i) + 1);
    if (next) state = std::move(*next);
  }
  return state;
}

PointerEvent randomPointer(Random& random) {
  PointerEvent event;
  const PointerAction actions[] = {PointerAction::Press,       PointerAction::Move,
                                   PointerAction::Move,        PointerAction::Move,
                                   PointerAction::Release,     PointerAction::Release,
                                   PointerAction::DoubleClick, PointerAction::Leave};
  event.action = actions[random.below(8)];
  event.pane = random.chance(0.7) ? Pane::Model : Pane::Sheet;
  event.at = {random.between(-20, 820), random.between(-20, 620)};
  if (event.pane == Pane::Sheet) event.at.x /= 2;
  event.button = random.chance(0.9) ? PointerButton::Left : PointerButton::Right;
  event.modifiers = {random.chance(0.15), random.chance(0.15), random.chance(0.15)};
  event.isTouch = random.chance(0.1);
  return event;
}

KeyEvent randomKey(Random& random) {
  const Key keys[] = {Key::Escape, Key::Enter, Key::Backspace, Key::Delete, Key::Tab,
                      Key::Left,   Key::Right, Key::Up,        Key::Down,   Key::Space};
  KeyEvent event;
  const std::size_t which = random.below(14);
  if (which < 10) {
    event.key = keys[which];
  } else {
    event.character = "vmax"[which - 10];
  }
  event.isPress = random.chance(0.8);
  return event;
}

void setAnyField(ToolDriver& hand, Random& random) {
  const std::vector<Field> fields = hand.tool().fields(hand.scope());
  if (fields.empty()) return;
  const Field& field = fields[random.below(fields.size())];
  if (field.kind == Field::Kind::Text) {
    hand.set(field.id, "any");
    return;
  }
  const double values[] = {0,
                           1,
                           2,
                           3,
                           -1,
                           90,
                           180,
                           1e9,
                           random.between(-200, 200),
                           static_cast<double>(random.below(11))};
  hand.set(field.id, values[random.below(10)]);
}

void anything(ToolDriver& hand, Random& random) {
  const double what = random.unit();
  if (what < 0.72) {
    hand.send(randomPointer(random));
  } else if (what < 0.84) {
    hand.send(randomKey(random));
  } else if (what < 0.88) {
    hand.send(WheelEvent{
        Pane::Model, {400, 300}, random.between(-2, 2), {false, random.chance(0.8), false}});
  } else if (what < 0.96) {
    setAnyField(hand, random);
  } else if (what < 0.98) {
    hand.camera.turn(random.between(-90, 90), random.between(-90, 90));
  } else {
    hand.camera.zoom({400, 300}, random.between(0.5, 2));
    hand.snaps.isOn = random.chance(0.7);
  }
}

/// What must hold after any event.
void expectSane(const ToolDriver& hand, const Tool& tool) {
  const Scope scope = hand.scope();
  const std::size_t facets = hand.state().pattern.facets.size();
  for (const Mark& mark : tool.marks(scope)) {
    const auto check = [&](const MarkPlace& place) {
      if (const auto* spot = std::get_if<Spot>(&place)) {
        ASSERT_LT(spot->facet.index, facets);
      }
    };
    if (const auto* path = std::get_if<PathMark>(&mark)) {
      for (const MarkPlace& place : path->places) check(place);
    }
    if (const auto* point = std::get_if<PointMark>(&mark)) check(point->at);
    if (const auto* text = std::get_if<TextMark>(&mark)) check(text->at);
    if (const auto* dial = std::get_if<DialMark>(&mark)) check(dial->at);
  }
  for (const TintedFacet& tinted : tool.tints(scope)) ASSERT_LT(tinted.facet.index, facets);
  const auto offered = tool.proposal(scope);
  if (offered) {
    const auto after = apply(hand.state(), offered->step, scope.number);
    if (!after) {
      ASSERT_FALSE(after.error().message.empty());
    }
    if (std::holds_alternative<FoldStep>(offered->step.action)) {
      ASSERT_EQ(textOf(offered->step).find("m:"), std::string::npos) << textOf(offered->step);
    }
  }
}

class AnyEvents : public ::testing::TestWithParam<ToolId> {};

TEST_P(AnyEvents, NeverBreakATool) {
  constexpr std::uint64_t kStates = 40;
  constexpr int kEvents = 100;
  int offered = 0;
  int committed = 0;
  for (std::uint64_t s = 0; s < kStates; ++s) {
    const std::uint64_t seed = 1000 * static_cast<std::uint64_t>(GetParam()) + s;
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    ToolDriver hand(GetParam(), randomState(random));
    for (int i = 0; i < kEvents; ++i) {
      ASSERT_NO_THROW(anything(hand, random)) << "event " << i;
      ASSERT_NO_THROW(expectSane(hand, hand.tool())) << "event " << i;
      if (HasFatalFailure()) return;
      offered += hand.proposal().has_value();
    }
    committed += static_cast<int>(hand.steps().size());
    EXPECT_EQ(joined(patternViolations(hand.state().pattern)), "");
    EXPECT_EQ(joined(poseViolations(hand.state())), "");
    hand.tool().reset();
    EXPECT_FALSE(hand.tool().isBusy());
    EXPECT_FALSE(hand.proposal());
  }
  const bool offers = GetParam() == ToolId::Fold || GetParam() == ToolId::Line;
  if (offers) {
    EXPECT_GT(offered, 100);
    EXPECT_GT(committed, 0);
  }
}

INSTANTIATE_TEST_SUITE_P(Tools, AnyEvents, ::testing::ValuesIn(kTools));

}  // namespace
}  // namespace kiri::test
