// Where a person begins: new sheets, files, examples, the tour.
// SPDX-License-Identifier: MIT
#pragma once

#include <QFrame>
#include <QLabel>
#include <QScrollArea>
#include <QWidget>

#include "apps/desktop/dialogs/card_list.h"
#include "apps/desktop/dialogs/gallery_part.h"
#include "apps/desktop/dialogs/model_preview.h"
#include "apps/desktop/services/model_cards.h"
#include "apps/desktop/services/settings.h"
#include "core/model/model.h"
#include "editor/base/task.h"

namespace kiri::desktop {

/// A page for the middle of the window (a QStackedWidget beside the panes). Cards of recent files
/// and examples are made beside the window and kept; show() looks for what is new. Where there is
/// room, more of the card under the pointer or the keyboard is shown beside them.
class StartPage final : public QWidget {
  Q_OBJECT
 public:
  StartPage(TaskRunner& runner, Settings& settings, QWidget* parent = nullptr);
  ~StartPage() override;

  /// Looks again at the recent files and the examples.
  void refresh();
  const ModelCards& cards() const { return *cards_; }
  GalleryPart& gallery() { return *gallery_; }
  ModelPreview& preview() { return *preview_; }

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
  void resizeEvent(QResizeEvent* event) override;

 private:
  QWidget* makeHead();
  QWidget* makeSheets();
  QWidget* makeRecent();
  void connectParts();
  void open(const QString& path);
  void fit();

  Settings& settings_;
  ModelCards* cards_;
  QScrollArea* area_;
  CardList* recent_ = nullptr;
  QWidget* recentPart_ = nullptr;
  GalleryPart* gallery_;
  ModelPreview* preview_;
};

}  // namespace kiri::desktop
