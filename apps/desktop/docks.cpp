// The panels around the panes.
// SPDX-License-Identifier: MIT
#include "apps/desktop/docks.h"

#include <QVBoxLayout>

#include "apps/desktop/words.h"

namespace kiri::desktop {
namespace {

QDockWidget* dock(QMainWindow& window, const QString& name, const QString& title, QWidget* inside,
                  Qt::DockWidgetArea area) {
  auto* made = new QDockWidget(title, &window);
  made->setObjectName(name);
  made->setWidget(inside);
  made->setFeatures(QDockWidget::DockWidgetMovable | QDockWidget::DockWidgetClosable);
  window.addDockWidget(area, made);
  return made;
}

}  // namespace

Docks makeDocks(QMainWindow& window, SessionHub& hub, QMenu& menu) {
  Docks docks;
  docks.step = new StepPanel(hub);
  docks.folds = new FoldsPanel(hub);
  docks.steps = new StepsList(hub);
  docks.pattern = new PatternPanel(hub);
  docks.player = new PlayerBar(hub);
  auto* foot = new QWidget;
  auto* column = new QVBoxLayout(foot);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  column->addWidget(docks.steps);
  column->addWidget(docks.player);
  foot->setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Maximum);
  docks.stepDock = dock(window, "step-dock", tr("Step"), docks.step, Qt::RightDockWidgetArea);
  QDockWidget* folds =
      dock(window, "folds-dock", tr("Folds"), docks.folds, Qt::RightDockWidgetArea);
  docks.patternDock =
      dock(window, "pattern-dock", tr("Pattern"), docks.pattern, Qt::RightDockWidgetArea);
  window.tabifyDockWidget(folds, docks.patternDock);
  folds->raise();
  QDockWidget* steps = dock(window, "steps-dock", tr("Steps"), foot, Qt::BottomDockWidgetArea);
  // A row of cards says itself what it is.
  steps->setTitleBarWidget(new QWidget(steps));
  window.setCorner(Qt::BottomRightCorner, Qt::RightDockWidgetArea);
  window.setCorner(Qt::BottomLeftCorner, Qt::LeftDockWidgetArea);
  window.resizeDocks({docks.stepDock, folds}, {290, 290}, Qt::Horizontal);
  window.resizeDocks({docks.stepDock, folds}, {340, 420}, Qt::Vertical);
  for (QDockWidget* one : {docks.stepDock, folds, docks.patternDock, steps})
    menu.addAction(one->toggleViewAction());
  return docks;
}

}  // namespace kiri::desktop
