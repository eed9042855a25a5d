// Small pictures that took work, kept on the disk from one run to the next.
// SPDX-License-Identifier: MIT
#pragma once

#include <QImage>
#include <QString>
#include <string_view>

namespace kiri::desktop {

/// What a picture was made of: the bytes of its source, and how it was drawn. Another version of
/// the program is another key.
QString pictureKey(std::string_view source, const QString& how);

/// Null: it is not kept. These may be called on any thread; a disk that is full or not to be
/// written costs the time to make pictures again, no more.
QImage keptPicture(const QString& key);
void keepPicture(const QString& key, const QImage& picture);

/// Forgets the pictures that were not asked for for the longest time, so that `most` are left.
void forgetOldPictures(int most = 600);

}  // namespace kiri::desktop
