// The style sheet of the window: calm tool buttons, panels and sliders.
// SPDX-License-Identifier: MIT
#pragma once

#include <QString>

namespace kiri::desktop {

struct Theme;

QString styleSheetOf(const Theme& theme);

}  // namespace kiri::desktop
