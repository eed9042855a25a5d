// Icons by name, in the colours of the theme, sharp at every size.
// SPDX-License-Identifier: MIT
#pragma once

#include <QIcon>
#include <QString>

namespace kiri::desktop {

/// The icon of look/icons/NAME.svg. Its strokes in `currentColor` take the theme's colour when they
/// are painted, so icons follow a change of theme by themselves. An icon that is not there shows
/// the first letter of its name.
QIcon icon(const QString& name);

/// True when there is a drawing of that name.
bool hasIcon(const QString& name);

}  // namespace kiri::desktop
