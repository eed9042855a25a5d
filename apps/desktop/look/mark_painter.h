// Draws what a tool shows over the paper: lines, handles, words, dials.
// SPDX-License-Identifier: MIT
#pragma once

#include <QPainter>
#include <QRectF>
#include <memory>
#include <optional>
#include <vector>

#include "apps/desktop/look/theme.h"
#include "editor/view/marks.h"
#include "editor/view/pane_map.h"

namespace kiri::desktop {

/// Draws marks in one pane, in pixels of that pane. Marks that do not belong to the pane, or whose
/// facet the state does not have, are left out.
class MarkPainter {
 public:
  /// `state`: that whose facets the marks name. References hold for the life of the painter.
  MarkPainter(QPainter& painter, const PaneMap& map, const FoldedState& state, LineStyle style);
  /// Lines first, then dials, then points, and words on top, so that nothing hides what is said.
  void paint(const Marks& marks);

 private:
  std::optional<QPointF> pixelsOf(const MarkPlace& place) const;
  void paintPath(const PathMark& mark);
  void paintDial(const DialMark& mark);
  void paintPoint(const PointMark& mark);
  void paintText(const TextMark& mark);
  void paintPlate(QPointF at, const QString& text, const QColor& color);
  void stroke(const QPainterPath& path, const MarkPen& pen);

  QPainter& painter_;
  const PaneMap& map_;
  const FoldedState& state_;
  LineStyle style_;
  std::vector<QRectF> plates_;  ///< words that are there already
};

}  // namespace kiri::desktop
