// What the actions of the View menu do: eyes, panes, lines, grid.
// SPDX-License-Identifier: MIT
#pragma once

#include <QObject>
#include <functional>

#include "apps/desktop/actions.h"
#include "apps/desktop/services/session_hub.h"
#include "apps/desktop/services/settings.h"
#include "apps/desktop/views/appearance_store.h"

class QWidget;

namespace kiri::desktop {

/// Keeps what is shown from one start of the program to the next.
class ViewDesk final : public QObject {
  Q_OBJECT
 public:
  struct Panes {
    QWidget* model = nullptr;
    QWidget* sheet = nullptr;
  };
  ViewDesk(SessionHub& hub, AppearanceStore& look, Settings& settings, Actions& actions,
           Panes panes, QObject* parent = nullptr);
  /// Takes over what the preferences say about the view.
  void applyPreferences();

 private:
  void on(const QString& id, std::function<void()> what);
  void connectEyes();
  void connectPanes();
  void connectLines();
  void connectSwitch(const QString& id, bool Display::*field);
  void look(Camera::Preset preset);
  void zoom(double factor);
  void showPanes(bool model, bool sheet);
  void changeGrid(double factor);
  void setDisplay(const Display& display);

  SessionHub& hub_;
  AppearanceStore& look_;
  Settings& settings_;
  Actions& actions_;
  Panes panes_;
};

}  // namespace kiri::desktop
