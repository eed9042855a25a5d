// What is asked about files; tests answer for themselves.
// SPDX-License-Identifier: MIT
#include "apps/desktop/file_prompts.h"

#include <QCoreApplication>
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QMessageBox>
#include <QPushButton>

#include "apps/desktop/services/settings.h"

namespace kiri::desktop {
namespace {

QString modelFilter() {
  return QCoreApplication::translate("kiri::desktop::DialogPrompts",
                                     "KiriSim models (*.kiri);;All files (*)");
}

QString openFilter() {
  return QCoreApplication::translate(
      "kiri::desktop::DialogPrompts",
      "Models and crease patterns (*.kiri *.fold *.cp *.opx *.svg *.dxf);;KiriSim models "
      "(*.kiri);;Crease patterns (*.fold *.cp *.opx *.svg *.dxf);;All files (*)");
}

}  // namespace

QString DialogPrompts::tr(const char* text) {
  return QCoreApplication::translate("kiri::desktop::DialogPrompts", text);
}

SaveAnswer DialogPrompts::askToSave(const QString& name) {
  QMessageBox box(QMessageBox::Warning, tr("Unsaved changes"),
                  tr("%1 has changes that are not saved.").arg(name), QMessageBox::NoButton,
                  &window_);
  box.setInformativeText(tr("Without saving they are lost."));
  QPushButton* save = box.addButton(tr("&Save"), QMessageBox::AcceptRole);
  QPushButton* discard = box.addButton(tr("&Discard"), QMessageBox::DestructiveRole);
  box.addButton(tr("&Cancel"), QMessageBox::RejectRole);
  box.setDefaultButton(save);
  box.exec();
  if (box.clickedButton() == save) return SaveAnswer::Save;
  return box.clickedButton() == discard ? SaveAnswer::Discard : SaveAnswer::Cancel;
}

QString DialogPrompts::fileToOpen() {
  QString file = QFileDialog::getOpenFileName(&window_, tr("Open a model or a crease pattern"),
                                              settings_.folderFor("model"), openFilter());
  if (!file.isEmpty()) settings_.setFolderFor("model", QFileInfo(file).absolutePath());
  return file;
}

QString DialogPrompts::fileToSave(const QString& suggestion) {
  const QString place = QFileInfo(suggestion).isAbsolute()
                            ? suggestion
                            : QDir(settings_.folderFor("model")).filePath(suggestion);
  QFileDialog dialog(&window_, tr("Save the model"), QFileInfo(place).absolutePath(),
                     modelFilter());
  dialog.setAcceptMode(QFileDialog::AcceptSave);
  dialog.setDefaultSuffix("kiri");
  dialog.selectFile(QFileInfo(place).fileName());
  if (dialog.exec() != QDialog::Accepted || dialog.selectedFiles().isEmpty()) return {};
  QString file = dialog.selectedFiles().front();
  settings_.setFolderFor("model", QFileInfo(file).absolutePath());
  return file;
}

void DialogPrompts::tellProblem(const QString& title, const QString& text) {
  QMessageBox box(QMessageBox::Warning, title, title, QMessageBox::Ok, &window_);
  box.setInformativeText(text);
  box.exec();
}

}  // namespace kiri::desktop
