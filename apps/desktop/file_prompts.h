// What is asked about files; tests answer for themselves.
// SPDX-License-Identifier: MIT
#pragma once

#include <QString>

class QWidget;

namespace kiri::desktop {

class Settings;

enum class SaveAnswer { Save, Discard, Cancel };

/// Questions to the person. Empty file names: the person changed their mind.
class FilePrompts {
 public:
  virtual ~FilePrompts() = default;
  virtual SaveAnswer askToSave(const QString& name) = 0;
  virtual QString fileToOpen() = 0;
  /// `suggestion`: a whole path, or a name without a folder.
  virtual QString fileToSave(const QString& suggestion) = 0;
  virtual void tellProblem(const QString& title, const QString& text) = 0;
};

/// Qt's dialogs.
class DialogPrompts final : public FilePrompts {
 public:
  DialogPrompts(QWidget& window, Settings& settings) : window_(window), settings_(settings) {}
  SaveAnswer askToSave(const QString& name) override;
  QString fileToOpen() override;
  QString fileToSave(const QString& suggestion) override;
  void tellProblem(const QString& title, const QString& text) override;

 private:
  static QString tr(const char* text);

  QWidget& window_;
  Settings& settings_;
};

}  // namespace kiri::desktop
