// The whole process as a film.
// SPDX-License-Identifier: MIT
#include "apps/desktop/dialogs/film_dialog.h"

#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QUrl>
#include <QVBoxLayout>
#include <algorithm>
#include <utility>

#include "apps/desktop/dialogs/form.h"

namespace kiri::desktop {

namespace {

constexpr QSize kSizes[] = {{480, 360}, {640, 480}, {1280, 720}, {1920, 1080}, {1080, 1080}};

}  // namespace

FilmDialog::FilmDialog(ExportSource source, TaskRunner& runner, Settings& settings, QWidget* parent)
    : QDialog(parent), source_(std::move(source)), settings_(settings) {
  setWindowTitle(tr("Export film"));
  bar_ = new WorkBar(runner, this);
  missing_ = new QLabel;
  missing_->setWordWrap(true);
  missing_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(20, 20, 20, 16);
  layout->setSpacing(12);
  layout->addWidget(remark(
      tr("The steps in motion, as the player shows them, seen by a camera that holds still or "
         "goes round the model.")));
  layout->addWidget(makeOptions());
  layout->addWidget(missing_);
  layout->addStretch();
  layout->addWidget(bar_);
  layout->addLayout(makeButtons());
  setMinimumWidth(460);
  lookForProgram();
}

QWidget* FilmDialog::makeOptions() {
  auto* options = new QWidget;
  QFormLayout* form = formLayout();
  options->setLayout(form);
  form->setContentsMargins(0, 0, 0, 0);
  format_ = choiceBox({{tr("MP4, plays everywhere"), static_cast<int>(FilmFormat::Mp4)},
                       {tr("GIF, runs by itself on web pages"), static_cast<int>(FilmFormat::Gif)},
                       {tr("WebP, without loss"), static_cast<int>(FilmFormat::WebP)}},
                      settings_.value("film/format", static_cast<int>(FilmFormat::Mp4)).toInt());
  size_ = new QComboBox;
  for (const QSize& size : kSizes)
    size_->addItem(tr("%1 × %2 pixels").arg(size.width()).arg(size.height()), size);
  size_->setCurrentIndex(std::max(0, size_->findData(settings_.value("film/size", kSizes[2]))));
  view_ = choiceBox({{tr("At an angle"), static_cast<int>(ExportView::Angled)},
                     {tr("Front"), static_cast<int>(ExportView::Front)},
                     {tr("Back"), static_cast<int>(ExportView::Back)}},
                    static_cast<int>(ExportView::Angled));
  turntable_ = new QCheckBox(tr("The camera goes once round the model"));
  creases_ = new QCheckBox(tr("Creases that lie flat"));
  creases_->setChecked(true);
  const int steps = std::max(1, static_cast<int>(source_.model.steps.size()));
  first_ = new QSpinBox;
  last_ = new QSpinBox;
  for (QSpinBox* box : {first_, last_}) {
    box->setRange(1, steps);
    box->setMinimumWidth(72);
  }
  last_->setValue(steps);
  connect(first_, &QSpinBox::valueChanged, last_, &QSpinBox::setMinimum);
  auto* both = new QWidget;
  both->setFocusProxy(first_);
  auto* range = new QHBoxLayout(both);
  range->setContentsMargins(0, 0, 0, 0);
  range->setSpacing(8);
  range->addWidget(first_);
  range->addWidget(new QLabel(tr("to")));
  range->addWidget(last_);
  range->addStretch();
  frames_ = numberBox(25, 5, 60, tr(" per second"), 0, 5);
  speed_ = numberBox(TimelineOptions{}.degreesPerSecond, 10, 1440, tr("° per second"), 0, 10);
  hold_ = numberBox(TimelineOptions{}.hold, 0, 20, tr(" s"), 1, 0.1);
  form->addRow(tr("&Format"), format_);
  form->addRow(tr("&Size"), size_);
  form->addRow(tr("&View"), view_);
  form->addRow({}, turntable_);
  form->addRow({}, creases_);
  form->addRow(tr("S&teps"), both);
  form->addRow(tr("F&rames"), frames_);
  form->addRow(tr("S&peed of folding"), speed_);
  form->addRow(tr("&Rest after each step"), hold_);
  return options;
}

QLayout* FilmDialog::makeButtons() {
  film_ = new QPushButton(tr("Export film…"));
  film_->setDefault(true);
  close_ = new QPushButton(tr("Close"));
  auto* buttons = new QHBoxLayout;
  buttons->addStretch();
  buttons->addWidget(close_);
  buttons->addWidget(film_);
  connect(film_, &QPushButton::clicked, this, &FilmDialog::chooseAndFilm);
  connect(close_, &QPushButton::clicked, this, &FilmDialog::reject);
  connect(bar_, &WorkBar::busyChanged, this, [this](bool isBusy) {
    close_->setText(isBusy ? tr("Cancel") : tr("Close"));
    film_->setEnabled(!isBusy);
  });
  return buttons;
}

void FilmDialog::lookForProgram() {
  QString sentence;
  if (!hasFilmProgram()) {
    sentence =
        tr("Films are made by the program ffmpeg, which is not installed here. On Debian "
           "and Ubuntu: <b>sudo apt install ffmpeg</b>. Then open this dialog again.");
  } else if (source_.model.steps.empty()) {
    sentence = tr("The model has no steps yet: there is nothing to film.");
  }
  missing_->setText(sentence);
  missing_->setVisible(!sentence.isEmpty());
  film_->setEnabled(sentence.isEmpty());
}

FilmRequest FilmDialog::request() const {
  FilmRequest request;
  request.format = static_cast<FilmFormat>(chosenIn(*format_));
  const QSize size = size_->currentData().toSize();
  request.width = size.width();
  request.height = size.height();
  request.framesPerSecond = frames_->value();
  request.view = static_cast<ExportView>(chosenIn(*view_));
  request.isTurntable = turntable_->isChecked();
  request.showsCreases = creases_->isChecked();
  request.lineStyle = settings_.preferences().lineStyle;
  request.time.firstStep = static_cast<std::size_t>(first_->value() - 1);
  request.time.lastStep = static_cast<std::size_t>(last_->value());
  request.time.degreesPerSecond = speed_->value();
  request.time.hold = hold_->value();
  return request;
}

void FilmDialog::chooseAndFilm() {
  const QString ending = endingOf(request().format);
  const QString name = source_.title.isEmpty() ? tr("model") : source_.title;
  const QString path = QFileDialog::getSaveFileName(
      this, tr("Export film"), QDir(settings_.folderFor("film")).filePath(name + "." + ending),
      tr("%1 files (*.%2)").arg(ending.toUpper(), ending));
  if (path.isEmpty()) return;
  settings_.setFolderFor("film", QFileInfo(path).absolutePath());
  filmInto(QFileInfo(path).suffix().isEmpty() ? path + "." + ending : path);
}

void FilmDialog::filmInto(const QString& path) {
  settings_.setValue("film/format", chosenIn(*format_));
  settings_.setValue("film/size", size_->currentData());
  FilmRequest request = this->request();
  request.path = path;
  auto outcome = std::make_shared<Status>(Error{ErrorCode::Cancelled, "", {}});
  bar_->start(
      tr("Filming %1…").arg(QFileInfo(path).fileName()),
      [source = source_, request, outcome](const Progress& progress) {
        *outcome = makeFilm(source, request, progress);
      },
      [this, path, outcome] { ended(path, *outcome); });
}

void FilmDialog::ended(const QString& path, const Status& outcome) {
  if (!outcome.isOk()) {
    const bool isStopped = outcome.error().code == ErrorCode::Cancelled;
    bar_->say(isStopped ? tr("Stopped; nothing was written.") : sentenceOf(outcome.error().message),
              !isStopped);
    return;
  }
  const QFileInfo file(path);
  bar_->say(tr("Written: <a href=\"%1\">%2</a>.")
                .arg(QUrl::fromLocalFile(file.absolutePath()).toString(QUrl::FullyEncoded),
                     file.fileName().toHtmlEscaped()));
  emit filmed(path);
}

void FilmDialog::reject() {
  if (bar_->isBusy()) {
    bar_->stop();
    return;
  }
  QDialog::reject();
}

}  // namespace kiri::desktop
