// Runs tests of the window: the application object lives as long as the tests do.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <QApplication>
#include <QStandardPaths>

int main(int argc, char** argv) {
  ::testing::InitGoogleTest(&argc, argv);
  if (::testing::GTEST_FLAG(list_tests)) return RUN_ALL_TESTS();
  QStandardPaths::setTestModeEnabled(true);  // settings and journals of tests are not the person's
  QApplication application(argc, argv);
  QApplication::setApplicationName("kirisim");
  QApplication::setOrganizationName("KiriSim");
  return RUN_ALL_TESTS();
}
