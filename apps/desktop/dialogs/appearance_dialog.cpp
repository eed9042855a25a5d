// The colours and images of the two sides of the paper.
// SPDX-License-Identifier: MIT
#include "apps/desktop/dialogs/appearance_dialog.h"

#include <QColorDialog>
#include <QDialogButtonBox>
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QGridLayout>
#include <QGroupBox>
#include <QHBoxLayout>
#include <QImage>
#include <QPainter>
#include <QPainterPath>
#include <QToolButton>
#include <QVBoxLayout>
#include <iterator>
#include <memory>

#include "apps/desktop/dialogs/form.h"
#include "apps/desktop/look/convert.h"
#include "apps/desktop/services/textures.h"

namespace kiri::desktop {

namespace {

constexpr int kSwatch = 120;

struct Preset {
  const char* name;
  Color front;
  Color back;
};

// Greens measured on leaves (guide to leaves) and papers that are sold.
const Preset kPresets[] = {
    {QT_TRANSLATE_NOOP("kiri::desktop::AppearanceDialog", "Leaf"), {90, 140, 70}, {214, 226, 190}},
    {QT_TRANSLATE_NOOP("kiri::desktop::AppearanceDialog", "Young leaf"),
     {148, 186, 84},
     {222, 234, 188}},
    {QT_TRANSLATE_NOOP("kiri::desktop::AppearanceDialog", "Dark leaf"),
     {44, 92, 54},
     {150, 178, 136}},
    {QT_TRANSLATE_NOOP("kiri::desktop::AppearanceDialog", "Autumn"),
     {204, 102, 40},
     {238, 200, 140}},
    {QT_TRANSLATE_NOOP("kiri::desktop::AppearanceDialog", "White paper"),
     {250, 250, 247},
     {240, 239, 233}},
    {QT_TRANSLATE_NOOP("kiri::desktop::AppearanceDialog", "Origami red"),
     {204, 51, 51},
     {255, 255, 255}},
    {QT_TRANSLATE_NOOP("kiri::desktop::AppearanceDialog", "Origami blue"),
     {51, 102, 178},
     {255, 255, 255}},
    {QT_TRANSLATE_NOOP("kiri::desktop::AppearanceDialog", "Kraft paper"),
     {193, 154, 107},
     {214, 184, 142}},
};

/// Paper of one colour with a corner of the other folded over.
QPixmap swatchOf(const QColor& front, const QColor& back, int pixels, double ratio) {
  QPixmap pixmap(QSize(pixels, pixels) * ratio);
  pixmap.setDevicePixelRatio(ratio);
  pixmap.fill(Qt::transparent);
  QPainter painter(&pixmap);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(QPen(QColor(0, 0, 0, 90), 1));
  const double m = 1.5;
  const double s = pixels - 2 * m;
  const double f = s * 0.55;
  painter.setBrush(front);
  painter.drawPolygon(
      QPolygonF({{m, m}, {m + f, m}, {m + s, m + s - f}, {m + s, m + s}, {m, m + s}}));
  painter.setBrush(back);
  painter.drawPolygon(QPolygonF({{m + f, m}, {m + s, m + s - f}, {m + f, m + s - f}}));
  return pixmap;
}

}  // namespace

AppearanceDialog::AppearanceDialog(const PaperSide& front, const PaperSide& back,
                                   const QString& modelPath, TaskRunner& runner, QWidget* parent)
    : QDialog(parent),
      frontBefore_(front),
      backBefore_(back),
      modelPath_(modelPath),
      frontImage_(runner),
      backImage_(runner) {
  setWindowTitle(tr("Paper and colours"));
  sides_[0].side = front;
  sides_[1].side = back;
  auto* both = new QHBoxLayout;
  both->setSpacing(16);
  both->addWidget(makeSide(true));
  both->addWidget(makeSide(false));
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel);
  connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(20, 20, 20, 16);
  layout->setSpacing(16);
  layout->addWidget(makePresets());
  layout->addLayout(both, 1);
  withoutIcons(*buttons);
  layout->addWidget(buttons);
  show(true);
  show(false);
}

QWidget* AppearanceDialog::makePresets() {
  auto* row = new QWidget;
  auto* layout = new QHBoxLayout(row);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(4);
  constexpr int kSmall = 40;
  for (int i = 0; i < presetCount(); ++i) {
    const Preset& preset = kPresets[i];
    auto* button = new QToolButton;
    button->setAutoRaise(true);
    button->setToolButtonStyle(Qt::ToolButtonTextUnderIcon);
    button->setIconSize({kSmall, kSmall});
    button->setIcon(swatchOf(toQt(preset.front), toQt(preset.back), kSmall, devicePixelRatioF()));
    button->setText(tr(preset.name));
    connect(button, &QToolButton::clicked, this, [this, i] { usePreset(i); });
    layout->addWidget(button);
  }
  layout->addStretch();
  return row;
}

