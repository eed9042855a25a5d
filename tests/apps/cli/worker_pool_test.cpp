// Pieces of work on several threads: each once, watched, stopped, and their defects told.
// SPDX-License-Identifier: MIT
#include "apps/cli/worker_pool.h"

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>

namespace kiri::cli {
namespace {

const auto kGoOn = [](const PoolView&) { return true; };

TEST(WorkerPool, DoesEveryPieceOnceOnAnyNumberOfThreads) {
  for (const std::size_t threads : {0U, 1U, 2U, 7U}) {
    std::vector<std::atomic<int>> done(50);
    EXPECT_TRUE(inParallel(
        done.size(), threads, [&](std::size_t i, const std::atomic<bool>&) { ++done[i]; }, kGoOn));
    for (const std::atomic<int>& times : done) EXPECT_EQ(times, 1) << threads;
  }
  EXPECT_TRUE(inParallel(
      0, 2, [](std::size_t, const std::atomic<bool>&) { ADD_FAILURE(); }, kGoOn));
}

TEST(WorkerPool, TheWatchSeesTheWorkGrowAndNeverMoreThanTheThreadsAtWork) {
  std::size_t before = 0;
  inParallel(
      20, 3, [](std::size_t, const std::atomic<bool>&) {},
      [&](const PoolView& view) {
        EXPECT_GE(view.done, before);
        EXPECT_LE(view.atWork.size(), 3U);
        EXPECT_LE(view.done + view.atWork.size(), 20U);
        before = view.done;
        return true;
      });
}

TEST(WorkerPool, StopsWhatIsAtWorkAndBeginsNothingMore) {
  std::atomic<int> begun{0};
  const bool isAll = inParallel(
      100, 2,
      [&](std::size_t, const std::atomic<bool>& stop) {
        ++begun;
        while (!stop) {
        }
      },
      [&](const PoolView& view) { return view.atWork.size() < 2; });
  EXPECT_FALSE(isAll);
  EXPECT_EQ(begun, 2);
}

TEST(WorkerPool, BeginsNothingWhenItIsStoppedBefore) {
  EXPECT_FALSE(inParallel(
      3, 2, [](std::size_t, const std::atomic<bool>&) { ADD_FAILURE(); },
      [](const PoolView&) { return false; }));
}

TEST(WorkerPool, ThrowsTheFirstDefectWhenAllIsQuiet) {
  std::atomic<int> atWork{0};
  try {
    inParallel(
        4, 4,
        [&](std::size_t i, const std::atomic<bool>&) {
          ++atWork;
          while (atWork < 4) {
          }
          if (i % 2 == 1) throw std::runtime_error("piece " + std::to_string(i));
        },
        kGoOn);
    FAIL() << "nothing was thrown";
  } catch (const std::runtime_error& defect) {
    EXPECT_EQ(std::string(defect.what()), "piece 1");
  }
}

}  // namespace
}  // namespace kiri::cli
