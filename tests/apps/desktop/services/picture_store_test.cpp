// Pictures that are kept between runs: found by what they were made of, and not too many.
// SPDX-License-Identifier: MIT
#include "apps/desktop/services/picture_store.h"

#include <gtest/gtest.h>

#include <QDir>
#include <QStandardPaths>
#include <QTest>

namespace kiri::desktop {
namespace {

class PictureStore : public ::testing::Test {
 protected:
  /// A folder of its own: other tests run beside this one.
  void SetUp() override {
    name_ = QCoreApplication::applicationName();
    QCoreApplication::setApplicationName(
        QString("pictures-%1").arg(QCoreApplication::applicationPid()));
  }
  void TearDown() override {
    clear();
    QCoreApplication::setApplicationName(name_);
  }
  static void clear() {
    QDir(QStandardPaths::writableLocation(QStandardPaths::CacheLocation)).removeRecursively();
  }
  static QImage filled(QColor color) {
    QImage image(8, 8, QImage::Format_ARGB32_Premultiplied);
    image.fill(color);
    return image;
  }
  static QImage kept(const QString& key) {
    return keptPicture(key).convertToFormat(QImage::Format_ARGB32_Premultiplied);
  }

 private:
  QString name_;
};

TEST_F(PictureStore, GivesBackWhatWasKeptForTheSameSourceAndDrawing) {
  const QString key = pictureKey("a model", "64");
  EXPECT_TRUE(keptPicture(key).isNull());
  keepPicture(key, filled(Qt::red));
  EXPECT_EQ(kept(key), filled(Qt::red));
  EXPECT_EQ(pictureKey("a model", "64"), key);
  EXPECT_NE(pictureKey("a model, changed", "64"), key);
  EXPECT_NE(pictureKey("a model", "128"), key);
}

TEST_F(PictureStore, ForgetsThoseThatWereNotAskedForForTheLongestTime) {
  const auto keyOf = [](int i) { return pictureKey("model", QString::number(i)); };
  for (int i = 0; i < 5; ++i) {
    keepPicture(keyOf(i), filled(Qt::blue));
    QTest::qWait(20);
  }
  EXPECT_FALSE(keptPicture(keyOf(0)).isNull()) << "asked for again";
  forgetOldPictures(2);
  EXPECT_FALSE(keptPicture(keyOf(0)).isNull());
  EXPECT_FALSE(keptPicture(keyOf(4)).isNull());
  for (const int gone : {1, 2, 3}) EXPECT_TRUE(keptPicture(keyOf(gone)).isNull());
}

TEST_F(PictureStore, ADamagedPictureIsNone) {
  const QString key = pictureKey("a model", "64");
  keepPicture(key, filled(Qt::red));
  const QDir folder(QStandardPaths::writableLocation(QStandardPaths::CacheLocation) + "/pictures");
  for (const QString& name : folder.entryList(QDir::Files)) {
    QFile file(folder.filePath(name));
    ASSERT_TRUE(file.resize(20));
  }
  EXPECT_TRUE(keptPicture(key).isNull());
}

}  // namespace
}  // namespace kiri::desktop
