// More of the model that a person points at, beside the cards.
// SPDX-License-Identifier: MIT
#include "apps/desktop/dialogs/model_preview.h"

#include <QFileInfo>
#include <QHBoxLayout>
#include <QPixmap>
#include <QScrollArea>
#include <QVBoxLayout>
#include <memory>

#include "apps/desktop/dialogs/form.h"

namespace kiri::desktop {

namespace {

constexpr int kPreviewWidth = 300;
constexpr int kPreviewMargin = 20;
constexpr int kPreviewPicture = 220;
constexpr int kMoment = 82;
constexpr int kMomentSpacing = 6;
constexpr int kRest = 120;  // ms that the pointer rests before pictures are made
constexpr int kMostMoments = 3;

void setPicture(QLabel& label, QImage picture, double ratio) {
  if (picture.isNull()) return label.clear();
  picture.setDevicePixelRatio(ratio);
  label.setPixmap(QPixmap::fromImage(picture));
}

/// The picture of a card, larger than it was made, until there is a better one.
QImage fitted(const QImage& picture, int pixels) {
  if (picture.isNull()) return picture;
  return picture.scaled(pixels, pixels, Qt::KeepAspectRatio, Qt::SmoothTransformation);
}

QString nameOf(ModelMoment::Kind kind) {
  switch (kind) {
    case ModelMoment::Kind::Folded:
      return ModelPreview::tr("folded");
    case ModelMoment::Kind::HalfUnfolded:
      return ModelPreview::tr("half unfolded");
    case ModelMoment::Kind::HalfFolded:
      return ModelPreview::tr("half folded");
    case ModelMoment::Kind::Unfolded:
      return ModelPreview::tr("unfolded");
  }
  return {};
}

}  // namespace

ModelPreview::ModelPreview(ModelCards& cards, TaskRunner& runner, QWidget* parent)
    : QFrame(parent),
      cards_(cards),
      task_(runner),
      hint_(remark(tr("Point at a model to see more of it."))),
      inside_(new QWidget),
      picture_(new QLabel),
      title_(headline({})),
      facts_(remark({})),
      notes_(new QLabel),
      open_(new QPushButton(tr("Open"))) {
  setObjectName("preview");
  setAccessibleName(tr("More about the model"));
  setFixedWidth(kPreviewWidth);
  picture_->setFixedHeight(kPreviewPicture);
  picture_->setAlignment(Qt::AlignCenter);
  title_->setWordWrap(true);
  title_->setTextFormat(Qt::PlainText);
  notes_->setWordWrap(true);
  notes_->setTextFormat(Qt::PlainText);
  notes_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  notes_->setAlignment(Qt::AlignTop | Qt::AlignLeft);
  auto* column = new QVBoxLayout(inside_);
  column->setContentsMargins(kPreviewMargin, kPreviewMargin, kPreviewMargin, kPreviewMargin);
  column->setSpacing(8);
  column->addWidget(picture_);
  column->addWidget(title_);
  column->addWidget(facts_);
  column->addWidget(notes_);
  column->addSpacing(6);
  column->addWidget(makeMoments());
  column->addSpacing(6);
  column->addWidget(open_, 0, Qt::AlignLeft);
  column->addStretch();
  auto* area = new QScrollArea;
  area->setWidget(inside_);
  area->setWidgetResizable(true);
  area->setFrameShape(QFrame::NoFrame);
  area->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  area->setFocusPolicy(Qt::NoFocus);
  hint_->setAlignment(Qt::AlignCenter);
  hint_->setContentsMargins(kPreviewMargin, kPreviewMargin, kPreviewMargin, kPreviewMargin);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(hint_);
  layout->addWidget(area);
  area->hide();
  rest_.setSingleShot(true);
  rest_.setInterval(kRest);
  connect(&rest_, &QTimer::timeout, this, &ModelPreview::ask);
  connect(open_, &QPushButton::clicked, this, [this] { emit chosen(path_); });
  connect(&cards, &ModelCards::changed, this, [this](const QString& path) {
    if (path == path_) say();
  });
}

QWidget* ModelPreview::makeMoments() {
  auto* part = new QWidget;
  auto* row = new QHBoxLayout(part);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(kMomentSpacing);
  for (int i = 0; i < kMostMoments; ++i) {
    Moment moment{new QLabel, remark({})};
    moment.picture->setFixedSize(kMoment, kMoment);
    moment.picture->setAlignment(Qt::AlignCenter);
    moment.name->setAlignment(Qt::AlignHCenter | Qt::AlignTop);
    moment.name->setFixedWidth(kMoment);
    auto* column = new QVBoxLayout;
    column->setSpacing(2);
    column->addWidget(moment.picture);
    column->addWidget(moment.name);
    row->addLayout(column);
    moments_.append(moment);
  }
  row->addStretch();
  return part;
}

void ModelPreview::show(const QString& path) {
  if (path == path_) return;
  path_ = path;
  whole_ = {};
  hint_->hide();
  inside_->parentWidget()->parentWidget()->show();
  say();
  showMoments({});
  if (isVisible()) rest_.start();
}

void ModelPreview::say() {
  const ModelCard card = cards_.card(path_);
  const double ratio = devicePixelRatioF();
  const QImage whole =
      whole_.isNull() ? fitted(card.picture, static_cast<int>(kPreviewPicture * ratio)) : whole_;
  setPicture(*picture_, whole, ratio);
  title_->setText(card.title);
  QStringList facts;
  if (!card.figure.isEmpty()) facts << card.figure;
  if (card.steps > 0) facts << (card.steps == 1 ? tr("1 step") : tr("%1 steps").arg(card.steps));
  facts_->setText(facts.isEmpty() ? path_ : facts.join("  ·  "));
  notes_->setText(card.notes);
  notes_->setVisible(!card.notes.isEmpty());
}

void ModelPreview::ask() {
  struct Made {
    QImage whole;
    QList<ModelMoment> moments;
  };
  auto made = std::make_shared<Made>();
  task_.ask({{},
             [path = path_, ratio = devicePixelRatioF(), made](const Progress& progress) {
               made->whole = drawCard(path, static_cast<int>(kPreviewPicture * ratio), progress);
               made->moments = momentsIn(path, static_cast<int>(kMoment * ratio), ratio, progress);
             },
             [this, path = path_, made] {
               if (path != path_) return;
               whole_ = made->whole;
               say();
               showMoments(made->moments);
             }});
}

void ModelPreview::showMoments(const QList<ModelMoment>& moments) {
  for (qsizetype i = 0; i < moments_.size(); ++i) {
    const bool isThere = i < moments.size();
    setPicture(*moments_[i].picture, isThere ? moments[i].picture : QImage(), devicePixelRatioF());
    moments_[i].name->setText(isThere ? nameOf(moments[i].kind) : QString());
  }
}

int ModelPreview::pictureCount() const {
  int count = 0;
  for (const Moment& moment : moments_) count += moment.picture->pixmap().isNull() ? 0 : 1;
  return count;
}

}  // namespace kiri::desktop
