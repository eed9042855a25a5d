// The language of the window.
// SPDX-License-Identifier: MIT
#pragma once

#include <QString>
#include <QStringList>

namespace kiri::desktop {

/// Languages that there are translations for, by their codes; the first is that of the sources.
QStringList languages();

/// From now on the program speaks this language ("de"); empty: that of the desktop, as far as it is
/// one of `languages()`. Call when the application object is there and before any window is made; a
/// second call takes the first one back. Returns the code of the language that is spoken.
QString speak(const QString& code);

}  // namespace kiri::desktop
