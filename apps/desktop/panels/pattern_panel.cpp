// The crease pattern of the model: repairs, faults, verdict, and its folded states to walk through.
// SPDX-License-Identifier: MIT
#include "apps/desktop/panels/pattern_panel.h"

#include <QCheckBox>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QListWidget>
#include <QLocale>
#include <QScopedValueRollback>
#include <QToolButton>
#include <QTreeWidget>
#include <QVBoxLayout>
#include <algorithm>

#include "apps/desktop/look/convert.h"
#include "apps/desktop/look/icons.h"

namespace kiri::desktop {
namespace {

constexpr int kVerdictSign = 18;
/// Rows beyond these have no buttons of their own; keys walk their states.
constexpr std::size_t kMostButtons = 200;
constexpr std::size_t kMostRows = 2000;

enum Column { kName, kState, kButtons, kColumns };

QLabel* title(const QString& text, QWidget* parent) {
  auto* label = new QLabel(text, parent);
  label->setProperty("faint", true);
  label->setContentsMargins(0, 8, 0, 0);
  return label;
}

QString counted(std::size_t count, const QString& one, const QString& many) {
  return count == 1 ? one : many.arg(QLocale().toString(static_cast<qulonglong>(count)));
}

}  // namespace

QString grouped(const std::string& decimal) {
  constexpr std::size_t kLongest = 24;
  const QLocale locale;
  const std::size_t digits = decimal.size();
  if (digits > kLongest) {
    const QString lead =
        toQt(decimal.substr(0, 1)) + locale.decimalPoint() + toQt(decimal.substr(1, 3));
    return QString("%1 × 10^%2").arg(lead).arg(digits - 1);
  }
  QString text;
  for (std::size_t i = 0; i < digits; ++i) {
    if (i > 0 && (digits - i) % 3 == 0) text += locale.groupSeparator();
    text += QChar::fromLatin1(decimal[i]);
  }
  return text;
}

PatternPanel::PatternPanel(SessionHub& hub, QWidget* parent)
    : QWidget(parent),
      hub_(hub),
      empty_(new QLabel(tr("Open, paste or drop a crease pattern (FOLD, CP, OPX, SVG, DXF): its "
                           "faults and its folded states are listed here."),
                        this)),
      sign_(new QLabel(this)),
      verdict_(new QLabel(this)),
      total_(new QLabel(this)),
      count_(new QToolButton(this)),
      components_(new QTreeWidget(this)),
      faultsTitle_(title({}, this)),
      marks_(new QCheckBox(tr("Marked in the sheet"), this)),
      faults_(new QListWidget(this)),
      repairsTitle_(title(tr("Repairs and remarks"), this)),
      repairs_(new QListWidget(this)) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(12, 10, 12, 10);
  column->setSpacing(6);
  auto* head = new QHBoxLayout;
  head->addWidget(sign_, 0, Qt::AlignTop);
  head->addWidget(verdict_, 1);
  auto* states = new QHBoxLayout;
  states->addWidget(total_, 1);
  states->addWidget(count_);
  column->addWidget(empty_);
  column->addLayout(head);
  column->addLayout(states);
  makeLists();
  column->addWidget(components_, 3);
  column->addWidget(faultsTitle_);
  column->addWidget(marks_);
  column->addWidget(faults_, 2);
  column->addWidget(repairsTitle_);
  column->addWidget(repairs_, 2);
  column->addStretch(0);
  connectLists();
  connect(&hub, &SessionHub::patternChanged, this, &PatternPanel::refresh);
  refresh();
}

QString PatternPanel::verdict() const { return verdict_->text(); }
QString PatternPanel::total() const { return total_->text(); }

