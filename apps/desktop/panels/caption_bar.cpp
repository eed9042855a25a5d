// Below the panes: what is done in the step that is shown, as a folding guide tells it.
// SPDX-License-Identifier: MIT
#include "apps/desktop/panels/caption_bar.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QScrollBar>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>

#include "apps/desktop/look/convert.h"
#include "apps/desktop/look/icons.h"
#include "editor/session/caption.h"

namespace kiri::desktop {
namespace {

constexpr int kMostLines = 4;  // of notes; more are scrolled

QToolButton* arrow(const QString& name, const QString& help, QWidget* parent) {
  auto* button = new QToolButton(parent);
  button->setIcon(icon(name));
  button->setIconSize({18, 18});
  button->setToolTip(help);
  button->setAccessibleName(help);
  button->setFocusPolicy(Qt::TabFocus);
  return button;
}

}  // namespace

CaptionBar::CaptionBar(SessionHub& hub, QWidget* parent)
    : QFrame(parent),
      hub_(hub),
      back_(arrow("previous", tr("Previous step"), this)),
      forward_(arrow("next", tr("Next step"), this)),
      title_(new QLabel(this)),
      place_(new QLabel(this)),
      notes_(new QLabel(this)),
      room_(new QScrollArea(this)),
      words_(new QVBoxLayout),
      start_(new QPushButton(tr("Step by step"), this)) {
  setObjectName("caption");
  setAccessibleName(tr("About this step"));
  QFont bold = title_->font();
  bold.setWeight(QFont::DemiBold);
  title_->setFont(bold);
  title_->setTextFormat(Qt::PlainText);
  title_->setMinimumWidth(40);
  title_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
  place_->setProperty("faint", true);
  notes_->setTextFormat(Qt::PlainText);
  notes_->setWordWrap(true);
  notes_->setAlignment(Qt::AlignLeft | Qt::AlignTop);
  notes_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  room_->setWidget(notes_);
  room_->setWidgetResizable(true);
  room_->setFrameShape(QFrame::NoFrame);
  room_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  room_->setFocusPolicy(Qt::NoFocus);
  room_->viewport()->setAutoFillBackground(false);
  notes_->setAutoFillBackground(false);
  start_->setToolTip(tr("Begin with the sheet and go through the steps one by one"));
  auto* head = new QHBoxLayout;
  head->setSpacing(12);
  head->addWidget(title_, 1);
  head->addWidget(place_);
  words_->setSpacing(3);
  words_->addLayout(head);
  words_->addWidget(room_, 1);
  auto* line = new QHBoxLayout(this);
  line->setContentsMargins(10, 7, 12, 8);
  line->setSpacing(4);
  line->addWidget(back_, 0, Qt::AlignTop);
  line->addWidget(forward_, 0, Qt::AlignTop);
  line->addSpacing(8);
  line->addLayout(words_, 1);
  line->addSpacing(8);
  line->addWidget(start_, 0, Qt::AlignVCenter);
  connect(back_, &QToolButton::clicked, this, [this] { emit stepWanted(-1); });
  connect(forward_, &QToolButton::clicked, this, [this] { emit stepWanted(1); });
  connect(start_, &QPushButton::clicked, this, &CaptionBar::startWanted);
  connect(&hub, &SessionHub::changed, this, [this](const Changed& what) {
    if (what.document || what.shown) refresh();
  });
  refresh();
}

QString CaptionBar::title() const { return title_->text(); }
QString CaptionBar::notes() const { return notes_->text(); }
QString CaptionBar::place() const { return place_->text(); }

void CaptionBar::setWanted(bool isWanted) {
  isWanted_ = isWanted;
  refresh();
}

void CaptionBar::introduce() {
  introduces_ = true;
  opened_ = hub_.session().document().cursor();
  refresh();
}

void CaptionBar::refresh() {
  Session& session = hub_.session();
  const Model& model = session.document().model();
  const bool isFilm = session.isPlayerOpen();
  const std::size_t seen = stepLookedAt(session);
  if (isFilm || seen != opened_) introduces_ = false;
  const bool isThere = isWanted_ && isTold(model);
  setVisible(isThere);
  if (!isThere) return;
  const bool isIntroduction = introduces_ && !model.notes.empty();
  const Caption caption = captionOf(model, isIntroduction ? 0 : seen);
  const QString title = toQt(caption.title);
  title_->setText(title.isEmpty() ? said(caption.summary) : title);
  title_->setToolTip(title_->text());
  const QString notes = toQt(caption.notes);
  if (notes_->text() != notes) {
    notes_->setText(notes);
    room_->verticalScrollBar()->setValue(0);
  }
  place_->setText(caption.step == 0
                      ? (caption.steps == 1 ? tr("1 step") : tr("%1 steps").arg(caption.steps))
                      : tr("step %1 of %2").arg(caption.step).arg(caption.steps));
  back_->setEnabled(seen > 0);
  forward_->setEnabled(seen < caption.steps);
  start_->setVisible(isIntroduction && seen > 0);
  fit();
}

int CaptionBar::heightFor(const QString& notes) const {
  if (notes.isEmpty()) return 0;
  return notes_->fontMetrics()
      .boundingRect(QRect(0, 0, std::max(1, room_->viewport()->width()), 10000),
                    Qt::TextWordWrap | Qt::AlignLeft, notes)
      .height();
}

/// As high as the longest of the model's notes needs, so that the panes stay as they are from step
/// to step.
void CaptionBar::fit() {
  const Model& model = hub_.session().document().model();
  const int line = notes_->fontMetrics().lineSpacing();
  int height = heightFor(toQt(model.notes));
  for (const Step& step : model.steps) height = std::max(height, heightFor(toQt(step.notes)));
  const int most = kMostLines * line;
  const int spare = height > 0 ? 2 : 0;
  // Whole lines where there are more, so that nothing of the next one shows.
  const int left = height > most ? spare : 0;
  room_->setFixedHeight(std::min(height, most) + spare - left);
  words_->setContentsMargins(0, 0, 0, left);
}

void CaptionBar::resizeEvent(QResizeEvent* event) {
  QFrame::resizeEvent(event);
  fit();
}

}  // namespace kiri::desktop
