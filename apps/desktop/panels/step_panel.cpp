// The numbers and choices of the step that is shown, to be changed.
// SPDX-License-Identifier: MIT
#include "apps/desktop/panels/step_panel.h"

#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include "apps/desktop/look/convert.h"
#include "editor/document/step_fields.h"

namespace kiri::desktop {

StepPanel::StepPanel(SessionHub& hub, QWidget* parent)
    : QScrollArea(parent),
      hub_(hub),
      title_(new QLabel(this)),
      summary_(new QLabel(this)),
      problem_(new QLabel(this)),
      empty_(new QLabel(tr("The untouched sheet. Fold, cut or tear it; each step can be changed "
                           "here later."),
                        this)),
      editor_(new FieldEditor(FieldEditor::Layout::Form, this)),
      remove_(new QPushButton(tr("Remove this step"), this)) {
  setWidgetResizable(true);
  setFrameShape(QFrame::NoFrame);
  setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  setAccessibleName(tr("Step"));
  QFont bold = title_->font();
  bold.setWeight(QFont::DemiBold);
  title_->setFont(bold);
  for (QLabel* label : {title_, summary_, problem_, empty_}) label->setWordWrap(true);
  problem_->setProperty("fault", true);
  empty_->setProperty("faint", true);
  summary_->setProperty("faint", true);
  auto* inside = new QWidget(this);
  auto* column = new QVBoxLayout(inside);
  column->setContentsMargins(12, 10, 12, 12);
  column->setSpacing(10);
  column->addWidget(title_);
  column->addWidget(summary_);
  column->addWidget(problem_);
  column->addWidget(empty_);
  column->addWidget(editor_);
  column->addWidget(remove_, 0, Qt::AlignLeft);
  column->addStretch(1);
  setWidget(inside);
  connect(editor_, &FieldEditor::edited, this,
          [this](const QString& id, const FieldValue& value) { edit(id.toStdString(), value); });
  connect(remove_, &QPushButton::clicked, this, [this] {
    if (const std::optional<std::size_t> step = chosen()) {
      emit removeWanted(static_cast<int>(*step));
    }
  });
  connect(&hub, &SessionHub::documentChanged, this, &StepPanel::refresh);
  refresh();
}

void StepPanel::showStep(std::size_t index) {
  wanted_ = index;
  refresh();
  editor_->focusFirst();
}

std::optional<std::size_t> StepPanel::chosen() const {
  const Document& document = hub_.session().document();
  if (wanted_ && *wanted_ < document.model().steps.size()) return wanted_;
  if (document.cursor() == 0) return std::nullopt;
  return document.cursor() - 1;
}

void StepPanel::refresh() {
  const Document& document = hub_.session().document();
  if (document.cursor() != cursor_) wanted_.reset();
  cursor_ = document.cursor();
  const std::optional<std::size_t> index = chosen();
  empty_->setVisible(!index);
  title_->setVisible(index.has_value());
  summary_->setVisible(false);
  editor_->setVisible(index.has_value());
  remove_->setVisible(index.has_value());
  problem_->setVisible(false);
  if (!index) return;
  const Step& step = document.model().steps[*index];
  const QString summary = said(summaryOf(step, *index + 1));
  title_->setText(step.title.empty() ? summary : toQt(step.title));
  summary_->setText(summary);
  summary_->setVisible(!step.title.empty());
  if (const std::optional<Error> problem = document.problemOf(*index)) {
    problem_->setText(tr("This step does not apply: %1").arg(toQt(problem->message)));
    problem_->setVisible(true);
  }
  editor_->show(fieldsOf(step));
}

void StepPanel::edit(const std::string& id, const FieldValue& value) {
  const std::optional<std::size_t> index = chosen();
  if (!index) return;
  const Step& step = hub_.session().document().model().steps[*index];
  const Result<Step> changed = withField(step, id, value);
  if (!changed) {
    problem_->setText(toQt(changed.error().message));
    problem_->setVisible(true);
    return;
  }
  hub_.session().change(editStep(*index, *changed),
                        Phrase{QT_TRANSLATE_NOOP("editor/session", "change of step %1"),
                               {std::to_string(*index + 1)}});
}

}  // namespace kiri::desktop