QWidget* AppearanceDialog::makeSide(bool isFront) {
  Side& side = sides_[isFront ? 0 : 1];
  auto* box = new QGroupBox(isFront ? tr("Front") : tr("Back"));
  auto* layout = new QGridLayout(box);
  side.swatch = new QLabel;
  side.swatch->setFixedSize(kSwatch, kSwatch);
  side.color = new QPushButton(tr("Colour…"));
  side.image = new QPushButton(tr("Image…"));
  side.noImage = new QPushButton(tr("No image"));
  side.name = remark({});
  layout->addWidget(side.swatch, 0, 0, 4, 1);
  layout->addWidget(side.color, 0, 1);
  layout->addWidget(side.image, 1, 1);
  layout->addWidget(side.noImage, 2, 1);
  layout->setRowStretch(3, 1);
  layout->addWidget(side.name, 4, 0, 1, 2);
  layout->setHorizontalSpacing(16);
  connect(side.color, &QPushButton::clicked, this, [this, isFront] { chooseColor(isFront); });
  connect(side.image, &QPushButton::clicked, this, [this, isFront] { chooseImage(isFront); });
  connect(side.noImage, &QPushButton::clicked, this, [this, isFront] { setTexture(isFront, {}); });
  return box;
}

void AppearanceDialog::show(bool isFront) {
  Side& side = sides_[isFront ? 0 : 1];
  QPixmap plain(QSize(kSwatch, kSwatch) * devicePixelRatioF());
  plain.fill(toQt(side.side.color));
  plain.setDevicePixelRatio(devicePixelRatioF());
  side.swatch->setPixmap(plain);
  side.noImage->setEnabled(!side.side.texture.empty());
  side.name->setText(QString::fromStdString(side.side.texture));
  LatestTask& task = isFront ? frontImage_ : backImage_;
  task.clear();
  const QString path = texturePathOf(side.side, modelPath_);
  if (path.isEmpty()) return;
  auto read = std::make_shared<Result<Image>>(Error{ErrorCode::Cancelled, "", {}});
  task.ask({{},
            [path, read](const Progress&) { *read = readTexture(path); },
            [this, isFront, read] {
              Side& shown = sides_[isFront ? 0 : 1];
              if (!read->isOk()) {
                shown.name->setText(sentenceOf(read->error().message));
                return;
              }
              const double ratio = devicePixelRatioF();
              QImage picture = toQt(**read).scaled(QSize(kSwatch, kSwatch) * ratio,
                                                   Qt::IgnoreAspectRatio, Qt::SmoothTransformation);
              QImage onPaper(picture.size(), QImage::Format_RGB32);
              onPaper.fill(toQt(shown.side.color));
              QPainter(&onPaper).drawImage(0, 0, picture);
              onPaper.setDevicePixelRatio(ratio);
              shown.swatch->setPixmap(QPixmap::fromImage(onPaper));
            }});
}

bool AppearanceDialog::isChanged() const {
  const auto differ = [](const PaperSide& a, const PaperSide& b) {
    return a.color != b.color || a.texture != b.texture;
  };
  return differ(front(), frontBefore_) || differ(back(), backBefore_);
}

void AppearanceDialog::setColor(bool isFront, Color color) {
  sides_[isFront ? 0 : 1].side.color = color;
  show(isFront);
}

void AppearanceDialog::setTexture(bool isFront, const QString& path) {
  QString name = path;
  if (!modelPath_.isEmpty() && !path.isEmpty()) {
    const QString below = QFileInfo(modelPath_).absoluteDir().relativeFilePath(path);
    if (!below.startsWith("..")) name = below;
  }
  sides_[isFront ? 0 : 1].side.texture = name.toStdString();
  show(isFront);
}

int AppearanceDialog::presetCount() { return static_cast<int>(std::size(kPresets)); }

void AppearanceDialog::usePreset(int index) {
  const Preset& preset = kPresets[index];
  sides_[0].side = {preset.front, ""};
  sides_[1].side = {preset.back, ""};
  show(true);
  show(false);
}

void AppearanceDialog::chooseColor(bool isFront) {
  const QColor chosen = QColorDialog::getColor(toQt(sides_[isFront ? 0 : 1].side.color), this);
  if (chosen.isValid()) setColor(isFront, toColor(chosen));
}

void AppearanceDialog::chooseImage(bool isFront) {
  const QString folder = modelPath_.isEmpty() ? QDir::homePath() : QFileInfo(modelPath_).path();
  const QString path = QFileDialog::getOpenFileName(this, tr("Image of the paper"), folder,
                                                    tr("PNG images (*.png)"));
  if (!path.isEmpty()) setTexture(isFront, path);
}

}  // namespace kiri::desktop
