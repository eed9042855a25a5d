// What the window asks and offers in dialogs, the start page, the tour, and what it keeps safe.
// SPDX-License-Identifier: MIT
#pragma once

#include <QDialog>
#include <QMenu>
#include <QObject>
#include <QStackedWidget>
#include <functional>

#include "apps/desktop/actions.h"
#include "apps/desktop/dialogs/start_page.h"
#include "apps/desktop/dialogs/tour_card.h"
#include "apps/desktop/file_desk.h"
#include "apps/desktop/services/autosave.h"
#include "apps/desktop/services/export_source.h"
#include "apps/desktop/services/session_hub.h"
#include "apps/desktop/services/settings.h"
#include "apps/desktop/views/model_view.h"

class QMainWindow;

namespace kiri::desktop {

/// Connects actions to dialogs. No dialog keeps the window waiting: they are opened, and say
/// themselves when they are done.
class DialogDesk final : public QObject {
  Q_OBJECT
 public:
  /// The window has its central widget; the start page is put beside it.
  DialogDesk(QMainWindow& window, SessionHub& hub, Settings& settings, Actions& actions,
             FileDesk& files, ModelView& view);

  /// The program has started: what an earlier run left behind is offered; without a file to open
  /// the start page is shown, if the person likes it.
  void begin(bool opensFile);
  /// The window closes in order: nothing has to be recovered.
  void closing() { autosave_.finish(); }
  void showStartPage(bool isShown);
  bool isStartPageShown() const { return stack_->currentWidget() == start_; }
  /// Where panels and bars are while a model is being worked on, as QMainWindow::saveState.
  QByteArray windowLayout() const;
  StartPage& startPage() { return *start_; }
  void fillExamples(QMenu& menu);
  TourCard& tour() { return *tour_; }

 signals:
  void startPageShown(bool isShown);

 private:
  void on(const QString& id, std::function<void()> what);
  void connectActions();
  void connectStartPage();
  void connectSafety();
  void open(QDialog* dialog);
  void askSheet();
  void askAppearance();
  void askProperties();
  void askPreferences(bool showsKeys);
  void openExample(const QString& path);
  void beginTour();
  void hidePanels();
  void offerLeftovers();
  ExportSource source() const;

  QMainWindow& window_;
  SessionHub& hub_;
  Settings& settings_;
  Actions& actions_;
  FileDesk& files_;
  ModelView& view_;
  Autosave autosave_;
  QStackedWidget* stack_ = nullptr;
  StartPage* start_ = nullptr;
  TourCard* tour_ = nullptr;
  bool isTourWanted_ = false;
  QByteArray layout_;  ///< of the window before the start page was shown
};

}  // namespace kiri::desktop
