// Runs tests of the window: the application object lives as long as the tests do.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <QApplication>
#include <QStandardPaths>
#include <QTemporaryDir>

int main(int argc, char** argv) {
  ::testing::InitGoogleTest(&argc, argv);
  if (::testing::GTEST_FLAG(list_tests)) return RUN_ALL_TESTS();
  // Programs that run side by side do not find each other's settings.
  const QTemporaryDir home;
  qputenv("HOME", home.path().toLocal8Bit());
  QStandardPaths::setTestModeEnabled(true);  // settings and journals of tests are not the person's
  QApplication application(argc, argv);
  QApplication::setApplicationName("kirisim");
  QApplication::setOrganizationName("KiriSim");
  return RUN_ALL_TESTS();
}
