// How far work beside the window is.
// SPDX-License-Identifier: MIT
#include "apps/desktop/dialogs/work_bar.h"

#include <QPointer>
#include <QVBoxLayout>
#include <atomic>
#include <utility>

#include "apps/desktop/look/theme.h"
#include "core/base/check.h"

namespace kiri::desktop {

struct WorkBar::State {
  std::atomic<double> done = 0;
  std::atomic<bool> isStopped = false;
};

WorkBar::WorkBar(TaskRunner& runner, QWidget* parent)
    : QWidget(parent), runner_(runner), label_(new QLabel(this)), bar_(new QProgressBar(this)) {
  constexpr int kParts = 1000;
  constexpr int kLooks = 50;
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(bar_);
  layout->addWidget(label_);
  label_->setWordWrap(true);
  label_->setTextInteractionFlags(Qt::TextBrowserInteraction);
  label_->setOpenExternalLinks(true);
  label_->hide();
  bar_->setRange(0, kParts);
  bar_->setTextVisible(false);
  bar_->setFixedHeight(6);
  QSizePolicy policy = bar_->sizePolicy();
  policy.setRetainSizeWhenHidden(true);
  bar_->setSizePolicy(policy);
  bar_->hide();
  timer_.setInterval(kLooks);
  connect(&timer_, &QTimer::timeout, this, [this] {
    if (state_) bar_->setValue(static_cast<int>(state_->done * kParts));
  });
}

WorkBar::~WorkBar() { stop(); }

void WorkBar::start(const QString& what, std::function<void(const Progress&)> work,
                    std::function<void()> done) {
  KIRI_CHECK(!isBusy(), "one piece of work at a time");
  say(what);
  bar_->setValue(0);
  bar_->show();
  timer_.start();
  state_ = std::make_shared<State>();
  Task task;
  task.work = [state = state_, body = std::move(work)](const Progress& progress) {
    body([&](double part) {
      state->done = part;
      return !state->isStopped && goesOn(progress, part);
    });
  };
  task.done = [bar = QPointer<WorkBar>(this), report = std::move(done)] {
    if (!bar) return;
    bar->state_.reset();
    bar->timer_.stop();
    bar->bar_->hide();
    emit bar->busyChanged(false);
    report();
  };
  emit busyChanged(true);
  runner_.start(std::move(task));
}

void WorkBar::stop() {
  if (state_) state_->isStopped = true;
}

void WorkBar::say(const QString& sentence, bool isFault) {
  label_->setText(sentence);
  label_->setVisible(!sentence.isEmpty());
  label_->setProperty("fault", isFault);
  label_->setStyleSheet(isFault ? QString("color: %1;").arg(theme().fault.name()) : QString());
}

}  // namespace kiri::desktop
