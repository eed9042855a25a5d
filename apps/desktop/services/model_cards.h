// Cards of model files, made beside the window and kept.
// SPDX-License-Identifier: MIT
#pragma once

#include <QHash>
#include <QList>
#include <QObject>
#include <QStringList>
#include <memory>

#include "apps/desktop/services/gallery.h"
#include "editor/base/task.h"

namespace kiri::desktop {

/// Words come first, of all files at once, then one picture after the other, so that other work
/// beside the window has its turn. A file that was written since is looked at again.
class ModelCards final : public QObject {
  Q_OBJECT
 public:
  explicit ModelCards(TaskRunner& runner, QObject* parent = nullptr);

  /// What is known so far; never nothing.
  ModelCard card(const QString& path) const;
  /// Asks for what is missing; the first are made first. `pixels`: of a picture's side.
  void want(const QStringList& paths, int pixels);

 signals:
  void changed(const QString& path);

 private:
  struct Entry {
    QString stamp;  ///< the file as it was when the card was begun
    ModelCard card;
    int pixels = 0;  ///< of the picture that was made or tried; 0: none yet
  };
  void readNext();
  void drawNext();
  void keep(const QStringList& paths, const QList<ModelCard>& read);

  struct Life;
  TaskRunner& runner_;
  std::shared_ptr<Life> life_;  ///< goes with this; work beside the window looks at it
  QHash<QString, Entry> entries_;
  QStringList toRead_;
  QStringList toDraw_;
  int pixels_ = 0;
  bool isBusy_ = false;
};

}  // namespace kiri::desktop