void PatternPanel::makeLists() {
  for (QLabel* label : {empty_, verdict_, total_}) label->setWordWrap(true);
  empty_->setProperty("faint", true);
  verdict_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  total_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  count_->setObjectName("count-states");
  marks_->setChecked(true);
  components_->setColumnCount(kColumns);
  components_->setHeaderLabels({tr("Component"), tr("State"), {}});
  components_->setRootIsDecorated(false);
  components_->setUniformRowHeights(true);
  components_->setAccessibleName(tr("Components of the folded states"));
  components_->header()->setSectionResizeMode(kName, QHeaderView::Stretch);
  components_->header()->setSectionResizeMode(kState, QHeaderView::ResizeToContents);
  components_->header()->setSectionResizeMode(kButtons, QHeaderView::Fixed);
  components_->header()->setStretchLastSection(false);
  components_->header()->resizeSection(kButtons, 60);
  faults_->setAccessibleName(tr("Faults of vertices"));
  repairs_->setAccessibleName(tr("Repairs and remarks"));
  for (QListWidget* list : {faults_, repairs_}) {
    list->setWordWrap(true);
    list->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    list->setMinimumHeight(56);
  }
}

void PatternPanel::connectLists() {
  const auto points = [this](PatternEntry::Kind kind, int row) {
    if (isUpdating_ || row < 0) return;
    hub_.session().lookAt({kind, static_cast<std::size_t>(row)});
  };
  connect(faults_, &QListWidget::itemClicked, this,
          [this, points] { points(PatternEntry::Kind::Fault, faults_->currentRow()); });
  connect(faults_, &QListWidget::currentRowChanged, this,
          [points](int row) { points(PatternEntry::Kind::Fault, row); });
  connect(repairs_, &QListWidget::itemClicked, this,
          [this, points] { points(PatternEntry::Kind::Repair, repairs_->currentRow()); });
  connect(components_, &QTreeWidget::currentItemChanged, this,
          [this, points](QTreeWidgetItem* item) {
            points(PatternEntry::Kind::Component, components_->indexOfTopLevelItem(item));
          });
  connect(marks_, &QCheckBox::toggled, this, [this](bool isOn) { desk().showFaults(isOn); });
  connect(count_, &QToolButton::clicked, this, [this] {
    if (desk().view().isCounting) {
      desk().stopCounting();
    } else if (desk().view().verdict == PatternVerdict::Unknown) {
      desk().search();
    } else {
      desk().count();
    }
  });
}

void PatternPanel::walk(int by) {
  const int row = components_->indexOfTopLevelItem(components_->currentItem());
  desk().walk(static_cast<std::size_t>(std::max(row, 0)), by);
}

void PatternPanel::refresh() {
  const QScopedValueRollback<bool> updating(isUpdating_, true);
  const PatternView& view = desk().view();
  const bool isThere = view.step.has_value();
  empty_->setVisible(!isThere);
  for (QWidget* widget : {static_cast<QWidget*>(sign_), static_cast<QWidget*>(verdict_)})
    widget->setVisible(isThere);
  showVerdict(view);
  showTotal(view);
  showComponents(view);
  showFaults(view);
  showRepairs(view);
}

void PatternPanel::showVerdict(const PatternView& view) {
  QString text;
  QString sign = "info";
  switch (view.verdict) {
    case PatternVerdict::Unknown:
      text = view.isSearching ? tr("Looking for folded states…")
                              : tr("It was not looked for folded states.");
      break;
    case PatternVerdict::FoldsFlat:
      text = tr("The pattern folds flat.");
      sign = "commit";
      break;
    case PatternVerdict::FoldsNot:
      text = tr("The pattern does not fold flat.");
      sign = "error";
      break;
    case PatternVerdict::NoState:
      text = tr("No folded state: these facets cannot be ordered.");
      sign = "error";
      break;
  }
  if (QString why = toQt(view.why); !why.isEmpty()) {
    why[0] = why[0].toUpper();
    text += "\n" + why;
  }
  verdict_->setText(text);
  sign_->setPixmap(icon(sign).pixmap(QSize(kVerdictSign, kVerdictSign), devicePixelRatioF()));
}

