// The window's runner: work beside the window, results in it.
// SPDX-License-Identifier: MIT
#include "apps/desktop/services/pool_runner.h"

#include <gtest/gtest.h>

#include <QCoreApplication>
#include <QElapsedTimer>
#include <QSemaphore>
#include <QSignalSpy>
#include <QTest>
#include <QThread>
#include <atomic>
#include <functional>
#include <memory>
#include <vector>

#include "core/base/check.h"

namespace kiri::desktop {
namespace {

bool waitFor(const std::function<bool()>& holds) { return QTest::qWaitFor(holds, 5000); }

TEST(PoolRunner, WorksOnAnotherThreadAndReportsOnThisOne) {
  PoolRunner runner;
  QThread* worked = nullptr;
  QThread* reported = nullptr;
  runner.start({{},
                [&](const Progress&) { worked = QThread::currentThread(); },
                [&] { reported = QThread::currentThread(); }});
  EXPECT_EQ(reported, nullptr) << "never from inside start";
  ASSERT_TRUE(waitFor([&] { return reported != nullptr; }));
  EXPECT_NE(worked, QThread::currentThread());
  EXPECT_EQ(reported, QThread::currentThread());
  EXPECT_EQ(runner.pending(), 0U);
}

TEST(PoolRunner, ReportsInTheOrderInWhichWorkEnds) {
  PoolRunner runner(2);
  QSemaphore gate;
  std::vector<int> order;
  runner.start({{}, [&](const Progress&) { gate.acquire(); }, [&] { order.push_back(1); }});
  runner.start({{}, [](const Progress&) {}, [&] { order.push_back(2); }});
  ASSERT_TRUE(waitFor([&] { return order.size() == 1; }));
  gate.release();
  ASSERT_TRUE(waitFor([&] { return order.size() == 2; }));
  EXPECT_EQ(order, (std::vector<int>{2, 1}));
}

TEST(PoolRunner, OneThreadKeepsTheOrderOfStarting) {
  PoolRunner runner(1);
  std::vector<int> order;
  for (int i = 0; i < 200; ++i)
    runner.start({{}, [](const Progress&) {}, [&order, i] { order.push_back(i); }});
  ASSERT_TRUE(waitFor([&] { return order.size() == 200; }));
  for (int i = 0; i < 200; ++i) EXPECT_EQ(order[static_cast<std::size_t>(i)], i);
}

TEST(PoolRunner, CancelIsSeenByTheWorkAndStillReportsOnce) {
  PoolRunner runner;
  std::atomic<bool> hasStopped = false;
  QSemaphore begun;
  int reports = 0;
  const TaskId id = runner.start({{},
                                  [&](const Progress& progress) {
                                    begun.release();
                                    while (goesOn(progress, 0.5)) QThread::msleep(1);
                                    hasStopped = true;
                                  },
                                  [&] { ++reports; }});
  begun.acquire();
  runner.cancel(id);
  ASSERT_TRUE(waitFor([&] { return reports == 1; }));
  EXPECT_TRUE(hasStopped);
  runner.cancel(id);
  QTest::qWait(20);
  EXPECT_EQ(reports, 1);
}

TEST(PoolRunner, WorkThatWasCancelledBeforeItBeganIsNotBegun) {
  PoolRunner runner(1);
  QSemaphore gate;
  bool isBegun = false;
  bool isReported = false;
  runner.start({{}, [&](const Progress&) { gate.acquire(); }, {}});
  const TaskId second =
      runner.start({{}, [&](const Progress&) { isBegun = true; }, [&] { isReported = true; }});
  runner.cancel(second);
  gate.release();
  ASSERT_TRUE(waitFor([&] { return isReported; }));
  EXPECT_FALSE(isBegun);
}

TEST(PoolRunner, NothingIsReportedAfterItIsGoneAndItsWorkHasEnded) {
  std::atomic<int> running = 0;
  int reports = 0;
  {
    PoolRunner runner(3);
    QSemaphore begun;
    for (int i = 0; i < 8; ++i) {
      runner.start({{"working", {}},
                    [&](const Progress& progress) {
                      ++running;
                      begun.release();
                      while (goesOn(progress, 0)) QThread::msleep(1);
                      --running;
                    },
                    [&] { ++reports; }});
    }
    begun.acquire(3);
  }
  EXPECT_EQ(running, 0);
  QCoreApplication::sendPostedEvents();
  QTest::qWait(20);
  EXPECT_EQ(reports, 0);
}

TEST(PoolRunner, LatestTaskKeepsOnlyTheNewestAsking) {
  PoolRunner runner;
  LatestTask latest(runner);
  std::vector<int> reported;
  for (int i = 0; i < 50; ++i) {
    latest.ask({{},
                [](const Progress& progress) {
                  for (int k = 0; k < 20 && goesOn(progress, 0); ++k) QThread::msleep(1);
                },
                [&reported, i] { reported.push_back(i); }});
  }
  ASSERT_TRUE(waitFor([&] { return !latest.isBusy(); }));
  EXPECT_EQ(reported, std::vector<int>{49});
}

TEST(PoolRunner, ALatestTaskThatGoesFirstIsNotReported) {
  PoolRunner runner;
  bool isReported = false;
  {
    LatestTask latest(runner);
    latest.ask({{}, [](const Progress&) { QThread::msleep(10); }, [&] { isReported = true; }});
  }
  ASSERT_TRUE(waitFor([&] { return runner.pending() == 0; }));
  EXPECT_FALSE(isReported);
}

TEST(PoolRunner, TellsOfNamedWorkOnlyWhenItTakesLong) {
  PoolRunner runner;
  QSignalSpy changes(&runner, &PoolRunner::busyChanged);
  bool isDone = false;
  runner.start(
      {{"quick", {}}, [](const Progress&) { QThread::msleep(20); }, [&] { isDone = true; }});
  ASSERT_TRUE(waitFor([&] { return isDone; }));
  QTest::qWait(250);
  EXPECT_EQ(changes.count(), 0);

  isDone = false;
  runner.start({{"Folding %1", {"leaf"}},
                [](const Progress& progress) {
                  for (int i = 0; i < 400 && goesOn(progress, i / 400.0); ++i) QThread::msleep(1);
                },
                [&] { isDone = true; }});
  ASSERT_TRUE(waitFor([&] { return runner.busy().has_value(); }));
  EXPECT_EQ(inEnglish(runner.busy()->what), "Folding leaf");
  const double before = runner.busy()->done;
  ASSERT_TRUE(waitFor([&] { return !runner.busy() || runner.busy()->done > before; }));
  EXPECT_TRUE(runner.busy()) << "progress grows while it is shown";
  ASSERT_TRUE(waitFor([&] { return isDone; }));
  EXPECT_FALSE(runner.busy());
  EXPECT_GE(changes.count(), 3);
}

TEST(PoolRunner, UnnamedWorkIsNeverShown) {
  PoolRunner runner;
  QSignalSpy changes(&runner, &PoolRunner::busyChanged);
  bool isDone = false;
  runner.start({{}, [](const Progress&) { QThread::msleep(300); }, [&] { isDone = true; }});
  ASSERT_TRUE(waitFor([&] { return isDone; }));
  EXPECT_EQ(changes.count(), 0);
}

TEST(PoolRunner, ADefectInWorkIsToldAndTheTaskIsReportedAsNotBegun) {
  PoolRunner runner;
  QSignalSpy defects(&runner, &PoolRunner::defectFound);
  bool isDone = false;
  runner.start({{},
                [](const Progress&) { KIRI_CHECK(1 + 1 == 3, "numbers add up"); },
                [&] { isDone = true; }});
  ASSERT_TRUE(waitFor([&] { return isDone; }));
  ASSERT_EQ(defects.count(), 1);
  EXPECT_TRUE(defects[0][0].toString().startsWith("numbers add up ("));
}

TEST(PoolRunner, TheWindowIsNotKeptWaitingByLongWork) {
  PoolRunner runner(2);
  for (int i = 0; i < 2; ++i) {
    runner.start({{"busy", {}},
                  [](const Progress& progress) {
                    while (goesOn(progress, 0)) QThread::msleep(1);
                  },
                  {}});
  }
  QElapsedTimer clock;
  clock.start();
  qint64 longest = 0;
  while (clock.elapsed() < 300) {
    QElapsedTimer turn;
    turn.start();
    QCoreApplication::processEvents();
    longest = std::max(longest, turn.elapsed());
    QThread::msleep(2);
  }
  EXPECT_LT(longest, 100);
}

}  // namespace
}  // namespace kiri::desktop
