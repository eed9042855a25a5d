// The menu bar, the tool bar and the palette of tools.
// SPDX-License-Identifier: MIT
#pragma once

#include <QHash>
#include <QMainWindow>
#include <QMenu>
#include <QToolBar>

#include "apps/desktop/actions.h"

namespace kiri::desktop {

/// Every action is in one of the menus.
struct Menus {
  QMenu* recent = nullptr;    ///< filled by whoever knows the files
  QMenu* examples = nullptr;  ///< the same
  QMenu* panels = nullptr;    ///< docks and bars to show and hide
  QToolBar* bar = nullptr;
  QToolBar* tools = nullptr;
};

Menus makeMenus(QMainWindow& window, Actions& actions);

}  // namespace kiri::desktop
