// The words of the window that belong to no class.
// SPDX-License-Identifier: MIT
#pragma once

#include <QCoreApplication>
#include <QString>

namespace kiri::desktop {

/// In the language of the person; the translators' tool finds them by this name.
inline QString tr(const char* text) { return QCoreApplication::translate("kiri::desktop", text); }

}  // namespace kiri::desktop
