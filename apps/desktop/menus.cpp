// The menu bar, the tool bar and the palette of tools.
// SPDX-License-Identifier: MIT
#include "apps/desktop/menus.h"

#include <QMenuBar>
#include <QToolButton>

#include "apps/desktop/words.h"

namespace kiri::desktop {
namespace {

constexpr int kBarIcon = 20;
constexpr int kToolIcon = 24;

/// Adds actions by name; a dash is a line between.
void fill(QWidget& place, const Actions& actions, const QStringList& names) {
  for (const QString& name : names) {
    if (name == "-") {
      auto* line = new QAction(&place);
      line->setSeparator(true);
      place.addAction(line);
    } else {
      place.addAction(&actions[name]);
    }
  }
}

QMenu* menu(QMainWindow& window, const QString& title, const Actions& actions,
            const QStringList& names) {
  QMenu* made = window.menuBar()->addMenu(title);
  made->setToolTipsVisible(false);
  fill(*made, actions, names);
  return made;
}

/// The name of a bar is what settings remember it by, the title what people read.
QToolBar* toolBar(QMainWindow& window, const QString& name, const QString& title, int size,
                  Qt::ToolBarArea area) {
  auto* bar = new QToolBar(title, &window);
  bar->setObjectName(name);
  bar->setIconSize({size, size});
  bar->setMovable(false);
  bar->setToolButtonStyle(Qt::ToolButtonIconOnly);
  window.addToolBar(area, bar);
  return bar;
}

/// Buttons of bars are reached by Tab and have a name.
void makeReachable(QToolBar& bar) {
  for (QAction* action : bar.actions()) {
    QWidget* button = bar.widgetForAction(action);
    if (!button || action->isSeparator()) continue;
    button->setFocusPolicy(Qt::TabFocus);
    button->setAccessibleName(action->iconText());
  }
}

QStringList toolPalette() {
  return {"fold",         "line",      "angle", "add-edge", "-",       "tear",     "mend",
          "straight-cut", "curve-cut", "-",     "select",   "measure", "top-layer"};
}

QMenu* viewMenu(QMainWindow& window, const Actions& actions) {
  return menu(window, tr("&View"), actions,
              {"fit",        "view-front",   "view-back",  "view-angled", "perspective",
               "zoom-in",    "zoom-out",     "-",          "show-model",  "show-sheet",
               "sheet-only", "sheet-back",   "step-notes", "-",           "creases",
               "edges",      "borders",      "shading",    "-",           "grid",
               "grid-finer", "grid-coarser", "-"});
}

}  // namespace

Menus makeMenus(QMainWindow& window, Actions& actions) {
  Menus menus;
  QMenu* file = menu(window, tr("&File"), actions, {"new", "open"});
  menus.recent = file->addMenu(tr("Open &recent"));
  menus.examples = file->addMenu(tr("Exa&mples"));
  fill(*file, actions,
       {"start-page", "-", "save", "save-as", "-", "export", "film", "print", "-", "appearance",
        "properties", "-", "quit"});
  menu(window, tr("&Edit"), actions,
       {"undo", "redo", "-", "commit", "cancel", "delete", "paste", "-", "previous-step",
        "next-step", "remove-step", "-", "snap", "-", "preferences", "shortcuts"});
  QStringList fold = toolPalette();
  fold += {"-",         "valley",         "mountain",      "-",
           "turn-over", "turn-over-down", "rotate-left",   "rotate-right",
           "-",         "unfold-all",     "refold-all",    "mend-all",
           "-",         "next-state",     "previous-state"};
  menu(window, tr("F&old"), actions, fold);
  QMenu* view = viewMenu(window, actions);
  menus.panels = view->addMenu(tr("Pane&ls"));
  fill(*view, actions, {"full-screen"});
  menu(window, tr("&Play"), actions,
       {"play", "stop", "-", "skip-back", "skip-forward", "-", "slower", "faster", "loop"});
  menu(window, tr("&Help"), actions, {"help", "tour", "-", "about"});

  menus.bar = toolBar(window, "main-bar", tr("Main bar"), kBarIcon, Qt::TopToolBarArea);
  fill(*menus.bar, actions,
       {"new",         "open",       "save",       "-",    "undo",       "redo",       "-",
        "turn-over",   "unfold-all", "refold-all", "-",    "fit",        "view-front", "view-back",
        "view-angled", "-",          "creases",    "grid", "show-sheet", "-",          "export"});
  menus.tools = toolBar(window, "tools", tr("Tools"), kToolIcon, Qt::LeftToolBarArea);
  fill(*menus.tools, actions, toolPalette());
  makeReachable(*menus.bar);
  makeReachable(*menus.tools);
  return menus;
}

}  // namespace kiri::desktop
