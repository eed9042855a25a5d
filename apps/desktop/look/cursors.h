// The pointers of the hand.
// SPDX-License-Identifier: MIT
#pragma once

#include "editor/base/events.h"

class QWidget;

namespace kiri::desktop {

/// Gives the widget the pointer of that shape.
void showCursor(QWidget& widget, CursorShape shape);

}  // namespace kiri::desktop
