// What the actions of editing, folding and playing do to the session.
// SPDX-License-Identifier: MIT
#pragma once

#include <QObject>
#include <functional>

#include "apps/desktop/actions.h"
#include "apps/desktop/panels/player_bar.h"
#include "apps/desktop/services/session_hub.h"

namespace kiri::desktop {

/// Connects actions to the session and keeps their state (enabled, checked, "Undo fold 3").
class EditDesk final : public QObject {
  Q_OBJECT
 public:
  EditDesk(SessionHub& hub, Actions& actions, PlayerBar& player, QObject* parent = nullptr);
  void removeStep(int index);

 signals:
  void toolChosen(QAction& action);

 private:
  void connectTools();
  void connectHistory();
  void connectSteps();
  void connectPlayer(PlayerBar& player);
  void on(const QString& id, std::function<void()> what);
  void press(Key key, char character = 0);
  void jump(int by);
  void refresh();
  void refreshTool();

  SessionHub& hub_;
  Actions& actions_;
};

}  // namespace kiri::desktop
