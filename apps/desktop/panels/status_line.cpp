// The foot of the window: what to do next, what just happened, what lies there.
// SPDX-License-Identifier: MIT
#include "apps/desktop/panels/status_line.h"

#include <QEvent>
#include <QLabel>
#include <QProgressBar>
#include <QStyle>
#include <QToolButton>
#include <cmath>

#include "apps/desktop/look/convert.h"
#include "apps/desktop/look/icons.h"
#include "apps/desktop/look/theme.h"

namespace kiri::desktop {
namespace {

constexpr int kSign = 16;
constexpr int kNoticeTime = 6000;  // ms that something done is told; refusals stay longer
constexpr int kRefusalTime = 15000;

}  // namespace

StatusLine::StatusLine(SessionHub& hub, PoolRunner* runner, QWidget* parent)
    : QStatusBar(parent),
      hub_(hub),
      runner_(runner),
      sign_(new QLabel(this)),
      hint_(new QLabel(this)),
      facts_(new QLabel(this)),
      what_(new QLabel(this)),
      progress_(new QProgressBar(this)),
      cancel_(new QToolButton(this)) {
  setSizeGripEnabled(false);
  setContentsMargins(8, 0, 8, 0);
  hint_->setObjectName("hint");
  hint_->installEventFilter(this);
  hint_->setMinimumWidth(80);
  hint_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
  facts_->setObjectName("facts");
  facts_->setProperty("faint", true);
  progress_->setFixedWidth(140);
  progress_->setRange(0, 1000);
  progress_->setTextVisible(false);
  progress_->setMaximumHeight(8);
  cancel_->setIcon(icon("cancel"));
  cancel_->setIconSize({14, 14});
  cancel_->setToolTip(tr("Stop this work"));
  cancel_->setAccessibleName(cancel_->toolTip());
  addWidget(sign_);
  addWidget(hint_, 1);
  for (QWidget* widget : {static_cast<QWidget*>(what_), static_cast<QWidget*>(progress_),
                          static_cast<QWidget*>(cancel_), static_cast<QWidget*>(facts_)}) {
    addPermanentWidget(widget);
  }
  fade_.setSingleShot(true);
  connect(&fade_, &QTimer::timeout, this, [this] {
    isNoticeShown_ = false;
    refresh();
  });
  connect(cancel_, &QToolButton::clicked, this, [this] {
    if (runner_ && runner_->busy()) runner_->cancel(runner_->busy()->task);
  });
  connect(&hub, &SessionHub::changed, this, &StatusLine::refresh);
  if (runner_) connect(runner_, &PoolRunner::busyChanged, this, &StatusLine::refreshBusy);
  refresh();
  refreshBusy();
}

QString StatusLine::hint() const { return said_; }
QString StatusLine::facts() const { return facts_->text(); }

void StatusLine::say(Notice::Kind kind, const QString& text) {
  const bool isRefusal = kind == Notice::Kind::Refused;
  const bool isWarning = kind == Notice::Kind::Warning;
  const QString name = isRefusal ? "error" : isWarning ? "warning" : "";
  sign_->setVisible(!name.isEmpty());
  if (!name.isEmpty()) {
    sign_->setPixmap(icon(name).pixmap(QSize(kSign, kSign), devicePixelRatioF()));
  }
  said_ = text;
  fit();
  hint_->setToolTip(text);
  hint_->setProperty("fault", isRefusal);
  hint_->setProperty("warning", isWarning);
  hint_->style()->polish(hint_);
  isNoticeShown_ = kind != Notice::Kind::None;
  if (isNoticeShown_) fade_.start(isRefusal || isWarning ? kRefusalTime : kNoticeTime);
}

void StatusLine::fit() {
  hint_->setText(hint_->fontMetrics().elidedText(said_, Qt::ElideRight, hint_->width()));
}

bool StatusLine::eventFilter(QObject* watched, QEvent* event) {
  if (watched == hint_ && event->type() == QEvent::Resize) fit();
  return QStatusBar::eventFilter(watched, event);
}

void StatusLine::refresh() {
  showFacts();
  const Notice& notice = hub_.session().notice();
  const bool isNew = notice.text != lastNotice_ || notice.why != lastWhy_;
  lastNotice_ = notice.text;
  lastWhy_ = notice.why;
  if (isNew && notice.kind != Notice::Kind::None) {
    QString text = said(notice.text);
    if (!notice.why.empty()) text += (text.isEmpty() ? "" : ": ") + toQt(notice.why);
    say(notice.kind, text);
    return;
  }
  if (isNew) isNoticeShown_ = false;
  if (isNoticeShown_) return;
  say(Notice::Kind::None, elsewhere_.isEmpty() ? said(hub_.session().hint()) : elsewhere_);
}

void StatusLine::setElsewhere(const QString& hint) {
  elsewhere_ = hint;
  refresh();
}

void StatusLine::showFacts() {
  const Facts& facts = hub_.session().facts();
  // Not Qt's plural forms: they need a translation file for English too.
  const auto counted = [](std::size_t count, const QString& one, const QString& many) {
    return count == 1 ? one : many.arg(count);
  };
  QString text = counted(facts.facets, tr("1 facet"), tr("%1 facets"));
  if (facts.layers > 0) {
    text += "  ·  " + counted(facts.layers, tr("1 layer"), tr("%1 layers"));
  }
  text += "  ·  " + (facts.collisions == 0
                         ? tr("free")
                         : counted(facts.collisions, tr("1 collision"), tr("%1 collisions")));
  if (!elsewhere_.isEmpty()) text.clear();
  if (facts_->text() != text) facts_->setText(text);
}

void StatusLine::refreshBusy() {
  const bool isBusy = runner_ && runner_->busy();
  for (QWidget* widget : {static_cast<QWidget*>(what_), static_cast<QWidget*>(progress_),
                          static_cast<QWidget*>(cancel_)}) {
    widget->setVisible(isBusy);
  }
  if (!isBusy) return;
  what_->setText(said(runner_->busy()->what));
  progress_->setValue(static_cast<int>(std::lround(runner_->busy()->done * 1000)));
}

}  // namespace kiri::desktop
