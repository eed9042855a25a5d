// The steps of the open model as rows, with their pictures.
// SPDX-License-Identifier: MIT
#pragma once

#include <QAbstractListModel>
#include <QHash>
#include <QPixmap>
#include <memory>
#include <vector>

#include "apps/desktop/services/session_hub.h"
#include "editor/base/task.h"

namespace kiri::desktop {

/// Row 0 is the untouched sheet, row n the model after n steps. Pictures are made beside the
/// window, one after the other, and kept for as long as their states are.
class StepsModel final : public QAbstractListModel {
  Q_OBJECT
 public:
  enum Role {
    PictureRole = Qt::UserRole + 1,  ///< QPixmap; null while it is being made
    IsCurrentRole,
    IsUndoneRole,
    ProblemRole,  ///< why the step does not apply; empty: it does
  };
  explicit StepsModel(SessionHub& hub, QObject* parent = nullptr);

  int rowCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role) const override;
  int currentRow() const;
  /// Device pixels on a side of a picture.
  void setPixels(int pixels);

 private:
  void refresh();
  void drawNext();

  struct Picture {
    std::shared_ptr<const FoldedState> state;  ///< kept, so that no other takes its address
    QPixmap pixmap;
  };
  struct Row {
    QString text;
    QString tip;
    QString problem;
    std::shared_ptr<const FoldedState> state;
  };

  SessionHub& hub_;
  std::vector<Row> rows_;
  QHash<const FoldedState*, Picture> pictures_;
  QByteArray colours_;
  int pixels_ = 96;
  LatestTask task_;
};

}  // namespace kiri::desktop
