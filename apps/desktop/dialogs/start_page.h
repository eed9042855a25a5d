// Where a person begins: new sheets, files, examples, the tour.
// SPDX-License-Identifier: MIT
#pragma once

#include <QFrame>
#include <QLabel>
#include <QListWidget>
#include <QScrollArea>
#include <QWidget>
#include <memory>

#include "apps/desktop/services/settings.h"
#include "core/model/model.h"
#include "editor/base/task.h"

namespace kiri::desktop {

/// A page for the middle of the window (a QStackedWidget beside the panes). Pictures of recent
/// files and examples are made beside the window and kept; show() looks for what is new.
class StartPage final : public QWidget {
  Q_OBJECT
 public:
  StartPage(TaskRunner& runner, Settings& settings, QWidget* parent = nullptr);
  ~StartPage() override;

  /// Looks again at the recent files and the examples.
  void refresh();

 signals:
  void modelChosen(const kiri::Model& model);  ///< a sheet without steps
  void otherSheetWanted();                     ///< the sheet dialog
  void openWanted();                           ///< the file dialog
  void fileChosen(const QString& path);        ///< a recent file
  void exampleChosen(const QString& path);     ///< opened as a model without a file of its own
  void tourWanted();
  void closeWanted();  ///< back to the open model

 protected:
  void showEvent(QShowEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  QWidget* makeHead();
  QWidget* makeSheets();
  QWidget* makeGallery(const QString& title, QListWidget*& list);
  void fill(QListWidget& list, const QStringList& paths);
  void askPicture(QListWidgetItem& item, const QString& path);
  void fitHeights();
  void resizeEvent(QResizeEvent* event) override;

  struct Pictures;
  TaskRunner& runner_;
  Settings& settings_;
  std::shared_ptr<Pictures> pictures_;  ///< by path and time of the last change
  QListWidget* recent_ = nullptr;
  QWidget* recentPart_ = nullptr;
  QListWidget* examples_ = nullptr;
  QWidget* examplesPart_ = nullptr;
};

}  // namespace kiri::desktop
