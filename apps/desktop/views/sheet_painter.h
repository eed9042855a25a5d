// Paints the flat sheet: its paper, creases, cuts and tints, curves as curves.
// SPDX-License-Identifier: MIT
#pragma once

#include <QPainter>
#include <QPainterPath>
#include <vector>

#include "apps/desktop/look/display.h"
#include "editor/view/marks.h"
#include "editor/view/pane_map.h"
#include "render/scene/appearance.h"
#include "render/scene/line_looks.h"

namespace kiri::desktop {

/// Paints one state as it lies in the paper frame. References hold for the life of the painter.
class SheetPainter {
 public:
  SheetPainter(QPainter& painter, const PaneMap& map, const FoldedState& state,
               const Appearance& appearance, const Display& display);
  /// Paper, tints, grid, lines. `tints`: one for each facet, or empty.
  void paint(const std::vector<FacetTint>& tints);
  /// The outline of the paper alone, as a ghost of what was there.
  void paintGhost();

 private:
  QPointF at(Vec2 paper) const;
  void append(QPainterPath& path, const Arc& arc, bool isFirst) const;
  QPainterPath outline() const;
  QPainterPath pathOf(FacetId facet) const;
  void paintPaper(const QPainterPath& outline);
  void paintTints(const std::vector<FacetTint>& tints);
  void paintGrid(const QPainterPath& outline);
  void paintLines();
  void stroke(const QPainterPath& path, LineKind kind, double width);
  bool showsBack() const;

  QPainter& painter_;
  const PaneMap& map_;
  const FoldedState& state_;
  const Appearance& appearance_;
  const Display& display_;
};

/// What a line of the sheet is drawn as, seen from the front: hinges by the sign of their angle,
/// those that lie flat by the fold that made them.
struct SheetLine {
  LineKind kind = LineKind::Border;
  bool isFlat = false;  ///< a hinge that is not folded now
};
SheetLine sheetLineOf(const Edge& edge);

}  // namespace kiri::desktop
