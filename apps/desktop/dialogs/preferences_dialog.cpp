// What a person prefers, on three pages.
// SPDX-License-Identifier: MIT
#include "apps/desktop/dialogs/preferences_dialog.h"

#include <QDialogButtonBox>
#include <QPushButton>
#include <QVBoxLayout>
#include <algorithm>

#include "apps/desktop/dialogs/form.h"

namespace kiri::desktop {

PreferencesDialog::PreferencesDialog(Settings& settings, const QList<QAction*>& actions,
                                     const QMap<QString, Keys>& ownKeys, QWidget* parent)
    : QDialog(parent), settings_(settings), before_(settings.preferences()) {
  setWindowTitle(tr("Preferences"));
  pages_ = new QTabWidget;
  pages_->addTab(makeLookPage(), tr("General"));
  pages_->addTab(makeHandPage(), tr("Help for the hand"));
  shortcuts_ = new ShortcutEditor(actions, ownKeys, settings.shortcuts());
  pages_->addTab(shortcuts_, tr("Keys"));
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel |
                                       QDialogButtonBox::RestoreDefaults);
  connect(buttons, &QDialogButtonBox::accepted, this, &PreferencesDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &PreferencesDialog::reject);
  connect(buttons->button(QDialogButtonBox::RestoreDefaults), &QPushButton::clicked, this, [this] {
    if (pages_->currentWidget() == shortcuts_) {
      shortcuts_->resetAll();
    } else {
      show(Preferences{});
      apply();
    }
  });
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(16, 16, 16, 16);
  layout->setSpacing(12);
  layout->addWidget(pages_, 1);
  withoutIcons(*buttons);
  layout->addWidget(buttons);
  resize(640, 560);
  show(before_);
}

QWidget* PreferencesDialog::makeLookPage() {
  auto* page = new QWidget;
  QFormLayout* form = formLayout();
  page->setLayout(form);
  form->setContentsMargins(16, 16, 16, 16);
  theme_ = choiceBox({{tr("As the desktop"), static_cast<int>(ThemeChoice::System)},
                      {tr("Light"), static_cast<int>(ThemeChoice::Light)},
                      {tr("Dark"), static_cast<int>(ThemeChoice::Dark)}},
                     0);
  lines_ = choiceBox(
      {{tr("Thesis: mountain blue, valley red"), static_cast<int>(LineStyle::Thesis)},
       {tr("Safe for colour-blind eyes"), static_cast<int>(LineStyle::Safe)},
       {tr("Origami programs: mountain red, valley blue"), static_cast<int>(LineStyle::Program)},
       {tr("Printed diagrams: black dashes"), static_cast<int>(LineStyle::Diagram)}},
      0);
  language_ = new QComboBox;
  addLanguages();
  perspective_ = new QCheckBox(tr("What is nearer looks larger"));
  field_ = numberBox(30, 5, 120, tr("°"), 0, 5);
  startPage_ = new QCheckBox(tr("Show the start page when the program starts"));
  tips_ = new QCheckBox(tr("Show hints"));
  autosave_ = new QCheckBox(tr("Keep every step safe from crashes"));
  form->addRow(tr("&Colours"), theme_);
  form->addRow(tr("C&reases"), lines_);
  form->addRow(tr("&Language"), language_);
  form->addRow({}, remark(tr("Another language is shown when the program starts again. All "
                             "lengths are in millimetres, all angles in degrees.")));
  form->addRow(tr("&Perspective"), perspective_);
  form->addRow(tr("&Field of view"), field_);
  form->addRow(tr("Start"), startPage_);
  form->addRow({}, tips_);
  form->addRow(tr("Safety"), autosave_);
  connect(perspective_, &QCheckBox::toggled, field_, &QWidget::setEnabled);
  for (QComboBox* box : {theme_, lines_, language_})
    connect(box, &QComboBox::currentIndexChanged, this, &PreferencesDialog::apply);
  for (QCheckBox* box : {perspective_, startPage_, tips_, autosave_})
    connect(box, &QCheckBox::toggled, this, &PreferencesDialog::apply);
  connect(field_, &QDoubleSpinBox::valueChanged, this, &PreferencesDialog::apply);
  return page;
}

