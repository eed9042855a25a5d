// A picture larger than the paper of a printer, spread over several pages.
// SPDX-License-Identifier: MIT
#pragma once

#include <QPainter>
#include <QRectF>
#include <QSizeF>

#include "render/scene/scene.h"

namespace kiri::desktop {

/// Pages side by side, each showing a part of the picture, neighbours sharing a strip to be glued.
/// Lengths in mm, y down from the upper left corner of the picture.
struct PageTiles {
  QSizeF picture;
  QSizeF page;         ///< what the printer can print on one sheet
  double overlap = 0;  ///< shared by neighbours
  int columns = 1;
  int rows = 1;

  int count() const { return columns * rows; }
  /// The part of the picture (which may reach beyond it) that a page shows.
  QRectF partOn(int column, int row) const;
};

/// As few pages as hold the picture; the picture is in the middle of all of them.
PageTiles tilesFor(QSizeF picture, QSizeF page, double overlap);

/// Draws a page: the unit of the painter is the mm, its origin the corner of what can be printed.
/// More than one page: with the lines where the next page is laid on, crosses at their corners, and
/// the number of the page ("B2 of 3 × 2").
void paintTile(QPainter& painter, const Scene& scene, const PageTiles& tiles, int column, int row);

}  // namespace kiri::desktop
