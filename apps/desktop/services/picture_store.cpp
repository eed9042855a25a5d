// Small pictures that took work, kept on the disk from one run to the next.
// SPDX-License-Identifier: MIT
#include "apps/desktop/services/picture_store.h"

#include <QCoreApplication>
#include <QCryptographicHash>
#include <QDateTime>
#include <QDir>
#include <QSaveFile>
#include <QStandardPaths>

namespace kiri::desktop {

namespace {

/// Counts up when pictures are drawn differently within one version of the program.
constexpr int kDrawing = 1;
constexpr const char* kEnding = ".png";

QDir folder() {
  return {QStandardPaths::writableLocation(QStandardPaths::CacheLocation) + "/pictures"};
}

QString fileOf(const QString& key) { return folder().filePath(key + kEnding); }

}  // namespace

QString pictureKey(std::string_view source, const QString& how) {
  QCryptographicHash hash(QCryptographicHash::Sha1);
  hash.addData(QStringLiteral("%1 %2 %3\n")
                   .arg(QCoreApplication::applicationVersion())
                   .arg(kDrawing)
                   .arg(how)
                   .toUtf8());
  hash.addData(QByteArrayView(source.data(), static_cast<qsizetype>(source.size())));
  return QString::fromLatin1(hash.result().toHex());
}

QImage keptPicture(const QString& key) {
  QFile file(fileOf(key));
  if (!file.open(QIODevice::ReadOnly)) return {};
  QImage picture;
  if (!picture.load(&file, "PNG")) return {};
  file.setFileTime(QDateTime::currentDateTime(), QFileDevice::FileModificationTime);
  return picture;
}

void keepPicture(const QString& key, const QImage& picture) {
  if (!QDir().mkpath(folder().path())) return;
  QSaveFile file(fileOf(key));
  if (!file.open(QIODevice::WriteOnly)) return;
  if (picture.save(&file, "PNG")) file.commit();
}

void forgetOldPictures(int most) {
  const QFileInfoList files =
      folder().entryInfoList({QStringLiteral("*") + kEnding}, QDir::Files, QDir::Time);
  for (qsizetype i = most; i < files.size(); ++i) QFile::remove(files[i].filePath());
}

}  // namespace kiri::desktop
