// What an earlier run of the program left behind when it ended in disorder.
// SPDX-License-Identifier: MIT
#pragma once

#include <QDialog>
#include <QListWidget>
#include <QPushButton>
#include <optional>
#include <vector>

#include "editor/document/journal.h"

namespace kiri::desktop {

/// Shown at the start when leftoversIn(journalFolder()) is not empty. Accepted: `chosen()` is to be
/// recovered (and stays on disk until the recovered model is journaled itself); rejected: nothing
/// is recovered now and everything stays. What the person discards is taken away at once.
class RecoveryDialog final : public QDialog {
  Q_OBJECT
 public:
  explicit RecoveryDialog(std::vector<Leftover> leftovers, QWidget* parent = nullptr);

  std::optional<Leftover> chosen() const;
  /// Takes away the chosen one, after asking.
  void discardChosen(bool asks = true);

 private:
  void fill();

  std::vector<Leftover> leftovers_;
  QListWidget* list_ = nullptr;
  QPushButton* recover_ = nullptr;
  QPushButton* discard_ = nullptr;
};

/// Tells of a defect that the program has survived (Application::defectFound): what did not hold,
/// where the report is, and that the model is safe.
void showDefect(QWidget* parent, const QString& sentence, const QString& report);

}  // namespace kiri::desktop
