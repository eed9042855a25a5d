// The card of the tour: what to do now, and the ghost of the hand that shows it.
// SPDX-License-Identifier: MIT
#include "apps/desktop/dialogs/tour_card.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QVBoxLayout>
#include <algorithm>

#include "apps/desktop/dialogs/form.h"
#include "apps/desktop/look/convert.h"
#include "apps/desktop/look/theme.h"

namespace kiri::desktop {

namespace {

constexpr int kWidth = 340;
constexpr int kMargin = 16;

}  // namespace

TourCard::TourCard(SessionHub& hub, QWidget* parent) : QFrame(parent), hub_(hub) {
  setObjectName("tourCard");
  setAutoFillBackground(true);
  setFrameShape(QFrame::StyledPanel);
  number_ = remark({});
  title_ = headline({});
  title_->setWordWrap(true);
  text_ = new QLabel;
  text_->setWordWrap(true);
  bar_ = new QProgressBar;
  bar_->setRange(0, static_cast<int>(Tour::kSteps));
  bar_->setTextVisible(false);
  bar_->setFixedHeight(6);
  close_ = new QPushButton;
  auto* foot = new QHBoxLayout;
  foot->addWidget(bar_, 1);
  foot->addWidget(close_);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(16, 14, 16, 14);
  layout->addWidget(number_);
  layout->addWidget(title_);
  layout->addWidget(text_);
  layout->addLayout(foot);
  setFixedWidth(kWidth);
  hide();
  constexpr int kFrame = 40;  // ms
  timer_.setInterval(kFrame);
  connect(&timer_, &QTimer::timeout, this, &TourCard::moveHand);
  connect(close_, &QPushButton::clicked, this, &TourCard::end);
  connect(&hub_, &SessionHub::documentChanged, this, &TourCard::look);
  connect(&hub_, &SessionHub::viewChanged, this, &TourCard::look);
  parent->installEventFilter(this);
}

TourCard::~TourCard() = default;

void TourCard::begin() {
  tour_ = Tour();
  isOn_ = true;
  if (const std::optional<ToolId> tool = tour_.tool()) hub_.session().setTool(*tool);
  clock_.start();
  timer_.start();
  look();
  say();
  show();
  raise();
}

void TourCard::end() {
  if (!isOn_) return;
  isOn_ = false;
  timer_.stop();
  hub_.session().setGuide({});
  hide();
  emit ended();
}

void TourCard::look() {
  if (!isOn_) return;
  const std::size_t before = tour_.step();
  const Session& session = hub_.session();
  if (!tour_.look(session.document(), hub_.session().camera().map().frame)) return;
  if (tour_.step() != before) {
    if (const std::optional<ToolId> tool = tour_.tool()) hub_.session().setTool(*tool);
  }
  clock_.restart();
  say();
}

void TourCard::say() {
  const bool isDone = tour_.isFinished();
  number_->setText(isDone ? tr("Done")
                          : tr("Step %1 of %2").arg(tour_.step() + 1).arg(Tour::kSteps));
  title_->setText(said(tour_.title()));
  text_->setText(said(tour_.text()));
  text_->setStyleSheet(tour_.isAstray() ? QString("color: %1;").arg(theme().warning.name())
                                        : QString());
  bar_->setValue(static_cast<int>(tour_.step()));
  close_->setText(isDone ? tr("Close") : tr("End the tour"));
  place();
}

void TourCard::moveHand() {
  constexpr double kWay = 1600;    // ms that the hand is on its way
  constexpr double kRound = 2600;  // with a rest at the end
  const double time = static_cast<double>(clock_.elapsed());
  const double round = time - kRound * static_cast<double>(static_cast<int>(time / kRound));
  // While the person does something the ghost is out of the way.
  const bool isWorking = hub_.session().canCommit() || hub_.session().isBusy();
  hub_.session().setGuide(isWorking ? Marks() : tour_.ghost(std::min(1.0, round / kWay)));
}

void TourCard::place() {
  adjustSize();
  const int height = heightForWidth(kWidth) > 0 ? heightForWidth(kWidth) : sizeHint().height();
  resize(kWidth, height);
  const QSize all = parentWidget()->size();
  move(std::max(kMargin, all.width() - kWidth - kMargin),
       std::max(kMargin, all.height() - height - kMargin));
}

bool TourCard::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::Resize && watched == parent()) place();
  return QFrame::eventFilter(watched, event);
}

void TourCard::changeEvent(QEvent* event) {
  QFrame::changeEvent(event);
  if (event->type() == QEvent::PaletteChange && isOn_) say();
}

}  // namespace kiri::desktop
