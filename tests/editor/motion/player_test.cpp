// The player: it shows what the time line says, whatever is pressed.
// SPDX-License-Identifier: MIT
#include "editor/motion/player.h"

#include <gtest/gtest.h>

#include "tests/support/model_text.h"
#include "tests/support/random_steps.h"
#include "tests/support/state_text.h"

namespace kiri::test {
namespace {

std::shared_ptr<const Timeline> filmOf(const char* text, const TimelineOptions& options = {}) {
  return std::make_shared<const Timeline>(Timeline::of(modelOf(text), options).value());
}

const char* const kModel =
    "square 100; fold A valley 50,0 50,100 left; turn; fold B mountain 90 @model 40,50 110,50 left;"
    "unfold all";

Player loaded(const char* text = kModel) {
  Player player;
  player.load(filmOf(text));
  return player;
}

/// The time when `done` steps are done, found from the phases.
double timeOf(const Timeline& film, std::size_t done) {
  for (const Phase& phase : film.phases()) {
    if (phase.isResting && phase.step == done) return phase.start;
  }
  return film.duration();
}

TEST(Player, WithoutAFilmDoesNothing) {
  Player player;
  player.play();
  player.skip(1);
  player.seek(3);
  EXPECT_FALSE(player.isPlaying());
  EXPECT_FALSE(player.advance(1));
  EXPECT_EQ(player.seconds(), 0);
  EXPECT_EQ(player.step(), 0u);
}

TEST(Player, PlaysToTheEndAndStops) {
  Player player = loaded();
  EXPECT_FALSE(player.advance(1)) << "not playing yet";
  player.play();
  while (player.isPlaying()) player.advance(0.25);
  EXPECT_EQ(player.seconds(), player.duration());
  EXPECT_EQ(player.step(), 4u);
  player.play();
  EXPECT_EQ(player.seconds(), 0) << "from the start when it stands at the end";
}

TEST(Player, TimePassesBySpeed) {
  Player player = loaded();
  player.setSpeed(2);
  player.play();
  player.advance(0.5);
  EXPECT_DOUBLE_EQ(player.seconds(), 1);
  player.setSpeed(1000);
  EXPECT_EQ(player.speed(), Player::kFastest);
  player.setSpeed(0);
  EXPECT_EQ(player.speed(), Player::kSlowest);
}

TEST(Player, LoopsWithTheTimeThatIsLeft) {
  Player player = loaded();
  player.setLoops(true);
  player.play();
  player.seek(player.duration() - 0.1);
  player.advance(0.3);
  EXPECT_TRUE(player.isPlaying());
  EXPECT_NEAR(player.seconds(), 0.2, 1e-12);
  player.advance(10 * player.duration());
  EXPECT_NEAR(player.seconds(), 0.2, 1e-9);
}

TEST(Player, AFilmWithoutTimeCanLoop) {
  TimelineOptions options;
  options.startHold = options.endHold = options.hold = 0;
  Player player;
  player.load(filmOf("square 100", options));
  player.setLoops(true);
  player.play();
  EXPECT_FALSE(player.advance(1));
  EXPECT_EQ(player.seconds(), 0);
}

TEST(Player, SkipsToTheMomentsBetweenSteps) {
  Player player = loaded();
  const auto film = filmOf(kModel);
  for (std::size_t done = 1; done <= 4; ++done) {
    player.skip(1);
    EXPECT_DOUBLE_EQ(player.seconds(), timeOf(*film, done));
    EXPECT_EQ(player.step(), done);
  }
  player.skip(1);
  EXPECT_EQ(player.seconds(), player.duration());
  for (std::size_t done = 4; done-- > 0;) {
    player.skip(-1);
    EXPECT_DOUBLE_EQ(player.seconds(), timeOf(*film, done));
  }
  player.skip(-1);
  EXPECT_EQ(player.seconds(), 0);
}

TEST(Player, SkippingBackWithinAStepGoesToItsStart) {
  Player player = loaded();
  const auto film = filmOf(kModel);
  player.seek(timeOf(*film, 3) - 0.05);
  EXPECT_EQ(player.step(), 2u);
  player.skip(-1);
  EXPECT_DOUBLE_EQ(player.seconds(), timeOf(*film, 2));
  player.skip(-2);
  EXPECT_DOUBLE_EQ(player.seconds(), 0);
}

TEST(Player, ShowsWhatTheTimeLineSaysWhateverIsPressed) {
  const auto film = filmOf(kModel);
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    Random random(seed);
    Player player;
    player.load(film);
    for (int i = 0; i < 40; ++i) {
      const std::string before = textOf(player.state());
      switch (random.below(6)) {
        case 0:
          player.play();
          break;
        case 1:
          player.pause();
          break;
        case 2:
          player.seek(random.between(-1, film->duration() + 1));
          break;
        case 3:
          player.skip(static_cast<int>(random.below(5)) - 2);
          break;
        case 4:
          player.setLoops(random.chance(0.5));
          break;
        default: {
          const bool hasChanged = player.advance(random.between(0, 1));
          if (!hasChanged) {
            EXPECT_EQ(textOf(player.state()), before) << "seed " << seed;
          }
        }
      }
      ASSERT_GE(player.seconds(), 0);
      ASSERT_LE(player.seconds(), film->duration());
      EXPECT_EQ(textOf(player.state()), textOf(film->stateAt(player.seconds())));
      EXPECT_EQ(player.step(), film->momentAt(player.seconds()).step);
    }
  }
}

}  // namespace
}  // namespace kiri::test
