// The window: panes in the middle, tools at the left, panels at the right and below.
// SPDX-License-Identifier: MIT
#include "apps/desktop/main_window.h"

#include <QApplication>
#include <QClipboard>
#include <QCloseEvent>
#include <QDragEnterEvent>
#include <QFileInfo>
#include <QMimeData>
#include <QSplitter>
#include <QVBoxLayout>

#include "apps/desktop/help_box.h"
#include "apps/desktop/look/theme.h"

namespace kiri::desktop {

MainWindow::MainWindow(PoolRunner& runner, Settings& settings, Options options, QWidget* parent)
    : QMainWindow(parent),
      runner_(runner),
      settings_(settings),
      hub_(runner),
      look_(hub_),
      menus_(makeMenus(*this, actions_)) {
  setWindowIcon(QIcon(":/icons/kirisim.svg"));
  setAcceptDrops(true);
  resize(1360, 880);
  makeCentre(options.drawing);
  docks_ = makeDocks(*this, hub_, *menus_.panels);
  menus_.panels->addAction(menus_.bar->toggleViewAction());
  menus_.panels->addAction(menus_.tools->toggleViewAction());
  status_ = new StatusLine(hub_, &runner, this);
  setStatusBar(status_);
  files_ = new FileDesk(hub_, settings, std::make_unique<DialogPrompts>(*this, settings), this);
  edit_ = new EditDesk(hub_, actions_, *docks_.player, this);
  view_ = new ViewDesk(hub_, look_, settings, actions_, {modelView_, sheetView_}, this);
  dialogs_ = new DialogDesk(*this, hub_, settings, actions_, *files_, *modelView_);
  connectFiles();
  connectParts();
  restoreLayout();
  refreshTitle();
  modelView_->setFocus();
}

MainWindow::~MainWindow() = default;

void MainWindow::makeCentre(ModelView::Drawing drawing) {
  auto* centre = new QWidget(this);
  auto* column = new QVBoxLayout(centre);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  fieldBar_ = new FieldBar(hub_, actions_["commit"], actions_["cancel"], centre);
  splitter_ = new QSplitter(Qt::Horizontal, centre);
  splitter_->setObjectName("panes");
  splitter_->setHandleWidth(3);
  splitter_->setChildrenCollapsible(false);
  modelView_ = new ModelView(hub_, look_, drawing, splitter_);
  sheetView_ = new SheetView(hub_, look_, splitter_);
  splitter_->addWidget(modelView_);
  splitter_->addWidget(sheetView_);
  splitter_->setStretchFactor(0, 5);
  splitter_->setStretchFactor(1, 3);
  splitter_->setSizes({5000, 3000});  // shares, until the person has chosen
  column->addWidget(fieldBar_);
  column->addWidget(splitter_, 1);
  caption_ = new CaptionBar(hub_, centre);
  column->addWidget(caption_);
  // Keys that mean other things elsewhere work in the panes and in the bar above them.
  for (QAction* action : actions_.all()) {
    if (actions_.scopeOf(*action) == KeyScope::Panes) centre->addAction(action);
  }
  setCentralWidget(centre);
}

void MainWindow::connectFiles() {
  const auto on = [this](const QString& id, auto what) {
    connect(&actions_[id], &QAction::triggered, this, what);
  };
  on("open", [this] { files_->askAndOpen(); });
  on("save", [this] { files_->save(); });
  on("save-as", [this] { files_->saveAs(); });
  on("paste", [this] { files_->openData(*QApplication::clipboard()->mimeData()); });
  on("quit", [this] { close(); });
  on("help", [this] { openHelp(*this, actions_); });
  connect(files_, &FileDesk::opened, this, [this] { modelView_->setFocus(); });
  connect(files_, &FileDesk::patternOpened, this, [this] {
    docks_.patternDock->show();
    docks_.patternDock->raise();
  });
  connect(files_, &FileDesk::saved, this, [this](const QString& path) {
    status_->say(Notice::Kind::Done, tr("Saved as %1").arg(path));
  });
  connect(files_, &FileDesk::warned, this, [this](const QStringList& sentences) {
    status_->say(Notice::Kind::Warning, sentences.join("; "));
  });
  connect(&look_, &AppearanceStore::failed, this,
          [this](const QString& sentence) { status_->say(Notice::Kind::Warning, sentence); });
  connect(menus_.recent, &QMenu::aboutToShow, this, &MainWindow::fillRecent);
  connect(menus_.examples, &QMenu::aboutToShow, this,
          [this] { dialogs_->fillExamples(*menus_.examples); });
}

void MainWindow::connectParts() {
  connect(&hub_, &SessionHub::documentChanged, this, &MainWindow::refreshTitle);
  connect(edit_, &EditDesk::toolChosen, fieldBar_,
          [this](const QAction& tool) { fieldBar_->setTool(tool); });
  connect(docks_.steps, &StepsList::editWanted, this, [this](int index) {
    docks_.stepDock->show();
    docks_.stepDock->raise();
    docks_.step->showStep(static_cast<std::size_t>(index));
  });
  connect(&actions_["next-state"], &QAction::triggered, docks_.pattern,
          [this] { docks_.pattern->walk(1); });
  connect(&actions_["previous-state"], &QAction::triggered, docks_.pattern,
          [this] { docks_.pattern->walk(-1); });
  connectCaption();
  connect(dialogs_, &DialogDesk::startPageShown, this, [this](bool isShown) {
    const QString hint =
        tr("Take a new sheet, a file or an example, or fold your first leaf; Esc: back to the "
           "model");
    status_->setElsewhere(isShown ? hint : QString());
  });
  connect(docks_.steps, &StepsList::removeWanted, edit_, &EditDesk::removeStep);
  connect(docks_.step, &StepPanel::removeWanted, edit_, &EditDesk::removeStep);
  connect(&actions_["full-screen"], &QAction::toggled, this,
          [this](bool isOn) { isOn ? showFullScreen() : showNormal(); });
  connect(&settings_, &Settings::shortcutsChanged, this,
          [this] { actions_.setKeys(settings_.shortcuts()); });
  connect(&settings_, &Settings::preferencesChanged, view_, &ViewDesk::applyPreferences);
  actions_.setKeys(settings_.shortcuts());
  fieldBar_->setTool(actions_["fold"]);
}

/// The buttons of the caption walk through the film while one is open, else through the steps.
void MainWindow::connectCaption() {
  connect(files_, &FileDesk::opened, caption_, &CaptionBar::introduce);
  connect(caption_, &CaptionBar::startWanted, this, [this] { hub_.session().jumpTo(0); });
  connect(caption_, &CaptionBar::stepWanted, this, [this](int by) {
    if (hub_.session().isPlayerOpen()) return docks_.player->skip(by);
    actions_[by < 0 ? "previous-step" : "next-step"].trigger();
  });
  QAction& notes = actions_["step-notes"];
  notes.setChecked(settings_.value("view/notes", true).toBool());
  caption_->setWanted(notes.isChecked());
  connect(&notes, &QAction::toggled, this, [this](bool isOn) {
    caption_->setWanted(isOn);
    settings_.setValue("view/notes", isOn);
  });
}

void MainWindow::refreshTitle() {
  setWindowTitle(files_->name() + "[*] – KiriSim");
  setWindowModified(files_->isModified());
}

void MainWindow::fillRecent() {
  menus_.recent->clear();
  for (const QString& file : settings_.recentFiles()) {
    QAction* action = menus_.recent->addAction(QFileInfo(file).fileName(), this,
                                               [this, file] { files_->openFile(file); });
    action->setStatusTip(file);
  }
  if (menus_.recent->isEmpty()) {
    menus_.recent->addAction(tr("No files yet"))->setEnabled(false);
    return;
  }
  menus_.recent->addSeparator();
  menus_.recent->addAction(tr("Forget these"), &settings_, &Settings::clearRecentFiles);
}

void MainWindow::restoreLayout() {
  restoreGeometry(settings_.layout("window-geometry"));
  restoreState(settings_.layout("window-state"));
  splitter_->restoreState(settings_.layout("window-panes"));
}

void MainWindow::closeEvent(QCloseEvent* event) {
  if (!mayClose_ && files_->isModified()) {
    event->ignore();
    // Saving takes place beside the window: it closes when that has ended.
    files_->whenSafe([this] {
      mayClose_ = true;
      QMetaObject::invokeMethod(this, &MainWindow::close, Qt::QueuedConnection);
    });
    return;
  }
  dialogs_->closing();
  settings_.setLayout("window-geometry", saveGeometry());
  settings_.setLayout("window-state", dialogs_->windowLayout());
  settings_.setLayout("window-panes", splitter_->saveState());
  event->accept();
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event) {
  if (FileDesk::canOpen(*event->mimeData())) event->acceptProposedAction();
}

void MainWindow::dropEvent(QDropEvent* event) {
  if (!FileDesk::canOpen(*event->mimeData())) return;
  event->acceptProposedAction();
  files_->openData(*event->mimeData());
}

}  // namespace kiri::desktop
