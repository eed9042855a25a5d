// Export: pictures, patterns for machines, and files for other programs.
// SPDX-License-Identifier: MIT
#include "apps/desktop/dialogs/export_dialog.h"

#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QPointer>
#include <QUrl>
#include <QVBoxLayout>
#include <utility>

#include "apps/desktop/dialogs/form.h"
#include "apps/desktop/look/convert.h"
#include "render/canvas/rasterise.h"

namespace kiri::desktop {

namespace {

constexpr int kPreview = 380;  // pixels, device independent

/// The request as the preview draws it: small, and always a picture.
ExportRequest forPreview(ExportRequest request) {
  if (request.subject == ExportSubject::Sheet && request.format == ExportFormat::Svg &&
      request.isForMachines) {
    request.lineStyle = LineStyle::Program;
    request.isLinesOnly = true;
  }
  if (!isPicture(request.format)) {
    request.isShaded = !isPatternOnly(request.format);
    request.lineStyle = LineStyle::Program;
  }
  if (!request.background) request.background = Color{255, 255, 255};
  return request;
}

}  // namespace

ExportDialog::ExportDialog(ExportSource source, TaskRunner& runner, Settings& settings,
                           const QString& version, QWidget* parent)
    : QDialog(parent),
      source_(std::move(source)),
      settings_(settings),
      version_(version),
      previews_(runner) {
  setWindowTitle(tr("Export"));
  bar_ = new WorkBar(runner, this);
  preview_ = new QLabel;
  preview_->setFixedSize(kPreview, kPreview);
  preview_->setAlignment(Qt::AlignCenter);
  preview_->setFrameShape(QFrame::StyledPanel);
  preview_->setAccessibleName(tr("What the file will show"));
  facts_ = remark({});
  facts_->setAlignment(Qt::AlignCenter);

  auto* shown = new QVBoxLayout;
  shown->addWidget(preview_, 1, Qt::AlignCenter);
  shown->addWidget(facts_);
  auto* upper = new QHBoxLayout;
  upper->setSpacing(24);
  upper->addWidget(makeOptions(), 1);
  upper->addLayout(shown);

  export_ = new QPushButton(tr("Export…"));
  export_->setDefault(true);
  close_ = new QPushButton(tr("Close"));
  auto* buttons = new QHBoxLayout;
  buttons->addStretch();
  buttons->addWidget(close_);
  buttons->addWidget(export_);

  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(20, 20, 20, 16);
  layout->setSpacing(12);
  layout->addLayout(upper, 1);
  layout->addWidget(bar_);
  layout->addLayout(buttons);

  connect(export_, &QPushButton::clicked, this, &ExportDialog::chooseAndExport);
  connect(close_, &QPushButton::clicked, this, &ExportDialog::reject);
  connect(bar_, &WorkBar::busyChanged, this, [this](bool isBusy) {
    export_->setEnabled(!isBusy);
    close_->setText(isBusy ? tr("Cancel") : tr("Close"));
  });
  recall();
  showRows();
  askPreview();
}

QWidget* ExportDialog::makeOptions() {
  auto* options = new QWidget;
  form_ = formLayout();
  options->setLayout(form_);
  form_->setContentsMargins(0, 0, 0, 0);
  subject_ = choiceBox({{tr("The folded model"), static_cast<int>(ExportSubject::Model)},
                        {tr("The sheet with its creases"), static_cast<int>(ExportSubject::Sheet)}},
                       static_cast<int>(ExportSubject::Model));
  format_ = makeFormats();
  form_->addRow(tr("&What"), subject_);
  form_->addRow(tr("&Format"), format_);
  addPictureRows();
  addProgramRows();

  const auto changed = [this] {
    showRows();
    askPreview();
  };
  for (QComboBox* box : {subject_, format_, view_, lines_})
    connect(box, &QComboBox::currentIndexChanged, this, changed);
  for (QDoubleSpinBox* box : {scale_, margin_, dpi_, layerGap_, thickness_})
    connect(box, &QDoubleSpinBox::valueChanged, this, changed);
  for (QCheckBox* box :
       {creases_, shaded_, linesOnly_, machines_, white_, asFolded_, twoSided_, animated_})
    connect(box, &QCheckBox::toggled, this, changed);
  return options;
}

QComboBox* ExportDialog::makeFormats() {
  return choiceBox({{tr("SVG drawing"), static_cast<int>(ExportFormat::Svg)},
                    {tr("PDF document"), static_cast<int>(ExportFormat::Pdf)},
                    {tr("PNG picture"), static_cast<int>(ExportFormat::Png)},
                    {tr("FOLD, for origami programs"), static_cast<int>(ExportFormat::Fold)},
                    {tr("CP, of ORIPA and Oriedita"), static_cast<int>(ExportFormat::Cp)},
                    {tr("OPX, of ORIPA"), static_cast<int>(ExportFormat::Opx)},
                    {tr("DXF, for cutters and CAD"), static_cast<int>(ExportFormat::Dxf)},
                    {tr("Wavefront OBJ"), static_cast<int>(ExportFormat::Obj)},
                    {tr("STL, for 3-D printers"), static_cast<int>(ExportFormat::Stl)},
                    {tr("glTF, for viewers and the web"), static_cast<int>(ExportFormat::Gltf)}},
                   static_cast<int>(ExportFormat::Svg));
}

void ExportDialog::addPictureRows() {
  view_ = choiceBox({{tr("As on the screen"), static_cast<int>(ExportView::Screen)},
                     {tr("Front"), static_cast<int>(ExportView::Front)},
                     {tr("Back"), static_cast<int>(ExportView::Back)},
                     {tr("At an angle"), static_cast<int>(ExportView::Angled)}},
                    static_cast<int>(ExportView::Screen));
  lines_ = choiceBox(
      {{tr("Thesis: mountain blue, valley red"), static_cast<int>(LineStyle::Thesis)},
       {tr("Safe for colour-blind eyes"), static_cast<int>(LineStyle::Safe)},
       {tr("Origami programs: mountain red, valley blue"), static_cast<int>(LineStyle::Program)},
       {tr("Printed diagrams: black dashes"), static_cast<int>(LineStyle::Diagram)}},
      static_cast<int>(settings_.preferences().lineStyle));
  scale_ = numberBox(100, 1, 2000, tr(" %"), 0, 10);
  scale_->setToolTip(tr("100 %: one millimetre of paper is one millimetre of the picture"));
  margin_ = numberBox(5, 0, 500, tr(" mm"));
  dpi_ = numberBox(200, 20, 2400, tr(" dpi"), 0, 50);
  creases_ = new QCheckBox(tr("Creases that lie flat"));
  creases_->setChecked(true);
  shaded_ = new QCheckBox(tr("Facets turned away are darker"));
  linesOnly_ = new QCheckBox(tr("Lines only, without the colour of the paper"));
  machines_ = new QCheckBox(tr("Layers for cutting and scoring machines"));
  machines_->setToolTip(
      tr("Cuts, mountains and valleys in groups and in the colours that cutters and origami "
         "programs expect"));
  machines_->setChecked(true);
  white_ = new QCheckBox(tr("White ground instead of none"));
  form_->addRow(tr("&View"), view_);
  form_->addRow(tr("Creases"), lines_);
  form_->addRow(tr("&Size"), scale_);
  form_->addRow(tr("&Margin"), margin_);
  form_->addRow(tr("&Resolution"), dpi_);
  for (QCheckBox* box : {creases_, shaded_, machines_, linesOnly_, white_}) form_->addRow({}, box);
}

void ExportDialog::addProgramRows() {
  asFolded_ = new QCheckBox(tr("Unfolded creases count as folded"));
  asFolded_->setToolTip(
      tr("Creases that lie flat again get the angle of their fold, so that the pattern folds in "
         "other programs"));
  layerGap_ = numberBox(0, 0, 100, tr(" mm"), 2, 0.05);
  thickness_ = numberBox(0, 0, 100, tr(" mm"), 2, 0.05);
  twoSided_ = new QCheckBox(tr("Triangles for the back as well"));
  animated_ = new QCheckBox(tr("All steps in motion"));
  form_->addRow(tr("&Gap between layers"), layerGap_);
  form_->addRow(tr("&Thickness of paper"), thickness_);
  for (QCheckBox* box : {asFolded_, twoSided_, animated_}) form_->addRow({}, box);
}

void ExportDialog::showRows() {
  const auto format = static_cast<ExportFormat>(chosenIn(*format_));
  const bool isPattern = isPatternOnly(format);
  const bool isSheet = isPattern || chosenIn(*subject_) == static_cast<int>(ExportSubject::Sheet);
  const bool isDrawn = isPicture(format);
  const bool isLayered = isSheet && format == ExportFormat::Svg && machines_->isChecked();
  const bool isSolid = !isDrawn && !isPattern && format != ExportFormat::Fold;
  subject_->setEnabled(!isPattern);
  setRowVisible(*form_, *view_, isDrawn && !isSheet);
  setRowVisible(*form_, *lines_, isDrawn && isSheet && !isLayered);
  setRowVisible(*form_, *scale_, isDrawn && !isLayered);
  setRowVisible(*form_, *margin_, isDrawn);
  setRowVisible(*form_, *dpi_, format == ExportFormat::Png);
  setRowVisible(*form_, *creases_, isDrawn && !isSheet);
  setRowVisible(*form_, *shaded_, isDrawn && !isSheet);
  setRowVisible(*form_, *machines_, isSheet && format == ExportFormat::Svg);
  setRowVisible(*form_, *linesOnly_, isDrawn && isSheet && !isLayered);
  setRowVisible(*form_, *white_, isDrawn && !isLayered);
  setRowVisible(*form_, *asFolded_,
                isSheet && (isDrawn || isPattern || format == ExportFormat::Fold));
  setRowVisible(*form_, *layerGap_, isSolid);
  setRowVisible(*form_, *thickness_, isSolid);
  setRowVisible(*form_, *twoSided_, format == ExportFormat::Obj);
  setRowVisible(*form_, *animated_, format == ExportFormat::Gltf && !isSheet);
}

ExportRequest ExportDialog::request() const {
  ExportRequest request;
  request.subject = static_cast<ExportSubject>(chosenIn(*subject_));
  request.format = static_cast<ExportFormat>(chosenIn(*format_));
  if (isPatternOnly(request.format)) request.subject = ExportSubject::Sheet;
  request.view = static_cast<ExportView>(chosenIn(*view_));
  request.lineStyle = static_cast<LineStyle>(chosenIn(*lines_));
  request.scale = scale_->value() / 100;
  request.margin = margin_->value();
  request.dpi = dpi_->value();
  request.showsCreases = creases_->isChecked();
  request.isShaded = shaded_->isChecked();
  request.isLinesOnly = linesOnly_->isChecked();
  request.isForMachines = machines_->isChecked();
  if (white_->isChecked()) request.background = Color{255, 255, 255};
  const bool isSheet = request.subject == ExportSubject::Sheet;
  request.isAsFolded = isSheet && asFolded_->isChecked();
  request.layerGap = layerGap_->value();
  request.thickness = thickness_->value();
  request.isTwoSided = twoSided_->isChecked();
  request.isAnimated = !isSheet && animated_->isChecked();
  request.version = version_;
  return request;
}

void ExportDialog::askPreview() {
  auto picture = std::make_shared<QImage>();
  auto facts = std::make_shared<QSizeF>();
  auto losses = std::make_shared<std::vector<std::string>>();
  const double ratio = devicePixelRatioF();
  const int pixels = static_cast<int>((kPreview - 2) * ratio);
  Task task;
  task.work = [source = source_, request = forPreview(request()), picture, facts, losses, pixels,
               ratio](const Progress& progress) {
    *losses = lossesOf(source, request);
    const Result<Scene> scene = sceneOf(source, request, progress);
    if (!scene.isOk()) return;
    *facts = QSizeF(scene->width, scene->height);
    const Result<Image> image = rasterise(*scene, pixels, pixels);
    if (!image.isOk()) return;
    *picture = toQt(*image);
    picture->setDevicePixelRatio(ratio);
  };
  task.done = [this, picture, facts, losses] {
    showPreview(*picture);
    if (!losses->empty()) {
      QString text = tr("This format cannot hold:");
      for (const std::string& loss : *losses) text += "\n" + sentenceOf(loss);
      return facts_->setText(text);
    }
    const bool isDrawn = isPicture(request().format);
    facts_->setText(
        isDrawn ? tr("%1 × %2 mm").arg(facts->width(), 0, 'f', 1).arg(facts->height(), 0, 'f', 1)
                : QString());
  };
  previews_.ask(std::move(task));
}

void ExportDialog::showPreview(const QImage& picture) {
  preview_->setPixmap(QPixmap::fromImage(picture));
}

void ExportDialog::chooseAndExport() {
  const QString ending = endingOf(request().format);
  const QString name = source_.title.isEmpty() ? tr("model") : source_.title;
  const QString folder = settings_.folderFor("picture");
  const QString path =
      QFileDialog::getSaveFileName(this, tr("Export"), QDir(folder).filePath(name + "." + ending),
                                   tr("%1 files (*.%2)").arg(ending.toUpper(), ending));
  if (path.isEmpty()) return;
  settings_.setFolderFor("picture", QFileInfo(path).absolutePath());
  exportInto(QFileInfo(path).suffix().isEmpty() ? path + "." + ending : path);
}

void ExportDialog::exportInto(const QString& path) {
  remember();
  ExportRequest request = this->request();
  request.path = path;
  using Outcome = Result<std::vector<std::string>>;
  auto outcome = std::make_shared<Outcome>(Error{ErrorCode::Cancelled, "", {}});
  bar_->start(
      tr("Writing %1…").arg(QFileInfo(path).fileName()),
      [source = source_, request, outcome](const Progress& progress) {
        *outcome = exportTo(source, request, progress);
      },
      [this, path, outcome] { ended(path, *outcome); });
}

void ExportDialog::ended(const QString& path, const Result<std::vector<std::string>>& outcome) {
  if (!outcome.isOk()) {
    const bool isStopped = outcome.error().code == ErrorCode::Cancelled;
    bar_->say(isStopped ? tr("Stopped; nothing was written.") : sentenceOf(outcome.error().message),
              !isStopped);
    return;
  }
  const QUrl folder = QUrl::fromLocalFile(QFileInfo(path).absolutePath());
  QString said =
      tr("Written: <a href=\"%1\">%2</a>.")
          .arg(folder.toString(QUrl::FullyEncoded), QFileInfo(path).fileName().toHtmlEscaped());
  for (const std::string& loss : *outcome) said += "<br>" + sentenceOf(loss).toHtmlEscaped();
  bar_->say(said);
  emit exported(path);
}

void ExportDialog::remember() {
  settings_.setValue("export/subject", chosenIn(*subject_));
  settings_.setValue("export/format", chosenIn(*format_));
  settings_.setValue("export/dpi", dpi_->value());
  settings_.setValue("export/margin", margin_->value());
}

void ExportDialog::recall() {
  choose(*subject_, settings_.value("export/subject", 0).toInt());
  choose(*format_, settings_.value("export/format", 0).toInt());
  dpi_->setValue(settings_.value("export/dpi", dpi_->value()).toDouble());
  margin_->setValue(settings_.value("export/margin", margin_->value()).toDouble());
}

void ExportDialog::reject() {
  if (bar_->isBusy()) {
    bar_->stop();
    return;
  }
  QDialog::reject();
}

}  // namespace kiri::desktop
