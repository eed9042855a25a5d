// Below the panes: what is done in the step that is shown, as a folding guide tells it.
// SPDX-License-Identifier: MIT
#pragma once

#include <QFrame>
#include <cstddef>

#include "apps/desktop/services/session_hub.h"

class QLabel;
class QPushButton;
class QScrollArea;
class QToolButton;
class QVBoxLayout;

namespace kiri::desktop {

/// Follows the cursor of the history and the film. It is there for models that were told something
/// about, if the person wants it. A model that has just been opened is introduced by its own notes,
/// until one of its steps is looked at.
class CaptionBar final : public QFrame {
  Q_OBJECT
 public:
  explicit CaptionBar(SessionHub& hub, QWidget* parent = nullptr);
  /// False: never shown.
  void setWanted(bool isWanted);
  /// Another model is open: it is introduced.
  void introduce();
  QString title() const;
  QString notes() const;
  QString place() const;

 signals:
  /// One step back (-1) or forward (1) is asked for.
  void stepWanted(int by);
  /// The model is to be shown before its first step.
  void startWanted();

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  void refresh();
  void fit();
  int heightFor(const QString& notes) const;

  SessionHub& hub_;
  QToolButton* back_;
  QToolButton* forward_;
  QLabel* title_;
  QLabel* place_;
  QLabel* notes_;
  QScrollArea* room_;
  QVBoxLayout* words_;
  QPushButton* start_;
  bool isWanted_ = true;
  bool introduces_ = false;
  std::size_t opened_ = 0;  ///< the step that was shown when the model was opened
};

}  // namespace kiri::desktop
