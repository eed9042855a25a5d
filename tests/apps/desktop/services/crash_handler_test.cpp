// Crashes on purpose, in child processes, and what they leave behind.
// SPDX-License-Identifier: MIT
#include "apps/desktop/services/crash_handler.h"

#include <gtest/gtest.h>
#include <signal.h>

#include <QFile>
#include <QTemporaryDir>
#include <cstdlib>
#include <stdexcept>

#include "core/base/check.h"

namespace kiri::desktop {
namespace {

/// Deeper than any stack.
int overflow(int depth) {
  volatile char room[4096];
  room[0] = static_cast<char>(depth);
  return depth == -1 ? 0 : overflow(depth + 1) + room[0];
}

class CrashHandler : public ::testing::Test {
 protected:
  CrashHandler() { ::testing::FLAGS_gtest_death_test_style = "fast"; }
  /// The only report that is left.
  QString text() {
    const std::vector<CrashReport> reports = crashReportsIn(folder_.path());
    EXPECT_EQ(reports.size(), 1U);
    return reports.empty() ? QString() : reports[0].text;
  }
  void install() { installCrashHandler(folder_.path(), "9.8.7"); }
  QTemporaryDir folder_;
};

TEST_F(CrashHandler, ASignalLeavesAReportAndStillEndsTheProgramAsBefore) {
  for (const int signal : {SIGSEGV, SIGABRT, SIGFPE, SIGILL, SIGBUS}) {
    discardReports(folder_.path());
    EXPECT_EXIT(
        {
          install();
          ::raise(signal);
        },
        ::testing::KilledBySignal(signal), "KiriSim has crashed.*A report is in .*crash-");
    EXPECT_TRUE(text().startsWith("KiriSim 9.8.7, Qt 6")) << text().toStdString();
    EXPECT_TRUE(text().contains("ended by: SIG"));
  }
}

TEST_F(CrashHandler, AnExceptionThatNobodyCatchesIsQuoted) {
  EXPECT_EXIT(
      {
        install();
        []() noexcept { KIRI_CHECK(false, "paper does not stretch"); }();
      },
      ::testing::KilledBySignal(SIGABRT), "KiriSim has crashed");
  EXPECT_TRUE(text().contains("because this did not hold: paper does not stretch ("));
}

TEST_F(CrashHandler, AnOverflownStackIsReportedToo) {
  EXPECT_EXIT(
      {
        install();
        std::exit(overflow(0));
      },
      ::testing::KilledBySignal(SIGSEGV), "KiriSim has crashed");
  EXPECT_TRUE(text().contains("SIGSEGV"));
}

TEST_F(CrashHandler, AFolderThatCannotBeWrittenToDoesNotHinderTheEnd) {
  EXPECT_EXIT(
      {
        installCrashHandler("/proc/nowhere", "1");
        ::raise(SIGSEGV);
      },
      ::testing::KilledBySignal(SIGSEGV), "KiriSim has crashed");
}

TEST_F(CrashHandler, ReportsAreShownOnce) {
  QFile file(folder_.filePath("crash-1.txt"));
  ASSERT_TRUE(file.open(QIODevice::WriteOnly));
  file.write("what happened");
  file.close();
  EXPECT_EQ(text(), "what happened");
  discardReports(folder_.path());
  EXPECT_TRUE(crashReportsIn(folder_.path()).empty());
}

}  // namespace
}  // namespace kiri::desktop
