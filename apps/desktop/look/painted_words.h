// Words in a narrow box, as on cards.
// SPDX-License-Identifier: MIT
#pragma once

#include <QPainter>
#include <QRectF>
#include <QString>

namespace kiri::desktop {

/// In the middle of the box, from its top, in so many lines at most, the last cut short where it
/// must be. Returns the height that the lines take.
double paintWords(QPainter& painter, const QRectF& box, const QString& text, int lines);

}  // namespace kiri::desktop