void PatternPanel::showTotal(const PatternView& view) {
  QString text;
  if (!view.total.empty()) {
    text =
        view.total == "1" ? tr("1 folded state") : tr("%1 folded states").arg(grouped(view.total));
    total_->setToolTip(toQt(view.total));
  } else if (view.isCounting) {
    text = tr("Counting folded states…");
  } else if (!view.countProblem.empty()) {
    text = toQt(view.countProblem);
  } else if (view.verdict == PatternVerdict::FoldsFlat) {
    text = tr("Folded states: not counted");
  }
  total_->setText(text);
  total_->setVisible(!text.isEmpty());
  const bool isUnknown = view.verdict == PatternVerdict::Unknown && !view.isSearching;
  const bool isUncounted = view.verdict == PatternVerdict::FoldsFlat && view.total.empty();
  count_->setVisible(view.step && (isUnknown || isUncounted));
  count_->setText(isUnknown ? tr("Search") : view.isCounting ? tr("Stop") : tr("Count"));
}

void PatternPanel::addButtons(QTreeWidgetItem& item, std::size_t index) {
  auto* buttons = new QWidget(components_);
  auto* line = new QHBoxLayout(buttons);
  line->setContentsMargins(0, 0, 0, 0);
  line->setSpacing(0);
  for (const int by : {-1, 1}) {
    auto* button = new QToolButton(buttons);
    button->setAutoRaise(true);
    button->setArrowType(by < 0 ? Qt::LeftArrow : Qt::RightArrow);
    button->setToolTip(by < 0 ? tr("Previous state") : tr("Next state"));
    button->setAccessibleName(button->toolTip());
    button->setObjectName(by < 0 ? "previous" : "next");
    connect(button, &QToolButton::clicked, this, [this, index, by] { desk().walk(index, by); });
    line->addWidget(button);
  }
  components_->setItemWidget(&item, kButtons, buttons);
}

void PatternPanel::fillRow(QTreeWidgetItem& item, std::size_t index,
                           const PatternComponent& component) {
  item.setText(kName, tr("%1: %2 facets").arg(index + 1).arg(component.facets));
  const QString number = component.number.empty() ? QString("?") : grouped(component.number);
  item.setText(kState, component.count.empty()
                           ? number
                           : tr("%1 of %2").arg(number, grouped(component.count)));
  item.setToolTip(kState, toQt(component.number));
}

void PatternPanel::showComponents(const PatternView& view) {
  const std::size_t rows = std::min(view.components.size(), kMostRows);
  components_->setVisible(rows > 0);
  if (static_cast<std::size_t>(components_->topLevelItemCount()) != rows) {
    components_->clear();
    for (std::size_t i = 0; i < rows; ++i) {
      auto* item = new QTreeWidgetItem(components_);
      if (i < kMostButtons) addButtons(*item, i);
    }
  }
  for (std::size_t i = 0; i < rows; ++i)
    fillRow(*components_->topLevelItem(static_cast<int>(i)), i, view.components[i]);
}

void PatternPanel::showFaults(const PatternView& view) {
  const bool isAny = !view.faults.empty();
  for (QWidget* widget : {static_cast<QWidget*>(faultsTitle_), static_cast<QWidget*>(marks_),
                          static_cast<QWidget*>(faults_)}) {
    widget->setVisible(isAny);
  }
  faultsTitle_->setText(
      counted(view.faults.size(), tr("1 fault of a vertex"), tr("%1 faults of vertices")));
  QStringList lines;
  for (std::size_t i = 0; i < std::min(view.faults.size(), kMostRows); ++i)
    lines << toQt(view.faults[i].message);
  QStringList shown;
  for (int i = 0; i < faults_->count(); ++i) shown << faults_->item(i)->text();
  if (lines == shown) return;
  faults_->clear();
  faults_->addItems(lines);
}

void PatternPanel::showRepairs(const PatternView& view) {
  QStringList lines;
  for (const Repair& repair : view.report.repairs) lines << toQt(repair.message);
  for (const std::string& note : view.report.notes) lines << toQt(note);
  repairsTitle_->setVisible(!lines.isEmpty());
  repairs_->setVisible(!lines.isEmpty());
  QStringList shown;
  for (int i = 0; i < repairs_->count(); ++i) shown << repairs_->item(i)->text();
  if (lines == shown) return;
  repairs_->clear();
  repairs_->addItems(lines);
}

}  // namespace kiri::desktop
