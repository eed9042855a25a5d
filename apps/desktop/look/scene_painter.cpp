// Draws the pictures of render/scene with Qt.
// SPDX-License-Identifier: MIT
#include "apps/desktop/look/scene_painter.h"

#include <QBrush>
#include <QFont>
#include <QFontMetricsF>
#include <QPen>
#include <QTransform>
#include <algorithm>
#include <variant>

#include "apps/desktop/look/convert.h"

namespace kiri::desktop {

namespace {

QPointF at(Vec2 p) { return {p.x, p.y}; }
QColor colorOf(Color c, double opacity = 1) {
  QColor color(c.red, c.green, c.blue);
  color.setAlphaF(static_cast<float>(opacity));
  return color;
}

void addChain(QPainterPath& path, const std::vector<Arc>& chain, bool isClosed) {
  if (chain.empty()) return;
  path.moveTo(at(chain.front().start));
  for (const Arc& arc : chain) {
    if (arc.isCurved) {
      path.cubicTo(at(arc.control1), at(arc.control2), at(arc.end));
    } else {
      path.lineTo(at(arc.end));
    }
  }
  if (isClosed) path.closeSubpath();
}

/// The image lying in the scene as `imageToScene` says, whose unit square it is, y up.
QBrush brushOf(const Image& image, const Affine& imageToScene) {
  QBrush brush(toQt(image));
  const QTransform toUnit(1.0 / image.width, 0, 0, -1.0 / image.height, 0, 1);
  const Affine& m = imageToScene;
  brush.setTransform(toUnit * QTransform(m.a, m.b, m.c, m.d, m.e, m.f));
  return brush;
}

QPen penOf(const Stroke& stroke, double width) {
  QPen pen(colorOf(stroke.color), width);
  pen.setCapStyle(stroke.cap == LineCap::Round ? Qt::RoundCap : Qt::FlatCap);
  pen.setJoinStyle(Qt::RoundJoin);
  if (!stroke.dashes.empty() && width > 0) {
    QList<qreal> dashes;
    for (const double mm : stroke.dashes) dashes.append(mm / width);  // Qt counts in widths
    if (dashes.size() % 2 != 0) dashes += dashes;
    pen.setDashPattern(dashes);
  }
  return pen;
}

class Drawing {
 public:
  Drawing(QPainter& painter, double leastSeam) : painter_(painter), leastSeam_(leastSeam) {}

  void draw(const FillItem& item, const Item&) {
    const QPainterPath path = pathOf(item.loops);
    painter_.fillPath(path, colorOf(item.fill.color, item.fill.opacity));
    if (item.fill.image) {
      painter_.fillPath(path, brushOf(*item.fill.image, item.fill.imageToScene));
    }
  }
  void draw(const StrokeItem& item, const Item& about) {
    QPainterPath path;
    for (const std::vector<Arc>& chain : item.chains) {
      addChain(path, chain, chain.size() > 1 && chain.front().start == chain.back().end);
    }
    const bool isSeam = about.kind == "seam";
    QPen pen =
        penOf(item.stroke, isSeam ? std::max(item.stroke.width, leastSeam_) : item.stroke.width);
    painter_.strokePath(path, pen);
    if (!item.stroke.image) return;
    pen.setBrush(brushOf(*item.stroke.image, item.stroke.imageToScene));
    painter_.strokePath(path, pen);
  }
  void draw(const TextItem& item, const Item&) {
    // Fonts have whole sizes on some devices: written large and made small.
    constexpr int kPixels = 100;
    QFont font("sans-serif");
    font.setPixelSize(kPixels);
    font.setBold(item.isBold);
    const QString text = QString::fromStdString(item.text);
    const double width = QFontMetricsF(font).horizontalAdvance(text);
    const double left = item.anchor == TextAnchor::Start    ? 0
                        : item.anchor == TextAnchor::Middle ? width / 2
                                                            : width;
    QPainterPath path;
    path.addText(-left, 0, font, text);
    painter_.save();
    painter_.translate(at(item.at));
    painter_.scale(item.height / kPixels, -item.height / kPixels);
    painter_.fillPath(path, colorOf(item.color));
    painter_.restore();
  }

 private:
  QPainter& painter_;
  double leastSeam_;
};

}  // namespace

QPainterPath pathOf(const std::vector<Loop>& loops) {
  QPainterPath path;
  path.setFillRule(Qt::OddEvenFill);
  for (const Loop& loop : loops) addChain(path, loop, true);
  return path;
}

void paintScene(QPainter& painter, const Scene& scene, double leastSeam) {
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setRenderHint(QPainter::SmoothPixmapTransform);
  painter.translate(0, scene.height);
  painter.scale(1, -1);
  Drawing drawing(painter, leastSeam);
  for (const Group& group : scene.groups) {
    painter.save();
    if (!group.clip.empty()) painter.setClipPath(pathOf(group.clip), Qt::IntersectClip);
    for (const Item& item : group.items)
      std::visit([&](const auto& shape) { drawing.draw(shape, item); }, item.shape);
    painter.restore();
  }
  painter.restore();
}

}  // namespace kiri::desktop
