// What tests of dialogs share: models, a runner, and pictures to be looked at.
// SPDX-License-Identifier: MIT
#pragma once

#include <gtest/gtest.h>

#include <QApplication>
#include <QDir>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QTest>
#include <QWidget>
#include <functional>
#include <string>

#include "apps/desktop/look/theme.h"
#include "apps/desktop/services/export_source.h"
#include "apps/desktop/services/pool_runner.h"
#include "apps/desktop/services/settings.h"
#include "editor/document/document.h"
#include "io/file.h"
#include "io/kiri_reader.h"
#include "render/visibility/view_frame.h"

namespace kiri::desktop::test {

inline std::string examplePath(const std::string& name) {
  return std::string(KIRI_SOURCE_DIR) + "/examples/" + name + ".kiri";
}

inline Document exampleDocument(const std::string& name) {
  const std::string path = examplePath(name);
  Document document =
      Document::create(readKiri(readFile(path).value(), path).value().model).value();
  document.setPath(path);
  return document;
}

inline ExportSource exampleSource(const std::string& name) {
  return exportSourceOf(exampleDocument(name), frontView());
}

/// Shows the widget and keeps a picture of it, light and dark, where KIRI_PICTURES says; the name
/// carries the scale. Without KIRI_PICTURES it is only shown and drawn.
inline void show(QWidget& widget, const QString& name) {
  widget.show();
  ASSERT_TRUE(QTest::qWaitForWindowExposed(&widget));
  const QString folder = qEnvironmentVariable("KIRI_PICTURES");
  for (const Shade shade : {Shade::Dark, Shade::Light}) {
    applyTheme(*qApp, shade);
    QTest::qWait(folder.isEmpty() ? 1 : 150);
    const QPixmap picture = widget.grab();
    ASSERT_FALSE(picture.isNull());
    if (folder.isEmpty()) continue;
    picture.save(QString("%1/%2-%3-%4x.png")
                     .arg(folder, name, shade == Shade::Dark ? "dark" : "light")
                     .arg(widget.devicePixelRatioF()));
  }
}

inline bool waitFor(const std::function<bool()>& holds, int ms = 20000) {
  return QTest::qWaitFor(holds, ms);
}

/// A runner, settings of their own and a folder that goes.
class DialogTest : public ::testing::Test {
 protected:
  DialogTest() { clearSettings(); }
  ~DialogTest() override { clearSettings(); }
  static void clearSettings() {
    QDir(QStandardPaths::writableLocation(QStandardPaths::AppConfigLocation)).removeRecursively();
  }
  QString path(const QString& name) const { return folder_.filePath(name); }
  std::string bytesOf(const QString& name) const {
    return readFile(path(name).toStdString()).value();
  }

  QTemporaryDir folder_;
  PoolRunner runner_;
  Settings settings_;
};

}  // namespace kiri::desktop::test
