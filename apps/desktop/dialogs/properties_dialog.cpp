// Title and notes of the model.
// SPDX-License-Identifier: MIT
#include "apps/desktop/dialogs/properties_dialog.h"

#include <QDialogButtonBox>
#include <QVBoxLayout>

#include "apps/desktop/dialogs/form.h"

namespace kiri::desktop {

PropertiesDialog::PropertiesDialog(const QString& title, const QString& notes, QWidget* parent)
    : QDialog(parent) {
  setWindowTitle(tr("Title and notes"));
  title_ = new QLineEdit(title);
  notes_ = new QPlainTextEdit(notes);
  notes_->setTabChangesFocus(true);
  QFormLayout* form = formLayout();
  form->addRow(tr("&Title"), title_);
  form->addRow(tr("&Notes"), notes_);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel);
  withoutIcons(*buttons);
  connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(20, 20, 20, 16);
  layout->setSpacing(12);
  layout->addLayout(form, 1);
  layout->addWidget(buttons);
  resize(480, 300);
}

}  // namespace kiri::desktop
