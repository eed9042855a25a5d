// Draws what a tool shows over the paper: lines, handles, words, dials.
// SPDX-License-Identifier: MIT
#include "apps/desktop/look/mark_painter.h"

#include <QPainterPath>
#include <algorithm>
#include <cmath>

#include "apps/desktop/look/convert.h"
#include "core/geometry/rigid.h"

namespace kiri::desktop {
namespace {

constexpr double kFarPixels = 100'000;  // farther out nothing is seen, and painters lose their way
constexpr double kArrow = 11;           // length of an arrow's head, pixels
constexpr double kPlateAway = 14;       // from a place to the words about it, pixels
constexpr int kDialParts = 48;

bool isSane(QPointF p) {
  return std::isfinite(p.x()) && std::isfinite(p.y()) && std::abs(p.x()) < kFarPixels &&
         std::abs(p.y()) < kFarPixels;
}

/// Where an arrow comes from: a place far enough back on its line to tell a direction.
QPointF tailOf(const std::vector<QPointF>& line) {
  const QPointF tip = line.back();
  for (auto place = line.rbegin(); place != line.rend(); ++place) {
    if (std::hypot(place->x() - tip.x(), place->y() - tip.y()) > kArrow) return *place;
  }
  return line.front();
}

QPainterPath arrowHead(QPointF from, QPointF to) {
  const QPointF along = to - from;
  const double length = std::hypot(along.x(), along.y());
  if (length < 1) return {};
  const QPointF unit = along / length;
  const QPointF across(-unit.y(), unit.x());
  QPainterPath head;
  head.moveTo(to);
  head.lineTo(to - unit * kArrow + across * (kArrow * 0.45));
  head.lineTo(to - unit * (kArrow * 0.75));
  head.lineTo(to - unit * kArrow - across * (kArrow * 0.45));
  head.closeSubpath();
  return head;
}

}  // namespace

MarkPainter::MarkPainter(QPainter& painter, const PaneMap& map, const FoldedState& state,
                         LineStyle style)
    : painter_(painter), map_(map), state_(state), style_(style) {}

void MarkPainter::paint(const Marks& marks) {
  painter_.setRenderHint(QPainter::Antialiasing);
  for (const Mark& mark : marks) {
    if (const auto* path = std::get_if<PathMark>(&mark)) paintPath(*path);
  }
  for (const Mark& mark : marks) {
    if (const auto* dial = std::get_if<DialMark>(&mark)) paintDial(*dial);
  }
  for (const Mark& mark : marks) {
    if (const auto* point = std::get_if<PointMark>(&mark)) paintPoint(*point);
  }
  for (const Mark& mark : marks) {
    if (const auto* text = std::get_if<TextMark>(&mark)) paintText(*text);
  }
}

std::optional<QPointF> MarkPainter::pixelsOf(const MarkPlace& place) const {
  QPointF at;
  if (const auto* spot = std::get_if<Spot>(&place)) {
    if (spot->facet.index >= state_.pattern.facets.size()) return std::nullopt;
    at = toQt(map_.toPixels(state_, *spot));
  } else if (const auto* point = std::get_if<Vec3>(&place)) {
    if (map_.pane != Pane::Model) return std::nullopt;
    at = toQt(map_.toPixels(*point));
  } else {
    const auto& pixel = std::get<PixelPlace>(place);
    if (pixel.pane != map_.pane) return std::nullopt;
    at = toQt(pixel.at);
  }
  if (!isSane(at)) return std::nullopt;
  return at;
}

void MarkPainter::stroke(const QPainterPath& path, const MarkPen& pen) {
  painter_.setBrush(Qt::NoBrush);
  painter_.setPen(QPen(pen.casing, pen.width + 2.5, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
  painter_.drawPath(path);
  QPen line(pen.color, pen.width, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin);
  if (!pen.dashes.isEmpty()) {
    line.setDashPattern(pen.dashes);
    line.setCapStyle(Qt::FlatCap);
  }
  painter_.setPen(line);
  painter_.drawPath(path);
}

void MarkPainter::paintPath(const PathMark& mark) {
  std::vector<QPointF> points;
  for (const MarkPlace& place : mark.places) {
    const std::optional<QPointF> at = pixelsOf(place);
    if (!at) return;
    points.push_back(*at);
  }
  if (points.size() < 2) return;
  MarkPen pen = penOf(mark.role, style_);
  if (mark.hasArrow) pen.dashes.clear();  // a movement, not a crease
  QPainterPath path(points.front());
  for (std::size_t i = 1; i < points.size(); ++i) path.lineTo(points[i]);
  if (mark.isClosed) path.closeSubpath();
  stroke(path, pen);
  if (mark.hasArrow) {
    const QPainterPath head = arrowHead(tailOf(points), points.back());
    painter_.setPen(QPen(pen.casing, 2));
    painter_.setBrush(pen.color);
    painter_.drawPath(head);
  }
}

void MarkPainter::paintDial(const DialMark& mark) {
  const std::optional<QPointF> middle = pixelsOf(mark.at);
  if (!middle) return;
  if (map_.pane == Pane::Model) {
    const double mm = mark.radius / std::max(map_.pixelsPerMm, kPlateAway / kFarPixels);
    Vec3 place;
    if (const auto* spot = std::get_if<Spot>(&mark.at)) {
      place = map_.placeOf(state_, *spot);
    } else if (const auto* point = std::get_if<Vec3>(&mark.at)) {
      place = *point;
    } else {
      return;
    }
    const Vec3 side = cross(mark.axis, mark.from);
    QPainterPath pie(*middle);
    QPainterPath rim;
    for (int i = 0; i <= kDialParts; ++i) {
      const CosSin turn = cosSinDegrees(mark.degrees * i / kDialParts);
      const Vec3 spoke = mark.from * turn.cos + side * turn.sin;
      const QPointF at = toQt(map_.toPixels(place + spoke * mm));
      if (!isSane(at)) return;
      pie.lineTo(at);
      if (i == 0) rim.moveTo(at);
      rim.lineTo(at);
    }
    pie.closeSubpath();
    QColor veil = theme().accent;
    veil.setAlpha(60);
    painter_.setPen(Qt::NoPen);
    painter_.setBrush(veil);
    painter_.drawPath(pie);
    stroke(rim, penOf(MarkRole::Handle, style_));
  }
  const QString degrees = QString::number(std::round(mark.degrees * 10) / 10) + "°";
  paintPlate(*middle, degrees, theme().plateText);
}

void MarkPainter::paintPoint(const PointMark& mark) {
  const std::optional<QPointF> at = pixelsOf(mark.at);
  if (!at) return;
  const MarkPen pen = penOf(mark.role, style_);
  const bool isHandle = mark.role == MarkRole::Handle || mark.role == MarkRole::ActiveHandle;
  const bool isRing = mark.role == MarkRole::Snap || mark.role == MarkRole::Hovered;
  const double radius = mark.role == MarkRole::ActiveHandle ? 6.5 : isHandle ? 5 : isRing ? 6 : 4;
  painter_.setBrush(Qt::NoBrush);
  painter_.setPen(QPen(pen.casing, 4));
  painter_.drawEllipse(*at, radius, radius);
  painter_.setPen(QPen(pen.color, 2));
  if (mark.role == MarkRole::Handle) painter_.setBrush(theme().plate);
  if (!isHandle && !isRing) painter_.setBrush(pen.color);
  if (mark.role == MarkRole::ActiveHandle) painter_.setBrush(pen.color);
  painter_.drawEllipse(*at, radius, radius);
}

void MarkPainter::paintText(const TextMark& mark) {
  const std::optional<QPointF> at = pixelsOf(mark.at);
  if (!at) return;
  const bool isBad = mark.role == MarkRole::Fault;
  const bool isWarning = mark.role == MarkRole::Collision;
  const QColor color = isBad ? theme().fault : isWarning ? theme().warning : theme().plateText;
  paintPlate(*at, said(mark.text), color);
}

void MarkPainter::paintPlate(QPointF at, const QString& text, const QColor& color) {
  if (text.isEmpty()) return;
  const QFontMetricsF metrics(painter_.font());
  QRectF plate = metrics.boundingRect(text).adjusted(-7, -3, 7, 3);
  plate.moveTopLeft(at + QPointF(kPlateAway, -kPlateAway - plate.height()));
  const double right = map_.size.x - 4;
  if (plate.right() > right) plate.moveRight(std::min(right, at.x() - kPlateAway));
  if (plate.left() < 4) plate.moveLeft(4);
  if (plate.top() < 4) plate.moveTop(at.y() + kPlateAway);
  for (const QRectF& other : plates_) {
    if (other.intersects(plate)) plate.moveTop(other.bottom() + 2);
  }
  plates_.push_back(plate);
  painter_.setPen(QPen(theme().line, 1));
  painter_.setBrush(theme().plate);
  painter_.drawRoundedRect(plate, 5, 5);
  painter_.setPen(color);
  painter_.drawText(plate, Qt::AlignCenter, text);
}

}  // namespace kiri::desktop
