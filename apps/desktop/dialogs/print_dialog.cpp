// Printing in true size, over as many pages as it takes.
// SPDX-License-Identifier: MIT
#include "apps/desktop/dialogs/print_dialog.h"

#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QMessageBox>
#include <QPageLayout>
#include <QPageSize>
#include <QPrintDialog>
#include <QPrinterInfo>
#include <QTimer>
#include <QVBoxLayout>
#include <utility>

#include "apps/desktop/dialogs/form.h"

namespace kiri::desktop {

namespace {

constexpr QPageSize::PageSizeId kPapers[] = {QPageSize::A5, QPageSize::A4,     QPageSize::A3,
                                             QPageSize::A2, QPageSize::Letter, QPageSize::Legal};
constexpr double kPaperMargin = 8;  // mm that printers leave white

}  // namespace

PrintDialog::PrintDialog(ExportSource source, TaskRunner& runner, Settings& settings,
                         QWidget* parent)
    : QDialog(parent),
      source_(std::move(source)),
      settings_(settings),
      pictures_(runner),
      printer_(std::make_unique<QPrinter>(QPrinter::HighResolution)) {
  setWindowTitle(tr("Print"));
  if (QPrinterInfo::defaultPrinter().isNull()) printer_->setOutputFormat(QPrinter::PdfFormat);
  printer_->setDocName(source_.title);
  preview_ = new QPrintPreviewWidget(printer_.get(), this);
  preview_->setViewMode(QPrintPreviewWidget::AllPagesView);
  preview_->setMinimumSize(420, 420);
  connect(preview_, &QPrintPreviewWidget::paintRequested, this, &PrintDialog::paintPages);
  facts_ = remark({});

  auto* left = new QVBoxLayout;
  left->addWidget(makeOptions());
  left->addWidget(facts_);
  left->addStretch();
  auto* upper = new QHBoxLayout;
  upper->setSpacing(24);
  upper->addLayout(left);
  upper->addWidget(preview_, 1);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(20, 20, 20, 16);
  layout->setSpacing(12);
  layout->addLayout(upper, 1);
  layout->addLayout(makeButtons());
  resize(860, 600);
  showRows();
  setUpPage();
  askPicture();
}

// The preview looks at the printer until it is gone.
PrintDialog::~PrintDialog() { delete preview_; }

QWidget* PrintDialog::makeOptions() {
  auto* options = new QWidget;
  form_ = formLayout();
  options->setLayout(form_);
  form_->setContentsMargins(0, 0, 0, 0);
  subject_ = choiceBox({{tr("The sheet with its creases"), static_cast<int>(ExportSubject::Sheet)},
                        {tr("The folded model"), static_cast<int>(ExportSubject::Model)}},
                       static_cast<int>(ExportSubject::Sheet));
  view_ = choiceBox({{tr("Front"), static_cast<int>(ExportView::Front)},
                     {tr("Back"), static_cast<int>(ExportView::Back)},
                     {tr("As on the screen"), static_cast<int>(ExportView::Screen)}},
                    static_cast<int>(ExportView::Front));
  lines_ = choiceBox({{tr("In colour"), static_cast<int>(settings_.preferences().lineStyle)},
                      {tr("Black dashes"), static_cast<int>(LineStyle::Diagram)}},
                     static_cast<int>(settings_.preferences().lineStyle));
  size_ = new QComboBox;
  for (const QPageSize::PageSizeId id : kPapers) size_->addItem(QPageSize::name(id), id);
  size_->setCurrentIndex(size_->findData(settings_.value("print/paper", QPageSize::A4).toInt()));
  orientation_ =
      choiceBox({{tr("Upright"), QPageLayout::Portrait}, {tr("Lying"), QPageLayout::Landscape}},
                QPageLayout::Portrait);
  scale_ = numberBox(100, 5, 1000, tr(" %"), 0, 10);
  overlap_ = numberBox(10, 0, 40, tr(" mm"), 0);
  linesOnly_ = new QCheckBox(tr("Lines only"));
  linesOnly_->setChecked(true);
  asFolded_ = new QCheckBox(tr("Unfolded creases too"));
  asFolded_->setChecked(true);
  form_->addRow(tr("&What"), subject_);
  form_->addRow(tr("&View"), view_);
  form_->addRow(tr("&Creases"), lines_);
  form_->addRow({}, linesOnly_);
  form_->addRow({}, asFolded_);
  form_->addRow(tr("&Size"), scale_);
  form_->addRow(tr("P&aper"), size_);
  form_->addRow(tr("&Orientation"), orientation_);
  form_->addRow(tr("&Glued strip"), overlap_);
  for (QComboBox* box : {subject_, view_, lines_})
    connect(box, &QComboBox::currentIndexChanged, this, [this] {
      showRows();
      askPicture();
    });
  for (QCheckBox* box : {linesOnly_, asFolded_})
    connect(box, &QCheckBox::toggled, this, &PrintDialog::askPicture);
  connect(scale_, &QDoubleSpinBox::valueChanged, this, &PrintDialog::askPicture);
  for (QComboBox* box : {size_, orientation_})
    connect(box, &QComboBox::currentIndexChanged, this, &PrintDialog::setUpPage);
  connect(overlap_, &QDoubleSpinBox::valueChanged, this, &PrintDialog::setUpPage);
  return options;
}

QLayout* PrintDialog::makeButtons() {
  print_ = new QPushButton(tr("Print…"));
  print_->setDefault(true);
  pdf_ = new QPushButton(tr("Save pages as PDF…"));
  auto* close = new QPushButton(tr("Close"));
  auto* buttons = new QHBoxLayout;
  buttons->addWidget(pdf_);
  buttons->addStretch();
  buttons->addWidget(close);
  buttons->addWidget(print_);
  if (QPrinterInfo::availablePrinters().isEmpty()) {
    print_->setEnabled(false);
    print_->setToolTip(tr("No printer is set up on this machine; pages can be saved as PDF"));
  }
  connect(print_, &QPushButton::clicked, this, &PrintDialog::print);
  connect(pdf_, &QPushButton::clicked, this, &PrintDialog::chooseAndPrintToPdf);
  connect(close, &QPushButton::clicked, this, &PrintDialog::reject);
  return buttons;
}

void PrintDialog::showRows() {
  const bool isSheet = chosenIn(*subject_) == static_cast<int>(ExportSubject::Sheet);
  setRowVisible(*form_, *view_, !isSheet);
  setRowVisible(*form_, *lines_, isSheet);
  setRowVisible(*form_, *linesOnly_, isSheet);
  setRowVisible(*form_, *asFolded_, isSheet);
}

ExportRequest PrintDialog::request() const {
  ExportRequest request;
  request.subject = static_cast<ExportSubject>(chosenIn(*subject_));
  request.format = ExportFormat::Pdf;
  request.view = static_cast<ExportView>(chosenIn(*view_));
  request.lineStyle = static_cast<LineStyle>(chosenIn(*lines_));
  request.scale = scale_->value() / 100;
  request.margin = 0;
  request.isLinesOnly = linesOnly_->isChecked();
  request.isAsFolded = request.subject == ExportSubject::Sheet && asFolded_->isChecked();
  return request;
}

void PrintDialog::askPicture() {
  auto picture = std::make_shared<std::shared_ptr<const Scene>>();
  Task task;
  task.work = [source = source_, request = request(), picture](const Progress& progress) {
    Result<Scene> scene = sceneOf(source, request, progress);
    if (scene.isOk()) *picture = std::make_shared<const Scene>(std::move(*scene));
  };
  task.done = [this, picture] {
    scene_ = *picture;
    showPages();
    sayPages();
    emit pictureReady();
  };
  pictures_.ask(std::move(task));
}

void PrintDialog::setUpPage() {
  const auto paper = static_cast<QPageSize::PageSizeId>(chosenIn(*size_));
  const auto orientation = static_cast<QPageLayout::Orientation>(chosenIn(*orientation_));
  settings_.setValue("print/paper", static_cast<int>(paper));
  printer_->setPageLayout(QPageLayout(
      QPageSize(paper), orientation,
      QMarginsF(kPaperMargin, kPaperMargin, kPaperMargin, kPaperMargin), QPageLayout::Millimeter));
  showPages();
  sayPages();
}

void PrintDialog::showPages() {
  preview_->updatePreview();
  const std::optional<PageTiles> now = tiles();
  const bool isOne = !now || now->count() == 1;
  preview_->setViewMode(isOne ? QPrintPreviewWidget::SinglePageView
                              : QPrintPreviewWidget::AllPagesView);
  preview_->fitInView();
}

// The preview finds its scale by its size, which it has only now.
void PrintDialog::showEvent(QShowEvent* event) {
  QDialog::showEvent(event);
  QTimer::singleShot(0, this, &PrintDialog::showPages);
}

PageTiles PrintDialog::tilesOn(const QPrinter& printer) const {
  return tilesFor({scene_->width, scene_->height},
                  printer.pageLayout().paintRect(QPageLayout::Millimeter).size(),
                  overlap_->value());
}

std::optional<PageTiles> PrintDialog::tiles() const {
  if (!scene_) return std::nullopt;
  return tilesOn(*printer_);
}

void PrintDialog::sayPages() {
  const std::optional<PageTiles> now = tiles();
  if (!now) return;
  const QString size =
      tr("%1 × %2 mm").arg(now->picture.width(), 0, 'f', 1).arg(now->picture.height(), 0, 'f', 1);
  facts_->setText(now->count() == 1 ? tr("%1, on one page").arg(size)
                                    : tr("%1, on %2 × %3 pages to be glued together")
                                          .arg(size)
                                          .arg(now->columns)
                                          .arg(now->rows));
}

void PrintDialog::paintPages(QPrinter* printer) {
  if (!scene_) return;
  QPainter painter;
  if (!painter.begin(printer)) return;
  constexpr double kInch = 25.4;
  const double dotsPerMm = printer->resolution() / kInch;
  const PageTiles pages = tilesOn(*printer);
  for (int row = 0; row < pages.rows; ++row) {
    for (int column = 0; column < pages.columns; ++column) {
      if (row + column > 0) printer->newPage();
      painter.save();
      painter.scale(dotsPerMm, dotsPerMm);
      paintTile(painter, *scene_, pages, column, row);
      painter.restore();
    }
  }
}

void PrintDialog::print() {
  QPrintDialog dialog(printer_.get(), this);
  if (dialog.exec() != QDialog::Accepted) return;
  paintPages(printer_.get());
  accept();
}

void PrintDialog::chooseAndPrintToPdf() {
  const QString name = source_.title.isEmpty() ? tr("model") : source_.title;
  const QString path = QFileDialog::getSaveFileName(
      this, tr("Save pages as PDF"), QDir(settings_.folderFor("picture")).filePath(name + ".pdf"),
      tr("PDF files (*.pdf)"));
  if (path.isEmpty()) return;
  settings_.setFolderFor("picture", QFileInfo(path).absolutePath());
  if (printToPdf(path)) {
    accept();
  } else {
    QMessageBox::warning(this, tr("Print"), tr("%1 cannot be written.").arg(path));
  }
}

bool PrintDialog::printToPdf(const QString& path) {
  if (!scene_) return false;
  QPrinter pdf(QPrinter::HighResolution);
  pdf.setOutputFormat(QPrinter::PdfFormat);
  pdf.setPageLayout(printer_->pageLayout());
  pdf.setDocName(source_.title);
  pdf.setOutputFileName(path);
  paintPages(&pdf);
  return QFileInfo(path).size() > 0;
}

}  // namespace kiri::desktop
