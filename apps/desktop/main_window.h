// The window: panes in the middle, tools at the left, panels at the right and below.
// SPDX-License-Identifier: MIT
#pragma once

#include <QMainWindow>
#include <memory>

#include "apps/desktop/actions.h"
#include "apps/desktop/dialog_desk.h"
#include "apps/desktop/docks.h"
#include "apps/desktop/edit_desk.h"
#include "apps/desktop/file_desk.h"
#include "apps/desktop/menus.h"
#include "apps/desktop/panels/caption_bar.h"
#include "apps/desktop/panels/field_bar.h"
#include "apps/desktop/panels/status_line.h"
#include "apps/desktop/services/pool_runner.h"
#include "apps/desktop/services/session_hub.h"
#include "apps/desktop/services/settings.h"
#include "apps/desktop/view_desk.h"
#include "apps/desktop/views/appearance_store.h"
#include "apps/desktop/views/model_view.h"
#include "apps/desktop/views/sheet_view.h"

class QSplitter;

namespace kiri::desktop {

/// Puts the parts together; each part knows what it does.
class MainWindow final : public QMainWindow {
  Q_OBJECT
 public:
  struct Options {
    ModelView::Drawing drawing = ModelView::Drawing::Automatic;
  };
  MainWindow(PoolRunner& runner, Settings& settings, Options options, QWidget* parent = nullptr);
  MainWindow(PoolRunner& runner, Settings& settings, QWidget* parent = nullptr)
      : MainWindow(runner, settings, Options(), parent) {}
  ~MainWindow() override;

  Session& session() { return hub_.session(); }
  SessionHub& hub() { return hub_; }
  Actions& actions() { return actions_; }
  FileDesk& files() { return *files_; }
  DialogDesk& dialogs() { return *dialogs_; }
  ModelView& modelView() { return *modelView_; }
  SheetView& sheetView() { return *sheetView_; }
  FieldBar& fieldBar() { return *fieldBar_; }
  CaptionBar& caption() { return *caption_; }
  StatusLine& statusLine() { return *status_; }
  Docks& docks() { return docks_; }

 protected:
  void closeEvent(QCloseEvent* event) override;
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dropEvent(QDropEvent* event) override;

 private:
  void makeCentre(ModelView::Drawing drawing);
  void connectFiles();
  void connectParts();
  void connectCaption();
  void refreshTitle();
  void fillRecent();
  void restoreLayout();

  PoolRunner& runner_;
  Settings& settings_;
  SessionHub hub_;
  Actions actions_;
  AppearanceStore look_;
  Menus menus_;
  QSplitter* splitter_ = nullptr;
  ModelView* modelView_ = nullptr;
  SheetView* sheetView_ = nullptr;
  FieldBar* fieldBar_ = nullptr;
  CaptionBar* caption_ = nullptr;
  StatusLine* status_ = nullptr;
  Docks docks_;
  FileDesk* files_ = nullptr;
  DialogDesk* dialogs_ = nullptr;
  EditDesk* edit_ = nullptr;
  ViewDesk* view_ = nullptr;
  bool mayClose_ = false;
};

}  // namespace kiri::desktop
