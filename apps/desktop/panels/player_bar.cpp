// Play, pause, scrub: the whole process in time.
// SPDX-License-Identifier: MIT
#include "apps/desktop/panels/player_bar.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QScopedValueRollback>
#include <QSlider>
#include <QToolButton>
#include <algorithm>
#include <cmath>
#include <iterator>

#include "apps/desktop/look/icons.h"

namespace kiri::desktop {
namespace {

constexpr int kFrame = 16;          // ms: 60 pictures a second
constexpr double kFilmTicks = 100;  // of the slider for a second
constexpr double kSpeeds[] = {0.25, 0.5, 1, 2, 4};
constexpr int kNormalSpeed = 2;  // index

double speedAt(int index) {
  return kSpeeds[std::clamp(index, 0, static_cast<int>(std::size(kSpeeds)) - 1)];
}

QToolButton* button(const QString& name, const QString& help, QWidget* parent) {
  auto* made = new QToolButton(parent);
  made->setIcon(icon(name));
  made->setIconSize({20, 20});
  made->setToolTip(help);
  made->setAccessibleName(help);
  return made;
}

}  // namespace

PlayerBar::PlayerBar(SessionHub& hub, QWidget* parent)
    : QFrame(parent),
      hub_(hub),
      play_(button("play", tr("Play or pause"), this)),
      loop_(button("loop", tr("Begin again at the end"), this)),
      close_(button("cancel", tr("Leave the film"), this)),
      slider_(new QSlider(Qt::Horizontal, this)),
      speed_(new QComboBox(this)),
      place_(new QLabel(this)) {
  setObjectName("player");
  auto* back = button("skip-back", tr("To the start of the step before"), this);
  auto* forward = button("skip-forward", tr("To the start of the next step"), this);
  loop_->setCheckable(true);
  for (const double speed : kSpeeds) speed_->addItem(QString::number(speed) + "×");
  speed_->setCurrentIndex(kNormalSpeed);
  speed_->setToolTip(tr("Speed"));
  speed_->setAccessibleName(tr("Speed"));
  slider_->setAccessibleName(tr("Time of the film"));
  slider_->setRange(0, 0);
  place_->setProperty("faint", true);
  place_->setMinimumWidth(90);
  auto* line = new QHBoxLayout(this);
  line->setContentsMargins(10, 2, 10, 2);
  line->setSpacing(4);
  for (QWidget* widget : {static_cast<QWidget*>(back), static_cast<QWidget*>(play_),
                          static_cast<QWidget*>(forward)}) {
    line->addWidget(widget);
  }
  line->addSpacing(6);
  line->addWidget(slider_, 1);
  line->addSpacing(6);
  for (QWidget* widget : {static_cast<QWidget*>(place_), static_cast<QWidget*>(speed_),
                          static_cast<QWidget*>(loop_), static_cast<QWidget*>(close_)}) {
    line->addWidget(widget);
  }
  timer_.setInterval(kFrame);
  timer_.setTimerType(Qt::PreciseTimer);
  connect(&timer_, &QTimer::timeout, this, &PlayerBar::tick);
  connect(play_, &QToolButton::clicked, this, &PlayerBar::togglePlay);
  connect(back, &QToolButton::clicked, this, [this] { skip(-1); });
  connect(forward, &QToolButton::clicked, this, [this] { skip(1); });
  connect(close_, &QToolButton::clicked, this, &PlayerBar::stop);
  connect(loop_, &QToolButton::toggled, this, &PlayerBar::setLoops);
  connect(speed_, &QComboBox::currentIndexChanged, this,
          [this](int index) { hub_.session().player().setSpeed(speedAt(index)); });
  connect(slider_, &QSlider::valueChanged, this, &PlayerBar::scrub);
  connect(&hub, &SessionHub::changed, this, &PlayerBar::refresh);
  refresh();
}

bool PlayerBar::isPlaying() const { return hub_.session().player().isPlaying(); }

void PlayerBar::togglePlay() {
  Session& session = hub_.session();
  if (session.isPlayerOpen() && session.player().isPlaying()) {
    session.player().pause();
    session.playerMoved();
    refresh();
    return;
  }
  play();
}

void PlayerBar::play() {
  Session& session = hub_.session();
  if (session.isPlayerOpen()) {
    session.player().play();
    session.playerMoved();
  } else {
    session.openPlayer();  // the time line may take a while; it plays as soon as it is there
  }
  refresh();
}

void PlayerBar::whenOpened() {
  Player& player = hub_.session().player();
  player.setSpeed(speedAt(speed_->currentIndex()));
  player.setLoops(loop_->isChecked());
  if (isHeldAtOpening_) player.pause();
  isHeldAtOpening_ = false;
}

void PlayerBar::stop() {
  hub_.session().player().pause();
  hub_.session().closePlayer();
  refresh();
}

void PlayerBar::skip(int steps) {
  Session& session = hub_.session();
  if (!session.isPlayerOpen()) {
    isHeldAtOpening_ = true;
    session.openPlayer();
    return;
  }
  session.player().skip(steps);
  session.playerMoved();
  refresh();
}

void PlayerBar::setLoops(bool loops) {
  hub_.session().player().setLoops(loops);
  loop_->setChecked(loops);
  emit loopsChanged(loops);
}

void PlayerBar::changeSpeed(int by) {
  speed_->setCurrentIndex(std::clamp(speed_->currentIndex() + by, 0, speed_->count() - 1));
}

void PlayerBar::scrub(int ticks) {
  if (isUpdating_) return;
  Session& session = hub_.session();
  if (!session.isPlayerOpen()) return;
  session.player().pause();
  session.player().seek(ticks / kFilmTicks);
  session.playerMoved();
  refresh();
}

void PlayerBar::tick() {
  const double seconds = static_cast<double>(clock_.restart()) / 1000.0;
  hub_.session().advance(seconds);
  refresh();
}

void PlayerBar::refresh() {
  const QScopedValueRollback<bool> updating(isUpdating_, true);
  Session& session = hub_.session();
  const bool isOpen = session.isPlayerOpen();
  Player& player = session.player();
  if (isOpen != wasOpen_) {
    wasOpen_ = isOpen;
    if (isOpen) whenOpened();
  }
  const bool isPlaying = isOpen && player.isPlaying();
  if (isPlaying && !timer_.isActive()) {
    clock_.start();
    timer_.start();
  } else if (!isPlaying) {
    timer_.stop();
  }
  const QString name = isPlaying ? "pause" : "play";
  if (play_->property("shows") != name) {
    play_->setProperty("shows", name);
    play_->setIcon(icon(name));
  }
  close_->setVisible(isOpen);
  slider_->setEnabled(isOpen);
  const std::size_t steps = session.document().model().steps.size();
  play_->setEnabled(steps > 0);
  if (!isOpen) {
    slider_->setRange(0, 0);
    place_->setText({});
    return;
  }
  slider_->setRange(0, static_cast<int>(std::lround(player.duration() * kFilmTicks)));
  slider_->setValue(static_cast<int>(std::lround(player.seconds() * kFilmTicks)));
  place_->setText(tr("step %1 of %2").arg(player.step()).arg(steps));
}

}  // namespace kiri::desktop
