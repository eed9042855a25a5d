// The steps of the open model as rows, with their pictures.
// SPDX-License-Identifier: MIT
#include "apps/desktop/panels/steps_model.h"

#include <QImage>
#include <algorithm>
#include <cstdlib>
#include <utility>

#include "apps/desktop/look/convert.h"
#include "editor/document/step_fields.h"
#include "editor/document/thumbnails.h"

namespace kiri::desktop {
namespace {

QByteArray coloursOf(const Model& model) {
  const auto side = [](const PaperSide& s) {
    return toQt(s.color).name().toUtf8() + s.texture.c_str();
  };
  return side(model.front) + "/" + side(model.back);
}

/// The title that somebody gave the step, else what it is.
QString wordsOf(const Step& step, std::size_t number) {
  return step.title.empty() ? said(summaryOf(step, number)) : toQt(step.title);
}

/// All that is known of the step, a paragraph each.
QString tipOf(const Step& step, std::size_t number, const QString& problem) {
  QStringList parts{QString::number(number) + ". " + wordsOf(step, number)};
  if (!step.notes.empty()) parts << toQt(step.notes);
  if (!step.title.empty()) parts << said(summaryOf(step, number));
  if (!problem.isEmpty()) parts << problem;
  QString tip;
  for (const QString& part : parts)
    tip += "<p style=\"margin: 2px 0\">" + part.toHtmlEscaped() + "</p>";
  return tip;
}

}  // namespace

StepsModel::StepsModel(SessionHub& hub, QObject* parent)
    : QAbstractListModel(parent), hub_(hub), task_(hub.runner(), LatestTask::Overtaken::MayEnd) {
  connect(&hub, &SessionHub::documentChanged, this, &StepsModel::refresh);
  refresh();
}

void StepsModel::setPixels(int pixels) {
  if (pixels == pixels_) return;
  pixels_ = pixels;
  pictures_.clear();
  refresh();
}

int StepsModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(rows_.size());
}

int StepsModel::currentRow() const { return static_cast<int>(hub_.session().document().cursor()); }

void StepsModel::refresh() {
  const Document& document = hub_.session().document();
  const std::vector<Step>& steps = document.model().steps;
  std::vector<Row> rows;
  rows.reserve(steps.size() + 1);
  rows.push_back({tr("Sheet"), tr("Sheet"), {}, document.stateAfter(0)});
  for (std::size_t i = 0; i < steps.size(); ++i) {
    const std::optional<Error> problem = document.problemOf(i);
    const QString why = problem ? toQt(problem->message) : QString();
    rows.push_back({QString::number(i + 1) + ". " + wordsOf(steps[i], i + 1),
                    tipOf(steps[i], i + 1, why), why, document.stateAfter(i + 1)});
  }
  if (const QByteArray colours = coloursOf(document.model()); colours != colours_) {
    colours_ = colours;
    pictures_.clear();
  }
  // Pictures of states that are gone are forgotten.
  QHash<const FoldedState*, Picture> kept;
  for (const Row& row : rows) {
    const auto old = pictures_.constFind(row.state.get());
    if (row.state && old != pictures_.constEnd()) kept.insert(row.state.get(), *old);
  }
  pictures_ = std::move(kept);
  // A step more or less keeps the place to which the list was scrolled.
  const int before = rowCount();
  const int after = static_cast<int>(rows.size());
  if (after > before) beginInsertRows({}, before, after - 1);
  if (after < before) beginRemoveRows({}, after, before - 1);
  rows_ = std::move(rows);
  if (after > before) endInsertRows();
  if (after < before) endRemoveRows();
  emit dataChanged(index(0), index(after - 1));
  drawNext();
}

void StepsModel::drawNext() {
  if (task_.isBusy()) return;
  // Those that are seen come first: the cards about the cursor.
  std::vector<const Row*> order;
  for (const Row& row : rows_) order.push_back(&row);
  const auto away = [here = &rows_[0] + currentRow()](const Row* row) {
    return std::abs(row - here);
  };
  std::stable_sort(order.begin(), order.end(),
                   [&](const Row* a, const Row* b) { return away(a) < away(b); });
  for (const Row* next : order) {
    const Row& row = *next;
    if (!row.state || pictures_.contains(row.state.get())) continue;
    auto image = std::make_shared<QImage>();
    auto model = std::make_shared<Model>(hub_.session().document().model());
    model->steps.clear();
    task_.ask({{},
               [image, model, state = row.state, pixels = pixels_](const Progress& progress) {
                 const Result<Image> drawn = thumbnailOf(*state, *model, pixels, progress);
                 if (drawn) *image = toQt(*drawn);
               },
               [this, image, state = row.state] {
                 pictures_.insert(state.get(), {state, QPixmap::fromImage(*image)});
                 emit dataChanged(index(0), index(rowCount() - 1), {PictureRole});
                 QMetaObject::invokeMethod(this, &StepsModel::drawNext, Qt::QueuedConnection);
               }});
    return;
  }
}

QVariant StepsModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid() || index.row() >= rowCount()) return {};
  const Row& row = rows_[static_cast<std::size_t>(index.row())];
  switch (role) {
    case Qt::DisplayRole:
    case Qt::AccessibleTextRole:
      return row.text;
    case Qt::ToolTipRole:
      return row.tip;
    case PictureRole:
      return pictures_.value(row.state.get()).pixmap;
    case IsCurrentRole:
      return index.row() == currentRow();
    case IsUndoneRole:
      return index.row() > currentRow();
    case ProblemRole:
      return row.problem;
    default:
      return {};
  }
}

}  // namespace kiri::desktop
