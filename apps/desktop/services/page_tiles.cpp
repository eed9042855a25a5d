// A picture larger than the paper of a printer, spread over several pages.
// SPDX-License-Identifier: MIT
#include "apps/desktop/services/page_tiles.h"

#include <QCoreApplication>
#include <QFont>
#include <QPen>
#include <algorithm>
#include <cmath>

#include "apps/desktop/look/scene_painter.h"

namespace kiri::desktop {

namespace {

/// Pages in one direction. A picture a hair larger than the page fits: paper is not that exact.
int pagesFor(double picture, double page, double overlap) {
  constexpr double kHair = 0.05;  // mm
  if (picture <= page + kHair) return 1;
  const double step = page - overlap;
  return 1 + static_cast<int>(std::ceil((picture - page - kHair) / step));
}

double startOf(double picture, double page, double overlap, int count, int index) {
  const double step = page - overlap;
  const double all = page + step * (count - 1);
  return (picture - all) / 2 + step * index;
}

/// Where a neighbour's edge is laid on, and crosses that two pages share.
void paintMarks(QPainter& painter, const PageTiles& tiles, int column, int row) {
  const double left = column > 0 ? tiles.overlap / 2 : 0;
  const double top = row > 0 ? tiles.overlap / 2 : 0;
  const double right = tiles.page.width() - (column + 1 < tiles.columns ? tiles.overlap / 2 : 0);
  const double bottom = tiles.page.height() - (row + 1 < tiles.rows ? tiles.overlap / 2 : 0);
  constexpr double kThin = 0.1;
  constexpr double kArm = 3;
  QPen pen(QColor(110, 110, 110), kThin);
  pen.setDashPattern({12, 12});
  painter.setPen(pen);
  if (column > 0) painter.drawLine(QLineF(left, 0, left, tiles.page.height()));
  if (row > 0) painter.drawLine(QLineF(0, top, tiles.page.width(), top));
  if (column + 1 < tiles.columns) painter.drawLine(QLineF(right, 0, right, tiles.page.height()));
  if (row + 1 < tiles.rows) painter.drawLine(QLineF(0, bottom, tiles.page.width(), bottom));
  painter.setPen(QPen(Qt::black, kThin * 2));
  for (const double x : {left, right}) {
    for (const double y : {top, bottom}) {
      painter.drawLine(QLineF(x - kArm, y, x + kArm, y));
      painter.drawLine(QLineF(x, y - kArm, x, y + kArm));
    }
  }
}

void paintNumber(QPainter& painter, const PageTiles& tiles, int column, int row) {
  const QString letter(QChar('A' + row % 26));
  const QString text =
      QCoreApplication::translate("kiri::desktop::PageTiles", "%1%2 of %3 × %4 pages, true size")
          .arg(letter)
          .arg(column + 1)
          .arg(tiles.columns)
          .arg(tiles.rows);
  constexpr int kPixels = 100;
  constexpr double kHeight = 2.6;  // mm
  QFont font("sans-serif");
  font.setPixelSize(kPixels);
  QPainterPath path;
  path.addText(0, 0, font, text);
  painter.save();
  painter.translate(tiles.overlap / 2 + 4, tiles.page.height() - tiles.overlap / 2 - 2);
  painter.scale(kHeight / kPixels, kHeight / kPixels);
  painter.fillPath(path, QColor(60, 60, 60));
  painter.restore();
}

}  // namespace

QRectF PageTiles::partOn(int column, int row) const {
  return QRectF(QPointF(startOf(picture.width(), page.width(), overlap, columns, column),
                        startOf(picture.height(), page.height(), overlap, rows, row)),
                page);
}

PageTiles tilesFor(QSizeF picture, QSizeF page, double overlap) {
  PageTiles tiles{picture, page, overlap, 1, 1};
  const double least = std::min(page.width(), page.height());
  tiles.overlap = std::clamp(overlap, 0.0, std::max(0.0, least / 2));
  tiles.columns = pagesFor(picture.width(), page.width(), tiles.overlap);
  tiles.rows = pagesFor(picture.height(), page.height(), tiles.overlap);
  return tiles;
}

void paintTile(QPainter& painter, const Scene& scene, const PageTiles& tiles, int column, int row) {
  const QRectF part = tiles.partOn(column, row);
  painter.save();
  painter.setClipRect(QRectF(QPointF(0, 0), tiles.page));
  painter.save();
  painter.translate(-part.topLeft());
  paintScene(painter, scene);
  painter.restore();
  if (tiles.count() > 1) {
    paintMarks(painter, tiles, column, row);
    paintNumber(painter, tiles, column, row);
  }
  painter.restore();
}

}  // namespace kiri::desktop
