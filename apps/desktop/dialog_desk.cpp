// What the window asks and offers in dialogs, the start page, the tour, and what it keeps safe.
// SPDX-License-Identifier: MIT
#include "apps/desktop/dialog_desk.h"

#include <QApplication>
#include <QDockWidget>
#include <QMainWindow>
#include <QPointer>
#include <QStatusBar>
#include <QToolBar>
#include <memory>
#include <optional>
#include <utility>

#include "apps/desktop/dialogs/about_dialog.h"
#include "apps/desktop/dialogs/appearance_dialog.h"
#include "apps/desktop/dialogs/export_dialog.h"
#include "apps/desktop/dialogs/film_dialog.h"
#include "apps/desktop/dialogs/preferences_dialog.h"
#include "apps/desktop/dialogs/print_dialog.h"
#include "apps/desktop/dialogs/properties_dialog.h"
#include "apps/desktop/dialogs/recovery_dialog.h"
#include "apps/desktop/dialogs/sheet_dialog.h"
#include "apps/desktop/look/convert.h"
#include "apps/desktop/services/crash_handler.h"
#include "apps/desktop/services/gallery.h"
#include "apps/desktop/services/pool_runner.h"
#include "editor/document/journal.h"
#include "io/file.h"
#include "io/kiri_reader.h"

