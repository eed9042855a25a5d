// Cards of model files, made beside the window and kept.
// SPDX-License-Identifier: MIT
#include "apps/desktop/services/model_cards.h"

#include <QDateTime>
#include <QFileInfo>
#include <QPointer>
#include <memory>
#include <utility>

#include "apps/desktop/services/picture_store.h"

namespace kiri::desktop {

namespace {

/// A file as it is now: another time of change is another card.
QString stampOf(const QString& path) {
  const QFileInfo file(path);
  return file.lastModified().toString(Qt::ISODateWithMs) + QString::number(file.size());
}

}  // namespace

struct ModelCards::Life {};

ModelCards::ModelCards(TaskRunner& runner, QObject* parent)
    : QObject(parent), runner_(runner), life_(std::make_shared<Life>()) {
  runner_.start({{}, [](const Progress&) { forgetOldPictures(); }, {}});
}

ModelCard ModelCards::card(const QString& path) const {
  const auto found = entries_.constFind(path);
  return found == entries_.constEnd() ? blankCard(path) : found->card;
}

void ModelCards::want(const QStringList& paths, int pixels) {
  pixels_ = pixels;
  for (const QString& path : paths) {
    const QString stamp = stampOf(path);
    auto entry = entries_.find(path);
    if (entry == entries_.end() || entry->stamp != stamp) {
      entries_.insert(path, {stamp, card(path), 0});
      if (!toRead_.contains(path)) toRead_.append(path);
      entry = entries_.find(path);
    }
    if (entry->pixels != pixels && !toDraw_.contains(path)) toDraw_.append(path);
  }
  if (!isBusy_) readNext();
}

void ModelCards::readNext() {
  if (toRead_.isEmpty()) return drawNext();
  isBusy_ = true;
  const QStringList paths = std::exchange(toRead_, {});
  auto read = std::make_shared<QList<ModelCard>>();
  runner_.start({{},
                 [paths, read, alive = std::weak_ptr<Life>(life_)](const Progress& progress) {
                   for (const QString& path : paths) {
                     if (alive.expired() || !goesOn(progress, 0)) return;
                     read->append(readCard(path));
                   }
                 },
                 [cards = QPointer<ModelCards>(this), paths, read] {
                   if (!cards) return;
                   cards->isBusy_ = false;
                   cards->keep(paths, *read);
                   cards->readNext();
                 }});
}

void ModelCards::keep(const QStringList& paths, const QList<ModelCard>& read) {
  for (qsizetype i = 0; i < read.size(); ++i) {
    ModelCard& card = entries_[paths[i]].card;
    const QImage picture = card.picture;  // that of the file as it was, until there is another
    card = read[i];
    card.picture = picture;
    emit changed(paths[i]);
  }
}

void ModelCards::drawNext() {
  if (toDraw_.isEmpty()) return;
  isBusy_ = true;
  const QString path = toDraw_.takeFirst();
  entries_[path].pixels = pixels_;
  auto picture = std::make_shared<QImage>();
  runner_.start({{},
                 [path, picture, pixels = pixels_,
                  alive = std::weak_ptr<Life>(life_)](const Progress& progress) {
                   if (alive.expired()) return;
                   *picture = drawCard(path, pixels, [&](double done) {
                     return !alive.expired() && goesOn(progress, done);
                   });
                 },
                 [cards = QPointer<ModelCards>(this), path, picture] {
                   if (!cards) return;
                   cards->isBusy_ = false;
                   cards->entries_[path].card.picture = *picture;
                   emit cards->changed(path);
                   cards->readNext();
                 }});
}

}  // namespace kiri::desktop
