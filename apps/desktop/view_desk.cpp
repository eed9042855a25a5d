// What the actions of the View menu do: eyes, panes, lines, grid.
// SPDX-License-Identifier: MIT
#include "apps/desktop/view_desk.h"

#include <QWidget>
#include <algorithm>
#include <utility>

#include "render/scene/view_spec.h"

namespace kiri::desktop {
namespace {

constexpr double kZoomStep = 1.25;
constexpr double kFinestGrid = 0.5;  // mm
constexpr double kCoarsestGrid = 100;

}  // namespace

ViewDesk::ViewDesk(SessionHub& hub, AppearanceStore& look, Settings& settings, Actions& actions,
                   Panes panes, QObject* parent)
    : QObject(parent),
      hub_(hub),
      look_(look),
      settings_(settings),
      actions_(actions),
      panes_(panes) {
  Display display = look.display();
  display.showsCreases = settings.value("view/creases", true).toBool();
  display.showsEdges = settings.value("view/edges", true).toBool();
  display.showsBorders = settings.value("view/borders", true).toBool();
  display.isShaded = settings.value("view/shading", true).toBool();
  display.showsGrid = settings.value("view/grid", false).toBool();
  display.gridSpacing =
      std::clamp(settings.value("view/grid-spacing", 10).toDouble(), kFinestGrid, kCoarsestGrid);
  look.setDisplay(display);
  connectEyes();
  connectPanes();
  connectLines();
  applyPreferences();
}

void ViewDesk::on(const QString& id, std::function<void()> what) {
  connect(&actions_[id], &QAction::triggered, this, [what = std::move(what)] { what(); });
}

void ViewDesk::applyPreferences() {
  const Preferences& preferences = settings_.preferences();
  actions_["perspective"].setChecked(preferences.hasPerspective);
  hub_.session().camera().setPerspective(preferences.hasPerspective ? preferences.fieldOfView : 0);
  hub_.session().snaps() = preferences.snaps;
  actions_["snap"].setChecked(preferences.snaps.isOn);
  hub_.session().viewChanged();
  Display display = look_.display();
  display.lineStyle = preferences.lineStyle;
  look_.setDisplay(display);
}

void ViewDesk::connectEyes() {
  on("fit", [this] { hub_.session().fitAll(); });
  on("view-front", [this] { look(Camera::Preset::Front); });
  on("view-back", [this] { look(Camera::Preset::Back); });
  on("view-angled", [this] { look(Camera::Preset::Angled); });
  on("zoom-in", [this] { zoom(kZoomStep); });
  on("zoom-out", [this] { zoom(1 / kZoomStep); });
  connect(&actions_["perspective"], &QAction::toggled, this, [this](bool isOn) {
    Preferences preferences = settings_.preferences();
    preferences.hasPerspective = isOn;
    settings_.setPreferences(preferences);
    applyPreferences();
  });
  connect(&actions_["snap"], &QAction::toggled, this, [this](bool isOn) {
    Preferences preferences = settings_.preferences();
    preferences.snaps.isOn = isOn;
    settings_.setPreferences(preferences);
  });
  connect(&actions_["sheet-back"], &QAction::toggled, this, [this](bool isOn) {
    hub_.session().sheetCamera().setShowsBack(isOn);
    hub_.session().viewChanged();
  });
}

void ViewDesk::look(Camera::Preset preset) {
  Session& session = hub_.session();
  if (const auto state = session.shown().state) {
    session.camera().look(preset, sphereOf(*state));
    session.viewChanged();
  }
}

void ViewDesk::zoom(double factor) {
  Session& session = hub_.session();
  const bool isSheet = panes_.sheet->hasFocus();
  const Vec2 size = isSheet ? session.sheetCamera().map().size : session.camera().map().size;
  if (isSheet) {
    session.sheetCamera().zoom(size / 2, factor);
  } else {
    session.camera().zoom(size / 2, factor);
  }
  session.viewChanged();
}

void ViewDesk::connectPanes() {
  QAction& model = actions_["show-model"];
  QAction& sheet = actions_["show-sheet"];
  QAction& only = actions_["sheet-only"];
  model.setChecked(true);
  sheet.setChecked(settings_.value("view/sheet", true).toBool());
  // One of the two is always there.
  connect(&model, &QAction::toggled, this,
          [this, &sheet](bool isOn) { showPanes(isOn, !isOn || sheet.isChecked()); });
  connect(&sheet, &QAction::toggled, this,
          [this, &model](bool isOn) { showPanes(!isOn || model.isChecked(), isOn); });
  connect(&only, &QAction::toggled, this, [this](bool isOn) { showPanes(!isOn, true); });
  showPanes(true, sheet.isChecked());
}

void ViewDesk::showPanes(bool model, bool sheet) {
  panes_.model->setVisible(model);
  panes_.sheet->setVisible(sheet);
  const std::pair<const char*, bool> states[] = {
      {"show-model", model}, {"show-sheet", sheet}, {"sheet-only", sheet && !model}};
  for (const auto& [id, isOn] : states) {
    const QSignalBlocker quiet(&actions_[id]);
    actions_[id].setChecked(isOn);
  }
  settings_.setValue("view/sheet", sheet);
}

void ViewDesk::connectLines() {
  connectSwitch("creases", &Display::showsCreases);
  connectSwitch("edges", &Display::showsEdges);
  connectSwitch("borders", &Display::showsBorders);
  connectSwitch("shading", &Display::isShaded);
  connectSwitch("grid", &Display::showsGrid);
  on("grid-finer", [this] { changeGrid(0.5); });
  on("grid-coarser", [this] { changeGrid(2); });
}

void ViewDesk::connectSwitch(const QString& id, bool Display::*field) {
  QAction& action = actions_[id];
  action.setChecked(look_.display().*field);
  connect(&action, &QAction::toggled, this, [this, id, field](bool isOn) {
    Display display = look_.display();
    display.*field = isOn;
    setDisplay(display);
    settings_.setValue("view/" + id, isOn);
  });
}

void ViewDesk::changeGrid(double factor) {
  Display display = look_.display();
  display.gridSpacing = std::clamp(display.gridSpacing * factor, kFinestGrid, kCoarsestGrid);
  settings_.setValue("view/grid-spacing", display.gridSpacing);
  setDisplay(display);
  actions_["grid"].setChecked(true);
}

void ViewDesk::setDisplay(const Display& display) { look_.setDisplay(display); }

}  // namespace kiri::desktop
