// What an earlier run of the program left behind when it ended in disorder.
// SPDX-License-Identifier: MIT
#include "apps/desktop/dialogs/recovery_dialog.h"

#include <QDateTime>
#include <QDialogButtonBox>
#include <QFileInfo>
#include <QLocale>
#include <QMessageBox>
#include <QVBoxLayout>
#include <utility>

#include "apps/desktop/dialogs/form.h"
#include "apps/desktop/look/icons.h"

namespace kiri::desktop {

namespace {

QString nameOf(const Leftover& leftover) {
  if (!leftover.originalPath.empty())
    return QFileInfo(QString::fromStdString(leftover.originalPath)).fileName();
  if (!leftover.title.empty()) return QString::fromStdString(leftover.title);
  return RecoveryDialog::tr("A model without a name");
}

QString factsOf(const Leftover& leftover) {
  const QFileInfo file(QString::fromStdString(leftover.file));
  const QString when = QLocale().toString(file.lastModified(), QLocale::ShortFormat);
  const QString steps = RecoveryDialog::tr("%n step(s)", nullptr, static_cast<int>(leftover.steps));
  const QString where = leftover.originalPath.empty()
                            ? RecoveryDialog::tr("never saved")
                            : QString::fromStdString(leftover.originalPath);
  return RecoveryDialog::tr("%1, %2, %3").arg(steps, when, where);
}

}  // namespace

RecoveryDialog::RecoveryDialog(std::vector<Leftover> leftovers, QWidget* parent)
    : QDialog(parent), leftovers_(std::move(leftovers)) {
  setWindowTitle(tr("Recover"));
  auto* explanation = new QLabel(
      tr("KiriSim did not end in order the last time. What you were working on has been kept, up "
         "to the last step."));
  explanation->setWordWrap(true);
  list_ = new QListWidget;
  list_->setIconSize({24, 24});
  list_->setAccessibleName(tr("Models that can be recovered"));
  auto* buttons = new QDialogButtonBox;
  recover_ = buttons->addButton(tr("Recover"), QDialogButtonBox::AcceptRole);
  buttons->addButton(tr("Later"), QDialogButtonBox::RejectRole);
  discard_ = buttons->addButton(tr("Discard…"), QDialogButtonBox::DestructiveRole);
  recover_->setDefault(true);
  connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  connect(discard_, &QPushButton::clicked, this, [this] { discardChosen(); });
  connect(list_, &QListWidget::itemActivated, this, &QDialog::accept);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(20, 20, 20, 16);
  layout->setSpacing(12);
  layout->addWidget(headline(tr("Your work is safe")));
  layout->addWidget(explanation);
  layout->addWidget(list_, 1);
  withoutIcons(*buttons);
  layout->addWidget(buttons);
  resize(560, 340);
  fill();
}

void RecoveryDialog::fill() {
  list_->clear();
  for (const Leftover& leftover : leftovers_) {
    auto* item = new QListWidgetItem(icon("sheet"), nameOf(leftover) + "\n" + factsOf(leftover));
    list_->addItem(item);
  }
  list_->setCurrentRow(leftovers_.empty() ? -1 : 0);
  recover_->setEnabled(!leftovers_.empty());
  discard_->setEnabled(!leftovers_.empty());
}

std::optional<Leftover> RecoveryDialog::chosen() const {
  const int row = list_->currentRow();
  if (row < 0) return std::nullopt;
  return leftovers_[static_cast<std::size_t>(row)];
}

void RecoveryDialog::discardChosen(bool asks) {
  const std::optional<Leftover> leftover = chosen();
  if (!leftover) return;
  if (asks &&
      QMessageBox::question(
          this, tr("Discard"),
          tr("Discard what was kept of “%1”? It cannot be brought back.").arg(nameOf(*leftover))) !=
          QMessageBox::Yes) {
    return;
  }
  discard(*leftover);
  leftovers_.erase(leftovers_.begin() + list_->currentRow());
  fill();
  if (leftovers_.empty()) reject();
}

void showDefect(QWidget* parent, const QString& sentence, const QString& report) {
  auto* box = new QMessageBox(parent);
  box->setAttribute(Qt::WA_DeleteOnClose);
  box->setIcon(QMessageBox::Warning);
  box->setWindowTitle(RecoveryDialog::tr("An error in KiriSim"));
  box->setText(RecoveryDialog::tr(
      "KiriSim has found an error in itself. Your model is as it was before; save it under another "
      "name and start the program again."));
  box->setInformativeText(report.isEmpty() ? QString()
                                           : RecoveryDialog::tr("A report is in %1.").arg(report));
  box->setDetailedText(sentence);
  box->open();
}

}  // namespace kiri::desktop
