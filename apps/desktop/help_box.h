// The help: tools, keys and how to move about, on one page.
// SPDX-License-Identifier: MIT
#pragma once

#include <QWidget>

#include "apps/desktop/actions.h"

namespace kiri::desktop {

/// Opens the page before the window; it does not keep the window waiting.
void openHelp(QWidget& window, const Actions& actions);

}  // namespace kiri::desktop
