// Draws the pictures of render/scene with Qt: for printers and widgets.
// SPDX-License-Identifier: MIT
#pragma once

#include <QImage>
#include <QPainter>
#include <QPainterPath>

#include "render/scene/scene.h"

namespace kiri::desktop {

/// Draws the scene so that one mm of it is one unit of the painter, its upper left corner at the
/// origin, y down. Curves stay curves; the scene's background is not drawn. `leastSeam`: mm that
/// underlays of seams are wide at least, as in render/canvas.
void paintScene(QPainter& painter, const Scene& scene, double leastSeam = 0);

/// The outline of loops, in the scene's own coordinates (y up).
QPainterPath pathOf(const std::vector<Loop>& loops);

}  // namespace kiri::desktop
