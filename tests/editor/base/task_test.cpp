// Long work: only the newest counts.
// SPDX-License-Identifier: MIT
#include "editor/base/task.h"

#include <gtest/gtest.h>

#include <optional>
#include <vector>

#include "editor/base/phrase.h"
#include "tests/editor/base/hand_runner.h"

namespace kiri {
namespace {

Task noting(std::vector<int>& notes, int number) {
  return {{}, {}, [&notes, number] { notes.push_back(number); }};
}

TEST(LatestTask, DropsWhatWasAskedForBetween) {
  HandRunner runner;
  LatestTask latest(runner);
  std::vector<int> notes;
  for (int i = 1; i <= 4; ++i) latest.ask(noting(notes, i));
  EXPECT_EQ(runner.waitingCount(), 1u);
  runner.runAll();
  EXPECT_EQ(notes, (std::vector<int>{4}));
  EXPECT_FALSE(latest.isBusy());
}

TEST(LatestTask, AsksTheRunningWorkToStop) {
  HandRunner runner;
  LatestTask latest(runner);
  bool isStopped = false;
  latest.ask({{}, [&](const Progress& progress) { isStopped = !goesOn(progress, 0.5); }, {}});
  latest.ask({});
  runner.runAll();
  EXPECT_TRUE(isStopped);
}

TEST(LatestTask, LetsWorkThatMayEndEndAndDoesTheNewestNext) {
  HandRunner runner;
  LatestTask latest(runner, LatestTask::Overtaken::MayEnd);
  std::vector<int> notes;
  bool isStopped = false;
  latest.ask({{},
              [&](const Progress& progress) { isStopped = !goesOn(progress, 0.5); },
              [&] { notes.push_back(1); }});
  latest.ask(noting(notes, 2));
  latest.ask(noting(notes, 3));
  runner.runAll();
  EXPECT_FALSE(isStopped);
  EXPECT_EQ(notes, (std::vector<int>{1, 3}));
  latest.ask(noting(notes, 4));
  latest.clear();
  runner.runAll();
  EXPECT_EQ(notes, (std::vector<int>{1, 3})) << "what is cleared says nothing more";
}

TEST(LatestTask, SaysNothingMoreWhenCleared) {
  HandRunner runner;
  LatestTask latest(runner);
  std::vector<int> notes;
  latest.ask(noting(notes, 1));
  latest.clear();
  runner.runAll();
  EXPECT_TRUE(notes.empty());
  latest.ask(noting(notes, 2));
  runner.runAll();
  EXPECT_EQ(notes, (std::vector<int>{2}));
}

TEST(LatestTask, MayBeGoneBeforeItsWorkEnds) {
  HandRunner runner;
  std::vector<int> notes;
  {
    LatestTask latest(runner);
    latest.ask(noting(notes, 1));
  }
  runner.runAll();
  EXPECT_TRUE(notes.empty());
}

TEST(LatestTask, MayAskAgainWhenItIsDone) {
  DirectRunner runner;
  LatestTask latest(runner);
  std::vector<int> notes;
  latest.ask({{}, {}, [&] {
                notes.push_back(1);
                if (notes.size() < 3) latest.ask(noting(notes, 2));
              }});
  EXPECT_EQ(notes, (std::vector<int>{1, 2}));
  EXPECT_FALSE(latest.isBusy());
}

TEST(Phrase, PutsArgumentsInTheirPlaces) {
  EXPECT_EQ(inEnglish({"fold %1 at %2, 100%", {"3", "90°"}}), "fold 3 at 90°, 100%");
  EXPECT_EQ(inEnglish({"%2 before %1, no %3", {"b", "a"}}), "a before b, no %3");
}

}  // namespace
}  // namespace kiri
