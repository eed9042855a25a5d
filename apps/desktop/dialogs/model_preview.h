// More of the model that a person points at, beside the cards.
// SPDX-License-Identifier: MIT
#pragma once

#include <QFrame>
#include <QLabel>
#include <QList>
#include <QPushButton>
#include <QString>
#include <QTimer>

#include "apps/desktop/services/model_cards.h"
#include "apps/desktop/services/model_moments.h"
#include "editor/base/task.h"

namespace kiri::desktop {

/// Title, figure, number of steps, notes, and pictures of the model folded, half unfolded and
/// unfolded. They are made when the pointer rests, beside the window, and kept.
class ModelPreview final : public QFrame {
  Q_OBJECT
 public:
  ModelPreview(ModelCards& cards, TaskRunner& runner, QWidget* parent = nullptr);

  void show(const QString& path);
  const QString& path() const { return path_; }
  QString notes() const { return notes_->text(); }
  /// The moments whose pictures are shown now.
  int pictureCount() const;

 signals:
  void chosen(const QString& path);

 private:
  struct Moment {
    QLabel* picture = nullptr;
    QLabel* name = nullptr;
  };
  QWidget* makeMoments();
  void say();
  void ask();
  void showMoments(const QList<ModelMoment>& moments);

  ModelCards& cards_;
  LatestTask task_;
  QString path_;
  QImage whole_;  ///< the finished model; null: not made yet
  QTimer rest_;
  QLabel* hint_;
  QWidget* inside_;
  QLabel* picture_;
  QLabel* title_;
  QLabel* facts_;
  QLabel* notes_;
  QList<Moment> moments_;
  QPushButton* open_;
};

}  // namespace kiri::desktop