namespace kiri::desktop {

namespace {

/// Words for a menu, where a single & would mark a key.
QString plain(QString words) { return words.replace('&', "&&"); }

}  // namespace

DialogDesk::DialogDesk(QMainWindow& window, SessionHub& hub, Settings& settings, Actions& actions,
                       FileDesk& files, ModelView& view)
    : QObject(&window),
      window_(window),
      hub_(hub),
      settings_(settings),
      actions_(actions),
      files_(files),
      view_(view),
      autosave_(hub.runner(), journalFolder()) {
  QWidget* panes = window.takeCentralWidget();
  stack_ = new QStackedWidget(&window);
  start_ = new StartPage(hub.runner(), settings, stack_);
  stack_->addWidget(panes);
  stack_->addWidget(start_);
  window.setCentralWidget(stack_);
  panes->show();
  tour_ = new TourCard(hub, panes);
  connectActions();
  connectStartPage();
  connectSafety();
}

void DialogDesk::on(const QString& id, std::function<void()> what) {
  connect(&actions_[id], &QAction::triggered, this, [what = std::move(what)] { what(); });
}

void DialogDesk::connectActions() {
  on("new", [this] { askSheet(); });
  on("start-page", [this] { showStartPage(!isStartPageShown()); });
  on("export", [this] {
    open(new ExportDialog(source(), hub_.runner(), settings_, QApplication::applicationVersion(),
                          &window_));
  });
  on("film", [this] { open(new FilmDialog(source(), hub_.runner(), settings_, &window_)); });
  on("print", [this] { open(new PrintDialog(source(), hub_.runner(), settings_, &window_)); });
  on("appearance", [this] { askAppearance(); });
  on("properties", [this] { askProperties(); });
  on("preferences", [this] { askPreferences(false); });
  on("shortcuts", [this] { askPreferences(true); });
  on("tour", [this] { beginTour(); });
  on("about", [this] {
    open(new AboutDialog(QApplication::applicationVersion(), view_.description(), &window_));
  });
}

void DialogDesk::connectStartPage() {
  connect(start_, &StartPage::modelChosen, &files_,
          [this](const Model& model) { files_.openModel(model); });
  connect(start_, &StartPage::otherSheetWanted, this, &DialogDesk::askSheet);
  connect(start_, &StartPage::openWanted, &files_, &FileDesk::askAndOpen);
  connect(start_, &StartPage::fileChosen, &files_, &FileDesk::openFile);
  connect(start_, &StartPage::exampleChosen, this, &DialogDesk::openExample);
  connect(start_, &StartPage::tourWanted, this, &DialogDesk::beginTour);
  connect(start_, &StartPage::closeWanted, this, [this] { showStartPage(false); });
  connect(&files_, &FileDesk::opened, this, [this] {
    showStartPage(false);
    // The person may have said that the open model stays, and opened another one later.
    const bool isTour = hub_.session().document().model().title == Tour::startModel().title;
    if (std::exchange(isTourWanted_, false) && isTour) {
      tour_->begin();
    } else {
      tour_->end();
    }
  });
}

void DialogDesk::connectSafety() {
  connect(&hub_, &SessionHub::documentChanged, this,
          [this] { autosave_.note(hub_.session().document()); });
  const auto apply = [this] {
    autosave_.setEnabled(settings_.preferences().autosaves);
    autosave_.note(hub_.session().document());
  };
  connect(&settings_, &Settings::preferencesChanged, this, apply);
  apply();
  connect(&autosave_, &Autosave::failed, this, [this](const QString& why) {
    window_.statusBar()->showMessage(
        tr("Your steps cannot be kept safe from crashes: %1").arg(why));
  });
  if (auto* application = qobject_cast<Application*>(QApplication::instance())) {
    connect(application, &Application::defectFound, this,
            [this](const QString& sentence, const QString& report) {
              showDefect(&window_, sentence, report);
            });
  }
  if (auto* runner = dynamic_cast<PoolRunner*>(&hub_.runner())) {
    connect(runner, &PoolRunner::defectFound, this, [this](const QString& sentence) {
      showDefect(&window_, sentence, writeDefectReport(sentence));
    });
  }
}

void DialogDesk::open(QDialog* dialog) {
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->open();
}

ExportSource DialogDesk::source() const {
  return exportSourceOf(hub_.session().document(), hub_.session().camera().map().frame);
}

void DialogDesk::showStartPage(bool isShown) {
  if (isShown == isStartPageShown()) return;
  if (isShown) {
    layout_ = window_.saveState();
    hidePanels();
  }
  stack_->setCurrentIndex(isShown ? 1 : 0);
  if (!isShown) window_.restoreState(std::exchange(layout_, {}));
  if (isShown) start_->setFocus();
  emit startPageShown(isShown);
}

/// Tools and panels have nothing to work on while the start page is there.
void DialogDesk::hidePanels() {
  for (QDockWidget* dock : window_.findChildren<QDockWidget*>()) dock->hide();
  for (QToolBar* bar : window_.findChildren<QToolBar*>()) {
    if (bar->objectName() == "tools") bar->hide();
  }
}

QByteArray DialogDesk::windowLayout() const {
  return isStartPageShown() ? layout_ : window_.saveState();
}

void DialogDesk::askSheet() {
  auto* dialog = new SheetDialog(hub_.session().document().model().sheet, &window_);
  connect(dialog, &QDialog::accepted, this, [this, dialog] { files_.openModel(dialog->model()); });
  open(dialog);
}

void DialogDesk::askAppearance() {
  const Document& document = hub_.session().document();
  auto* dialog = new AppearanceDialog(document.model().front, document.model().back,
                                      toQt(document.path()), hub_.runner(), &window_);
  connect(dialog, &QDialog::accepted, this, [this, dialog] {
    if (!dialog->isChanged()) return;
    hub_.session().change(setSides(dialog->front(), dialog->back()),
                          {QT_TRANSLATE_NOOP("editor/session", "new colours"), {}});
  });
  open(dialog);
}

void DialogDesk::askProperties() {
  const Model& model = hub_.session().document().model();
  auto* dialog = new PropertiesDialog(toQt(model.title), toQt(model.notes), &window_);
  connect(dialog, &QDialog::accepted, this, [this, dialog] {
    hub_.session().change(setTitle(dialog->title().toStdString(), dialog->notes().toStdString()),
                          {QT_TRANSLATE_NOOP("editor/session", "new title"), {}});
  });
  open(dialog);
}

void DialogDesk::askPreferences(bool showsKeys) {
  QMap<QString, Keys> own;
  for (const QAction* action : actions_.all())
    own.insert(action->objectName(), actions_.defaultKeys(action->objectName()));
  auto* dialog = new PreferencesDialog(settings_, actions_.all(), own, &window_);
  if (showsKeys) dialog->showShortcuts();
  open(dialog);
}

void DialogDesk::openExample(const QString& path) {
  auto model = std::make_shared<std::optional<Model>>();
  hub_.runner().start({{},
                       [path = path.toStdString(), model](const Progress&) {
                         const Result<std::string> text = readFile(path);
                         if (!text.isOk()) return;
                         Result<LoadedModel> loaded = readKiri(*text, path);
                         if (loaded.isOk()) *model = std::move(loaded->model);
                       },
                       [desk = QPointer<DialogDesk>(this), model] {
                         if (desk && *model) desk->files_.openModel(**model);
                       }});
}

void DialogDesk::fillExamples(QMenu& menu) {
  menu.clear();
  for (const ExampleGroup& group : exampleGroups()) {
    QMenu* inside = group.title.isEmpty() ? &menu : menu.addMenu(plain(group.title));
    for (const QString& path : group.models) {
      const ModelCard card = start_->cards().card(path);
      QAction* action =
          inside->addAction(plain(card.title), this, [this, path] { openExample(path); });
      action->setStatusTip(card.figure);
    }
  }
  menu.setEnabled(!menu.isEmpty());
}

void DialogDesk::beginTour() {
  isTourWanted_ = true;
  files_.openModel(Tour::startModel());
}

void DialogDesk::begin(bool opensFile) {
  if (!opensFile && settings_.preferences().showsStartPage) showStartPage(true);
  offerLeftovers();
}

void DialogDesk::offerLeftovers() {
  std::vector<Leftover> leftovers = leftoversIn(journalFolder().toStdString());
  if (leftovers.empty()) return discardReports(journalFolder());
  auto* dialog = new RecoveryDialog(std::move(leftovers), &window_);
  connect(dialog, &QDialog::accepted, this, [this, dialog] {
    const std::optional<Leftover> leftover = dialog->chosen();
    if (!leftover) return;
    auto document = std::make_shared<std::optional<Document>>();
    hub_.runner().start({{QT_TRANSLATE_NOOP("editor/session", "Folding the model"), {}},
                         [leftover = *leftover, document](const Progress& progress) {
                           Result<Recovered> kept = recover(leftover);
                           if (!kept.isOk()) return;
                           Result<Document> made =
                               Document::recovered(std::move(kept->model), kept->count, progress);
                           if (!made.isOk()) return;
                           made->setPath(kept->originalPath);
                           *document = std::move(*made);
                         },
                         [desk = QPointer<DialogDesk>(this), document, leftover = *leftover] {
                           if (!desk || !*document) return;
                           desk->hub_.session().open(std::move(**document));
                           desk->showStartPage(false);
                           // It goes when it is in the journal of this run.
                           connect(
                               &desk->autosave_, &Autosave::written, desk.data(),
                               [leftover] { discard(leftover); }, Qt::SingleShotConnection);
                         }});
  });
  open(dialog);
}

}  // namespace kiri::desktop
