// The colours and images of the two sides of the paper (thesis 4.5, A3).
// SPDX-License-Identifier: MIT
#pragma once

#include <QDialog>
#include <QLabel>
#include <QPushButton>
#include <array>

#include "core/model/model.h"
#include "editor/base/task.h"

namespace kiri::desktop {

/// Asks for both sides. Accepted: `front()` and `back()`, for setSides of editor/document. Images
/// are named relative to the model's file where they lie beside or below it.
class AppearanceDialog final : public QDialog {
  Q_OBJECT
 public:
  AppearanceDialog(const PaperSide& front, const PaperSide& back, const QString& modelPath,
                   TaskRunner& runner, QWidget* parent = nullptr);

  const PaperSide& front() const { return sides_[0].side; }
  const PaperSide& back() const { return sides_[1].side; }
  bool isChanged() const;

  /// What the buttons do, without asking.
  void setColor(bool isFront, Color color);
  void setTexture(bool isFront, const QString& path);
  void usePreset(int index);
  static int presetCount();

 private:
  struct Side {
    PaperSide side;
    QLabel* swatch = nullptr;
    QPushButton* color = nullptr;
    QPushButton* image = nullptr;
    QPushButton* noImage = nullptr;
    QLabel* name = nullptr;
  };
  QWidget* makeSide(bool isFront);
  QWidget* makePresets();
  void chooseColor(bool isFront);
  void chooseImage(bool isFront);
  void show(bool isFront);

  std::array<Side, 2> sides_;
  PaperSide frontBefore_;
  PaperSide backBefore_;
  QString modelPath_;
  LatestTask frontImage_;
  LatestTask backImage_;
};

}  // namespace kiri::desktop
