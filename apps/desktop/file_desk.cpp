// Opening, saving and closing models, with care for what is not saved.
// SPDX-License-Identifier: MIT
#include "apps/desktop/file_desk.h"

#include <QFileInfo>
#include <QMimeData>
#include <QPointer>
#include <QUrl>
#include <optional>
#include <utility>

#include "apps/desktop/look/convert.h"
#include "editor/document/pattern_import.h"
#include "io/file.h"
#include "io/kiri_reader.h"
#include "io/kiri_writer.h"

namespace kiri::desktop {

/// What came of a file: a document, or a sentence.
struct FileDesk::Reading {
  std::optional<Document> document;
  std::optional<Error> error;
  QStringList warnings;
  PatternReport report;
};

namespace {

/// The first file of the data that can be opened.
QString fileIn(const QMimeData& data) {
  for (const QUrl& url : data.urls()) {
    QString file = url.toLocalFile();
    if (file.endsWith(".kiri", Qt::CaseInsensitive) || isPatternName(file.toStdString()))
      return file;
  }
  return {};
}

/// The text of a crease pattern; empty: there is none.
std::string textIn(const QMimeData& data) {
  for (const char* format : {"image/svg+xml", "application/json"}) {
    std::string text = data.data(format).toStdString();
    if (!text.empty() && isPatternText(text)) return text;
  }
  std::string text = data.text().toStdString();
  return isPatternText(text) ? text : std::string();
}

Phrase phrase(const char* text, const QString& argument) {
  return {text, {argument.toStdString()}};
}

}  // namespace

FileDesk::FileDesk(SessionHub& hub, Settings& settings, std::unique_ptr<FilePrompts> prompts,
                   QObject* parent)
    : QObject(parent), hub_(hub), settings_(settings), prompts_(std::move(prompts)) {}

QString FileDesk::name() const {
  const Document& document = hub_.session().document();
  if (!document.path().empty()) return QFileInfo(toQt(document.path())).fileName();
  const QString title = toQt(document.model().title);
  return title.isEmpty() ? tr("Untitled") : title;
}

bool FileDesk::isModified() const { return hub_.session().document().isModified(); }

void FileDesk::whenSafe(std::function<void()> goOn) {
  if (!isModified()) return goOn();
  switch (prompts_->askToSave(name())) {
    case SaveAnswer::Save:
      return saveThen(std::move(goOn));
    case SaveAnswer::Discard:
      return goOn();
    case SaveAnswer::Cancel:
      return;
  }
}

void FileDesk::openModel(Model model) {
  whenSafe([this, model = std::move(model)] { show(model); });
}

void FileDesk::openFile(const QString& path) {
  whenSafe([this, path] { read(path); });
}

bool FileDesk::canOpen(const QMimeData& data) {
  return !fileIn(data).isEmpty() || !textIn(data).empty();
}

void FileDesk::openData(const QMimeData& data) {
  if (const QString file = fileIn(data); !file.isEmpty()) return openFile(file);
  std::string text = textIn(data);
  if (text.empty()) {
    emit warned(
        {tr("There is no crease pattern on the clipboard: copy a file (FOLD, CP, OPX, SVG, "
            "DXF) or the text of one")});
    return;
  }
  whenSafe([this, text = std::move(text)] { importText(text); });
}

void FileDesk::askAndOpen() {
  whenSafe([this] {
    const QString path = prompts_->fileToOpen();
    if (!path.isEmpty()) read(path);
  });
}

void FileDesk::show(const Model& model) {
  isBusy_ = true;
  auto reading = std::make_shared<Reading>();
  const auto work = [reading, model](const Progress& progress) {
    Result<Document> made = Document::create(model, progress);
    if (made) {
      reading->document = std::move(*made);
    } else {
      reading->error = made.error();
    }
  };
  const auto done = [desk = QPointer<FileDesk>(this), reading] {
    if (desk) desk->finishReading(*reading, {});
  };
  hub_.runner().start({{QT_TRANSLATE_NOOP("editor/session", "Folding the model"), {}}, work, done});
}

void FileDesk::read(const QString& path) {
  if (isPatternName(path.toStdString())) return importFile(path);
  isBusy_ = true;
  const QString absolute = QFileInfo(path).absoluteFilePath();
  auto reading = std::make_shared<Reading>();
  const auto work = [reading, file = absolute.toStdString(),
                     name = QFileInfo(path).fileName().toStdString()](const Progress& progress) {
    const auto fail = [&](const Error& error) { reading->error = error; };
    const Result<std::string> bytes = readFile(file);
    if (!bytes) return fail(bytes.error());
    Result<LoadedModel> loaded = readKiri(*bytes, name);
    if (!loaded) return fail(loaded.error());
    for (const std::string& warning : loaded->warnings) reading->warnings << toQt(warning);
    Result<Document> made = Document::create(std::move(loaded->model), progress);
    if (!made) return fail(made.error());
    reading->document = std::move(*made);
    reading->document->setPath(file);
    reading->document->noteSaved();
  };
  hub_.runner().start(
      {phrase(QT_TRANSLATE_NOOP("editor/session", "Opening %1"), QFileInfo(path).fileName()), work,
       [desk = QPointer<FileDesk>(this), reading, absolute] {
         if (desk) desk->finishReading(*reading, absolute);
       }});
}

void FileDesk::import(const std::string& text, const std::string& name, Reading& reading,
                      const Progress& progress) {
  const auto part = [&progress](double from, double to) -> Progress {
    return
        [&progress, from, to](double done) { return goesOn(progress, from + (to - from) * done); };
  };
  Result<PatternImport> made = importPattern(text, name, PatternUse::Folded, part(0, 0.8));
  if (!made) {
    reading.error = made.error();
    return;
  }
  Result<Document> document = Document::create(std::move(made->model), part(0.8, 1));
  if (!document) {
    reading.error = document.error();
    return;
  }
  reading.document = std::move(*document);
  reading.report = std::move(made->report);
}

void FileDesk::importFile(const QString& path) {
  isBusy_ = true;
  const QString absolute = QFileInfo(path).absoluteFilePath();
  auto reading = std::make_shared<Reading>();
  const auto work = [reading, file = absolute.toStdString(),
                     name = QFileInfo(path).fileName().toStdString()](const Progress& progress) {
    const Result<std::string> bytes = readFile(file);
    if (bytes) {
      import(*bytes, name, *reading, progress);
    } else {
      reading->error = bytes.error();
    }
  };
  hub_.runner().start(
      {phrase(QT_TRANSLATE_NOOP("editor/session", "Opening %1"), QFileInfo(path).fileName()), work,
       [desk = QPointer<FileDesk>(this), reading, absolute] {
         if (desk) desk->finishImport(*reading, absolute);
       }});
}

void FileDesk::importText(const std::string& text) {
  isBusy_ = true;
  auto reading = std::make_shared<Reading>();
  hub_.runner().start(
      {phrase(QT_TRANSLATE_NOOP("editor/session", "Opening %1"), tr("the pasted pattern")),
       [reading, text](const Progress& progress) { import(text, {}, *reading, progress); },
       [desk = QPointer<FileDesk>(this), reading] {
         if (desk) desk->finishImport(*reading, {});
       }});
}

void FileDesk::finishImport(const Reading& reading, const QString& path) {
  const bool isThere = reading.document.has_value() && !reading.error;
  std::vector<std::string> losses = reading.report.losses;
  finishReading(reading, path);
  if (!isThere) return;
  losses_ = std::move(losses);
  emit patternOpened();
}

void FileDesk::finishReading(const Reading& reading, const QString& path) {
  isBusy_ = false;
  if (reading.error && reading.error->code == ErrorCode::Cancelled) return;
  if (reading.error) {
    if (!path.isEmpty()) settings_.removeRecentFile(path);
    return tell(tr("The model cannot be opened"), toQt(reading.error->message));
  }
  if (!reading.document) return;  // stopped
  losses_.clear();
  hub_.session().open(*reading.document, reading.report);
  if (!path.isEmpty()) settings_.addRecentFile(path);
  emit opened();
  if (!reading.warnings.isEmpty()) emit warned(reading.warnings);
}

void FileDesk::save() { saveThen({}); }

void FileDesk::saveAs() {
  const Document& document = hub_.session().document();
  const QString suggestion = document.path().empty() ? name() + ".kiri" : toQt(document.path());
  const QString path = prompts_->fileToSave(suggestion);
  if (!path.isEmpty()) write(path, {});
}

void FileDesk::saveThen(std::function<void()> then) {
  const Document& document = hub_.session().document();
  QString path = toQt(document.path());
  if (path.isEmpty()) path = prompts_->fileToSave(name() + ".kiri");
  if (!path.isEmpty()) write(path, std::move(then));
}

void FileDesk::write(const QString& path, std::function<void()> then) {
  if (isPatternName(path.toStdString())) {
    return tell(tr("The model cannot be saved"),
                tr("%1 has the name of a crease pattern. A model is saved as .kiri, with all its "
                   "steps; use Export to write a crease pattern.")
                    .arg(QFileInfo(path).fileName()));
  }
  isBusy_ = true;
  const Document& document = hub_.session().document();
  auto problem = std::make_shared<std::optional<Error>>();
  const auto work = [problem, file = path.toStdString(),
                     model = document.modelToSave()](const Progress&) {
    const Status written = writeFile(file, writeKiri(model));
    if (!written) *problem = written.error();
  };
  const auto done = [desk = QPointer<FileDesk>(this), problem, path, then = std::move(then),
                     revision = document.revision()] {
    if (!desk) return;
    desk->isBusy_ = false;
    if (*problem) {
      return desk->tell(tr("The model cannot be saved"), toQt((*problem)->message));
    }
    // A step that was made meanwhile is saved as well.
    if (desk->hub_.session().document().revision() != revision) return desk->write(path, then);
    desk->hub_.session().noteSaved(path.toStdString());
    desk->settings_.addRecentFile(path);
    emit desk->saved(path);
    desk->tellLosses();
    if (then) then();
  };
  hub_.runner().start(
      {phrase(QT_TRANSLATE_NOOP("editor/session", "Saving %1"), QFileInfo(path).fileName()), work,
       done});
}

/// Once, after an imported pattern was saved as a model for the first time.
void FileDesk::tellLosses() {
  QStringList sentences;
  for (const std::string& loss : std::exchange(losses_, {})) sentences << toQt(loss);
  if (!sentences.isEmpty()) emit warned(sentences);
}

void FileDesk::tell(const QString& title, const QString& text) {
  emit failed(text);
  prompts_->tellProblem(title, text);
}

}  // namespace kiri::desktop
