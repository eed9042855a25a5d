// What is told about a step: the words that somebody wrote, of the step that is seen.
// SPDX-License-Identifier: MIT
#include "editor/session/caption.h"

#include <gtest/gtest.h>

#include "tests/editor/session/hand.h"

namespace kiri::test {
namespace {

Model toldModel() {
  Model model = modelOf("square 100; fold A valley 50,0 50,100 left; turn; unfold all");
  model.title = "Card";
  model.notes = "A card.";
  model.steps[0].title = "Fold in half";
  model.steps[0].notes = "Corner to corner.";
  return model;
}

TEST(Caption, TellsTheModelBeforeItsStepsAndThenEachStep) {
  const Model model = toldModel();
  const Caption whole = captionOf(model, 0);
  EXPECT_EQ(whole.title, "Card");
  EXPECT_EQ(whole.notes, "A card.");
  EXPECT_TRUE(whole.summary.isEmpty());
  const Caption first = captionOf(model, 1);
  EXPECT_EQ(first.title, "Fold in half");
  EXPECT_EQ(first.notes, "Corner to corner.");
  EXPECT_EQ(inEnglish(first.summary), "A: valley, 180°");
  EXPECT_EQ(first.steps, 3u);
  EXPECT_EQ(captionOf(model, 2).title, "") << "nobody named it";
  EXPECT_EQ(inEnglish(captionOf(model, 2).summary), "turn over");
}

TEST(Caption, AModelWithoutWordsIsNotTold) {
  Model model = modelOf("square 100; turn");
  model.title = "A title alone is in the title bar already";
  EXPECT_FALSE(isTold(model));
  model.steps[0].notes = "Turn it.";
  EXPECT_TRUE(isTold(model));
  EXPECT_TRUE(isTold(toldModel()));
}

TEST(Caption, FollowsTheCursorAndTheFilm) {
  DirectRunner runner;
  Hand hand(runner);
  hand.open(toldModel());
  EXPECT_EQ(stepLookedAt(hand.session), 3u);
  hand.session.jumpTo(1);
  EXPECT_EQ(stepLookedAt(hand.session), 1u);
  hand.session.openPlayer();
  ASSERT_TRUE(hand.session.isPlayerOpen());
  Player& player = hand.session.player();
  player.seek(0);
  EXPECT_EQ(stepLookedAt(hand.session), 0u) << "the sheet lies there";
  player.seek(1);  // after 0.6 s of rest the first fold is under way
  EXPECT_EQ(player.step(), 0u);
  EXPECT_EQ(stepLookedAt(hand.session), 1u);
  player.seekStep(1);
  EXPECT_EQ(stepLookedAt(hand.session), 1u) << "its outcome rests";
  player.seek(player.duration());
  EXPECT_EQ(stepLookedAt(hand.session), 3u);
}

}  // namespace
}  // namespace kiri::test
