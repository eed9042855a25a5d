// Paints the flat sheet: its paper, creases, cuts and tints, curves as curves.
// SPDX-License-Identifier: MIT
#include "apps/desktop/views/sheet_painter.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "apps/desktop/look/convert.h"
#include "apps/desktop/look/theme.h"
#include "core/paper/contours.h"

namespace kiri::desktop {
namespace {

constexpr double kFoldedWidth = 1.6;  // pixels
constexpr double kFlatWidth = 0.9;
constexpr double kBorderWidth = 1.4;
constexpr double kPaleness = 0.62;  // how much of white the paper has here: creases are to be read
constexpr double kGridPixelsLeast = 5;  // finer grids are left out
constexpr std::size_t kKinds = 6;

QColor paled(const QColor& color) {
  const auto mix = [](int part) {
    return static_cast<int>(std::lround(part * (1 - kPaleness) + 255 * kPaleness));
  };
  return {mix(color.red()), mix(color.green()), mix(color.blue())};
}

}  // namespace

SheetLine sheetLineOf(const Edge& edge) {
  switch (edge.kind) {
    case EdgeKind::Border:
      return {LineKind::Border, false};
    case EdgeKind::Tear:
      return {LineKind::Tear, false};
    case EdgeKind::Cut:
      return {LineKind::Cut, false};
    case EdgeKind::Hinge:
      break;
  }
  if (edge.angle > 0) return {LineKind::Valley, false};
  if (edge.angle < 0) return {LineKind::Mountain, false};
  if (!edge.line.isValid()) return {LineKind::Flat, true};
  return {edge.sign > 0 ? LineKind::Valley : LineKind::Mountain, true};
}

SheetPainter::SheetPainter(QPainter& painter, const PaneMap& map, const FoldedState& state,
                           const Appearance& appearance, const Display& display)
    : painter_(painter), map_(map), state_(state), appearance_(appearance), display_(display) {
  painter_.setRenderHint(QPainter::Antialiasing);
  painter_.setRenderHint(QPainter::SmoothPixmapTransform);
}

bool SheetPainter::showsBack() const { return map_.frame.toEye.z < 0; }

QPointF SheetPainter::at(Vec2 paper) const {
  return toQt(map_.toPixels(Vec3{paper.x, paper.y, 0}));
}

void SheetPainter::append(QPainterPath& path, const Arc& arc, bool isFirst) const {
  if (isFirst) path.moveTo(at(arc.start));
  if (arc.isCurved) {
    path.cubicTo(at(arc.control1), at(arc.control2), at(arc.end));
  } else {
    path.lineTo(at(arc.end));
  }
}

/// The paper as a whole: no seams between its facets.
QPainterPath SheetPainter::outline() const {
  QPainterPath path;
  for (const std::vector<EdgeUse>& contour : contoursOf(state_.pattern)) {
    bool isFirst = true;
    for (const EdgeUse use : contour) {
      append(path, arcOf(state_.pattern, use), isFirst);
      isFirst = false;
    }
    path.closeSubpath();
  }
  return path;
}

QPainterPath SheetPainter::pathOf(FacetId facet) const {
  const Facet& shape = state_.pattern[facet];
  QPainterPath path;
  std::size_t hole = 0;
  for (std::size_t i = 0; i < shape.border.size(); ++i) {
    const bool startsHole = hole < shape.holeStarts.size() && shape.holeStarts[hole] == i;
    if (startsHole) {
      path.closeSubpath();
      ++hole;
    }
    append(path, arcOf(state_.pattern, shape.border[i]), i == 0 || startsHole);
  }
  path.closeSubpath();
  return path;
}

void SheetPainter::paint(const std::vector<FacetTint>& tints) {
  const QPainterPath paper = outline();
  paintPaper(paper);
  if (tints.size() == state_.pattern.facets.size()) paintTints(tints);
  if (appearance_.gridSpacing > 0) paintGrid(paper);
  paintLines();
}

void SheetPainter::paintGhost() {
  painter_.setBrush(Qt::NoBrush);
  painter_.setPen(QPen(theme().faintText, 1, Qt::DotLine));
  painter_.drawPath(outline());
}

void SheetPainter::paintPaper(const QPainterPath& outline) {
  const SideLook& side = showsBack() ? appearance_.back : appearance_.front;
  painter_.setPen(Qt::NoPen);
  painter_.setBrush(paled(toQt(side.color)));
  painter_.drawPath(outline);
  if (!side.texture) return;
  const QImage image = toQt(*side.texture);
  const Box& box = appearance_.textureBox;
  painter_.save();
  painter_.setClipPath(outline);
  const QPointF low = at(box.low);
  const QPointF high = at(box.high);
  painter_.setOpacity(1 - kPaleness / 2);
  painter_.drawImage(QRectF(low, high).normalized(), image);
  painter_.restore();
}

void SheetPainter::paintTints(const std::vector<FacetTint>& tints) {
  painter_.setPen(Qt::NoPen);
  for (std::size_t i = 0; i < tints.size(); ++i) {
    if (tints[i] == FacetTint::None) continue;
    painter_.setBrush(tintOf(tints[i]));
    painter_.drawPath(pathOf(FacetId(i)));
  }
}

void SheetPainter::paintGrid(const QPainterPath& outline) {
  const double spacing = appearance_.gridSpacing;
  if (spacing * map_.pixelsPerMm < kGridPixelsLeast) return;
  const Box& box = appearance_.textureBox;
  painter_.save();
  painter_.setClipPath(outline);
  painter_.setPen(QPen(QColor(0, 0, 0, 40), 0.8));
  for (double x = std::ceil(box.low.x / spacing) * spacing; x < box.high.x; x += spacing) {
    painter_.drawLine(at({x, box.low.y}), at({x, box.high.y}));
  }
  for (double y = std::ceil(box.low.y / spacing) * spacing; y < box.high.y; y += spacing) {
    painter_.drawLine(at({box.low.x, y}), at({box.high.x, y}));
  }
  painter_.restore();
}

void SheetPainter::stroke(const QPainterPath& path, LineKind kind, double width) {
  if (path.isEmpty()) return;
  const Stroke look = strokeFor(kind, appearance_, width);
  QPen pen(toQt(look.color), width, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin);
  if (!look.dashes.empty()) {
    QVector<qreal> dashes;
    for (const double dash : look.dashes) dashes.push_back(dash / width);
    pen.setDashPattern(dashes);
    pen.setCapStyle(Qt::FlatCap);
  }
  painter_.setBrush(Qt::NoBrush);
  painter_.setPen(pen);
  painter_.drawPath(path);
}

void SheetPainter::paintLines() {
  std::array<QPainterPath, kKinds> folded;
  std::array<QPainterPath, kKinds> flat;
  for (std::size_t i = 0; i < state_.pattern.edges.size(); ++i) {
    const EdgeId edge(i);
    SheetLine line = sheetLineOf(state_.pattern[edge]);
    if (showsBack() && line.kind == LineKind::Mountain) {
      line.kind = LineKind::Valley;
    } else if (showsBack() && line.kind == LineKind::Valley) {
      line.kind = LineKind::Mountain;
    }
    const auto kind = static_cast<std::size_t>(line.kind);
    append(line.isFlat ? flat[kind] : folded[kind], arcOf(state_.pattern, edge), true);
  }
  for (std::size_t kind = 0; kind < kKinds; ++kind) {
    if (display_.showsCreases) stroke(flat[kind], static_cast<LineKind>(kind), kFlatWidth);
  }
  const auto paint = [&](LineKind kind, bool isShown, double width) {
    if (isShown) stroke(folded[static_cast<std::size_t>(kind)], kind, width);
  };
  paint(LineKind::Mountain, display_.showsEdges, kFoldedWidth);
  paint(LineKind::Valley, display_.showsEdges, kFoldedWidth);
  paint(LineKind::Tear, true, kFoldedWidth);
  paint(LineKind::Cut, true, kFoldedWidth);
  paint(LineKind::Border, display_.showsBorders, kBorderWidth);
}

}  // namespace kiri::desktop
