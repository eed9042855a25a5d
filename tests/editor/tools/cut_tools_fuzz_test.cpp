// Random hands: whatever they do, a proposal applies or says what is wrong.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <limits>

#include "tests/editor/tools/tool_driver.h"
#include "tests/support/expect.h"
#include "tests/support/model_text.h"
#include "tests/support/random_steps.h"

namespace kiri::test {
namespace {

const char* const kModels[] = {
    "square 100",
    "square 100; fold A valley 50,0 50,100 left; edge @model 40,50 110,50",
    "square 100; edge 50,0 50,100; edge 0,50 100,50; tear 50,0 50,50 100,50",
    "square 100; fold A valley 70 50,0 50,100 left; fold B mountain 40 20,0 20,100 left in 40,50",
    "disc 100; fold A valley @model 0,50 100,50 left; fold B valley @model 50,0 50,100 left",
    "polygon 0,0 90,0 90,60 40,90 hole 20,20 40,20 30,40",
    "square 100; edge 50,0 50,100; tear 50,100 50,50; fold B valley 50,50 105,50 left facets 75,50",
};

class RandomHand {
 public:
  RandomHand(ToolId tool, std::string_view model, std::uint64_t seed)
      : tool_(tool), start_(run(model)), hand_(tool, start_), random_(seed) {}

  /// What became of the proposals.
  int applied = 0;
  int refused = 0;

  void act() {
    if (random_.chance(0.02)) hand_ = ToolDriver(tool_, start_);
    if (random_.chance(0.02)) turnEye();
    if (random_.chance(0.1)) hand_.pane = random_.chance(0.5) ? Pane::Model : Pane::Sheet;
    hand_.held = {random_.chance(0.1), random_.chance(0.2), random_.chance(0.2)};
    hand_.snaps.isOn = random_.chance(0.5);
    const double kind = random_.unit();
    if (kind < 0.75) {
      pointer();
    } else if (kind < 0.88) {
      hand_.send(
          KeyEvent{keys_[random_.below(std::size(keys_))], '+', hand_.held, random_.chance(0.9)});
    } else if (kind < 0.92) {
      hand_.wheel(place(), random_.chance(0.5) ? 1 : -1);
    } else {
      field();
    }
    look();
  }

 private:
  Vec2 place() {
    // Often the corners and middles of things, for there the special cases are.
    if (random_.chance(0.5)) {
      const double grid[] = {-20, 0, 25, 50, 75, 100, 130};
      return {grid[random_.below(7)], grid[random_.below(7)]};
    }
    return {random_.between(-40, 140), random_.between(-40, 140)};
  }

  void turnEye() {
    hand_.camera.turn(random_.between(-80, 80), random_.between(-80, 80));
    hand_.camera.zoom({400, 300}, random_.between(0.5, 2));
    hand_.camera.setPerspective(random_.chance(0.3) ? 40 : 0);
  }

  void pointer() {
    PointerEvent event;
    const double kind = random_.unit();
    event.action = kind < 0.3    ? PointerAction::Press
                   : kind < 0.65 ? PointerAction::Move
                   : kind < 0.93 ? PointerAction::Release
                   : kind < 0.97 ? PointerAction::DoubleClick
                                 : PointerAction::Leave;
    event.pane = hand_.pane;
    event.at = hand_.pixels(place());
    event.button = random_.chance(0.95) ? PointerButton::Left : PointerButton::Right;
    event.modifiers = hand_.held;
    event.isTouch = random_.chance(0.1);
    hand_.send(event);
  }

  void field() {
    const std::vector<Field> fields = hand_.tool().fields(hand_.scope());
    if (fields.empty() || random_.chance(0.05)) {
      hand_.set("no such field", 1);
      return;
    }
    const double odd[] = {0,
                          1,
                          2,
                          3,
                          -1,
                          50,
                          1e6,
                          -1e6,
                          std::numeric_limits<double>::quiet_NaN(),
                          std::numeric_limits<double>::infinity()};
    hand_.set(fields[random_.below(fields.size())].id, odd[random_.below(std::size(odd))]);
  }

  void look() {
    const Scope scope = hand_.scope();
    EXPECT_FALSE(inEnglish(hand_.tool().hint(scope)).empty());
    for (const Mark& mark : hand_.tool().marks(scope)) {
      if (const auto* path = std::get_if<PathMark>(&mark)) EXPECT_GE(path->places.size(), 2U);
    }
    hand_.tool().cursor(scope);
    if (!hand_.proposal()) return;
    const auto after = hand_.result();
    if (!after) {
      EXPECT_FALSE(after.error().message.empty());
      ++refused;
      return;
    }
    ++applied;
    if (applied % 16 == 0) EXPECT_TRUE(isSound(*after)) << textOf(hand_.step());
  }

  static constexpr Key keys_[] = {Key::Escape, Key::Enter,  Key::Delete, Key::Backspace,
                                  Key::Tab,    Key::Insert, Key::Left,   Key::Right,
                                  Key::Up,     Key::Down,   Key::Space,  Key::Character};
  ToolId tool_;
  FoldedState start_;
  ToolDriver hand_;
  Random random_;
};

class CutToolsFuzz : public testing::TestWithParam<ToolId> {};

TEST_P(CutToolsFuzz, ProposalsApplyOrSayWhatIsWrong) {
  constexpr int kEvents = 1500;
  int applied = 0;
  int events = 0;
  for (std::size_t m = 0; m < std::size(kModels); ++m) {
    const std::uint64_t seed = 1000 * static_cast<std::uint64_t>(GetParam()) + m;
    SCOPED_TRACE(std::string(kModels[m]) + ", seed " + std::to_string(seed));
    RandomHand hand(GetParam(), kModels[m], seed);
    for (int i = 0; i < kEvents; ++i, ++events) ASSERT_NO_THROW(hand.act()) << "event " << i;
    applied += hand.applied;
  }
  EXPECT_GE(events, 10000);
  EXPECT_GT(applied, 20);
}

INSTANTIATE_TEST_SUITE_P(Tools, CutToolsFuzz,
                         testing::Values(ToolId::CurveCut, ToolId::StraightCut, ToolId::AddEdge,
                                         ToolId::Tear, ToolId::Mend));

}  // namespace
}  // namespace kiri::test
