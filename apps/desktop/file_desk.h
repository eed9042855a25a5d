// Opening, saving and closing models, with care for what is not saved.
// SPDX-License-Identifier: MIT
#pragma once

#include <QObject>
#include <QString>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "apps/desktop/file_prompts.h"
#include "apps/desktop/services/session_hub.h"
#include "apps/desktop/services/settings.h"
#include "core/model/model.h"

class QMimeData;

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
  /// A model, or a crease pattern of another program, which becomes a new model.
  void openFile(const QString& path);
  /// True when the data holds a file that openFile takes, or the text of a crease pattern.
  static bool canOpen(const QMimeData& data);
  /// Opens what was pasted or dropped.
  void openData(const QMimeData& data);
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
  /// The model that was opened was a crease pattern of another program.
  void patternOpened();
  /// Sentences of the reader about what looks odd in the file but does no harm.
  void warned(const QStringList& sentences);

 private:
  struct Reading;
  void read(const QString& path);
  static void import(const std::string& text, const std::string& name, Reading& reading,
                     const Progress& progress);
  void importFile(const QString& path);
  void importText(const std::string& text);
  void finishImport(const Reading& reading, const QString& path);
  void tellLosses();
  void show(const Model& model);
  void finishReading(const Reading& reading, const QString& path);
  void write(const QString& path, std::function<void()> then);
  void saveThen(std::function<void()> then);
  void tell(const QString& title, const QString& text);

  SessionHub& hub_;
  Settings& settings_;
  std::unique_ptr<FilePrompts> prompts_;
  std::vector<std::string> losses_;  ///< to be told when an imported pattern is saved
  bool isBusy_ = false;
};

}  // namespace kiri::desktop
