// Opening, saving and closing models, with care for what is not saved.
// SPDX-License-Identifier: MIT
#pragma once

#include <QObject>
#include <QString>
#include <functional>
#include <memory>

#include "apps/desktop/file_prompts.h"
#include "apps/desktop/services/session_hub.h"
#include "apps/desktop/services/settings.h"
#include "core/model/model.h"

namespace kiri::desktop {

/// Files are read, replayed and written beside the window. Nothing that is not saved is given up
/// without asking.
class FileDesk final : public QObject {
  Q_OBJECT
 public:
  FileDesk(SessionHub& hub, Settings& settings, std::unique_ptr<FilePrompts> prompts,
           QObject* parent = nullptr);
  void setPrompts(std::unique_ptr<FilePrompts> prompts) { prompts_ = std::move(prompts); }

  /// Asks about unsaved changes first.
  void openModel(Model model);
  void openFile(const QString& path);
  void askAndOpen();
  void save();
  void saveAs();
  /// Calls `goOn` when nothing would be lost by it: at once, after saving, or never.
  void whenSafe(std::function<void()> goOn);

  /// The file's name, or that of a model that has none yet.
  QString name() const;
  bool isModified() const;
  /// Reading or writing is under way.
  bool isBusy() const { return isBusy_; }

 signals:
  void opened();
  void saved(const QString& path);
  void failed(const QString& text);
  /// Sentences of the reader about what looks odd in the file but does no harm.
  void warned(const QStringList& sentences);

 private:
  struct Reading;
  void read(const QString& path);
  void show(const Model& model);
  void finishReading(const Reading& reading, const QString& path);
  void write(const QString& path, std::function<void()> then);
  void saveThen(std::function<void()> then);
  void tell(const QString& title, const QString& text);

  SessionHub& hub_;
  Settings& settings_;
  std::unique_ptr<FilePrompts> prompts_;
  bool isBusy_ = false;
};

}  // namespace kiri::desktop