QWidget* PreferencesDialog::makeHandPage() {
  auto* page = new QWidget;
  QFormLayout* form = formLayout();
  page->setLayout(form);
  form->setContentsMargins(16, 16, 16, 16);
  snap_ = new QCheckBox(tr("Points are caught by what is near"));
  vertices_ = new QCheckBox(tr("Corners"));
  midpoints_ = new QCheckBox(tr("Middles of edges"));
  crossings_ = new QCheckBox(tr("Crossings"));
  edges_ = new QCheckBox(tr("Edges"));
  divisions_ = new QSpinBox;
  divisions_->setRange(1, 64);
  divisions_->setSpecialValueText(tr("none"));
  divisions_->setPrefix("1/");
  angle_ = numberBox(0, 0, 90, tr("°"), 1, 7.5);
  angle_->setSpecialValueText(tr("any"));
  grid_ = numberBox(0, 0, 1000, tr(" mm"), 1, 5);
  grid_->setSpecialValueText(tr("none"));
  radius_ = numberBox(10, 2, 60, tr(" pixels"), 0, 1);
  form->addRow(tr("&Snapping"), snap_);
  form->addRow(tr("Caught by"), vertices_);
  for (QCheckBox* box : {midpoints_, crossings_, edges_}) form->addRow({}, box);
  form->addRow(tr("&Parts of edges"), divisions_);
  form->addRow(tr("&Directions every"), angle_);
  form->addRow(tr("&Grid"), grid_);
  form->addRow(tr("&Reach"), radius_);
  form->addRow({}, remark(tr("Holding Ctrl while drawing suspends all of this.")));
  for (QCheckBox* box : {snap_, vertices_, midpoints_, crossings_, edges_})
    connect(box, &QCheckBox::toggled, this, &PreferencesDialog::apply);
  connect(divisions_, &QSpinBox::valueChanged, this, &PreferencesDialog::apply);
  for (QDoubleSpinBox* box : {angle_, grid_, radius_})
    connect(box, &QDoubleSpinBox::valueChanged, this, &PreferencesDialog::apply);
  return page;
}

void PreferencesDialog::addLanguages() {
  language_->addItem(tr("As the desktop"), QString());
  language_->addItem(QStringLiteral("English"), QStringLiteral("en"));
  language_->addItem(QStringLiteral("Deutsch"), QStringLiteral("de"));
}

void PreferencesDialog::show(const Preferences& p) {
  isShowing_ = true;
  choose(*theme_, static_cast<int>(p.theme));
  choose(*lines_, static_cast<int>(p.lineStyle));
  language_->setCurrentIndex(std::max(0, language_->findData(p.language)));
  perspective_->setChecked(p.hasPerspective);
  field_->setValue(p.fieldOfView);
  field_->setEnabled(p.hasPerspective);
  startPage_->setChecked(p.showsStartPage);
  tips_->setChecked(p.showsTips);
  autosave_->setChecked(p.autosaves);
  snap_->setChecked(p.snaps.isOn);
  vertices_->setChecked(p.snaps.toVertices);
  midpoints_->setChecked(p.snaps.toMidpoints);
  crossings_->setChecked(p.snaps.toCrossings);
  edges_->setChecked(p.snaps.toEdges);
  divisions_->setValue(std::max(1, p.snaps.divisions));
  angle_->setValue(p.snaps.angleStep);
  grid_->setValue(p.snaps.gridSpacing);
  radius_->setValue(p.snaps.radius);
  isShowing_ = false;
}

Preferences PreferencesDialog::preferences() const {
  Preferences p = settings_.preferences();
  p.theme = static_cast<ThemeChoice>(chosenIn(*theme_));
  p.lineStyle = static_cast<LineStyle>(chosenIn(*lines_));
  p.language = language_->currentData().toString();
  p.hasPerspective = perspective_->isChecked();
  p.fieldOfView = field_->value();
  p.showsStartPage = startPage_->isChecked();
  p.showsTips = tips_->isChecked();
  p.autosaves = autosave_->isChecked();
  p.snaps.isOn = snap_->isChecked();
  p.snaps.toVertices = vertices_->isChecked();
  p.snaps.toMidpoints = midpoints_->isChecked();
  p.snaps.toCrossings = crossings_->isChecked();
  p.snaps.toEdges = edges_->isChecked();
  p.snaps.divisions = divisions_->value() > 1 ? divisions_->value() : 0;
  p.snaps.angleStep = angle_->value();
  p.snaps.gridSpacing = grid_->value();
  p.snaps.radius = radius_->value();
  return p;
}

void PreferencesDialog::apply() {
  if (!isShowing_) settings_.setPreferences(preferences());
}

void PreferencesDialog::showShortcuts() { pages_->setCurrentWidget(shortcuts_); }

void PreferencesDialog::accept() {
  if (shortcuts_->shortcuts() != settings_.shortcuts())
    settings_.setShortcuts(shortcuts_->shortcuts());
  QDialog::accept();
}

void PreferencesDialog::reject() {
  settings_.setPreferences(before_);
  QDialog::reject();
}

}  // namespace kiri::desktop
