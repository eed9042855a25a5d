// The colours of the window: light and dark, of its own things and of what is drawn over paper.
// SPDX-License-Identifier: MIT
#pragma once

#include <QColor>
#include <QPalette>
#include <QString>

#include "editor/view/marks.h"
#include "render/mesh/paper_mesh.h"
#include "render/scene/appearance.h"

class QApplication;

namespace kiri::desktop {

enum class Shade { Light, Dark };

/// What the window is painted with. Everything that paints asks `theme()` while painting, so a
/// change of shade needs no more than a repaint.
struct Theme {
  Shade shade = Shade::Light;
  QColor ground;       ///< behind the folded model
  QColor sheetGround;  ///< behind the flat sheet
  QColor grid;
  QColor text;
  QColor faintText;  ///< labels, what is less important
  QColor icon;
  QColor accent;      ///< what is chosen
  QColor accentText;  ///< on the accent
  QColor line;        ///< between parts of the window
  QColor card;        ///< of a step, of a row
  QColor cardHover;
  QColor good;     ///< done, free
  QColor warning;  ///< collides, undecided
  QColor fault;    ///< refused, fails
  QColor plate;    ///< behind words that are written over paper
  QColor plateText;

  bool isDark() const { return shade == Shade::Dark; }
};

const Theme& theme();
/// Sets palette, style and style sheet of the whole program.
void applyTheme(QApplication& application, Shade shade);
/// The shade that the desktop asks for, as far as its palette tells.
Shade shadeOfDesktop();

/// How the outline of a mark is drawn.
struct MarkPen {
  QColor color;
  QColor casing;  ///< below the line, so that it is seen on paper of any colour
  double width = 1.5;
  QVector<qreal> dashes;  ///< in widths of the pen; empty: solid
};
MarkPen penOf(MarkRole role, LineStyle style);

/// The veil over a facet that is tinted; alpha is how much of it.
QColor tintOf(FacetTint tint);

}  // namespace kiri::desktop
