// The panels around the panes.
// SPDX-License-Identifier: MIT
#pragma once

#include <QDockWidget>
#include <QMainWindow>
#include <QMenu>

#include "apps/desktop/panels/folds_panel.h"
#include "apps/desktop/panels/pattern_panel.h"
#include "apps/desktop/panels/player_bar.h"
#include "apps/desktop/panels/step_panel.h"
#include "apps/desktop/panels/steps_list.h"

namespace kiri::desktop {

struct Docks {
  StepPanel* step = nullptr;
  FoldsPanel* folds = nullptr;
  StepsList* steps = nullptr;
  PatternPanel* pattern = nullptr;
  PlayerBar* player = nullptr;
  QDockWidget* stepDock = nullptr;
  QDockWidget* patternDock = nullptr;
};

/// Makes the panels, docks them, and lists them in `menu`.
Docks makeDocks(QMainWindow& window, SessionHub& hub, QMenu& menu);

}  // namespace kiri::desktop
