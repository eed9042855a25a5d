// Sets of keys for people who come from other programs, and where two actions want the same key.
// SPDX-License-Identifier: MIT
#pragma once

#include <QKeySequence>
#include <QList>
#include <QMap>
#include <QString>
#include <QStringList>

namespace kiri::desktop {

using Keys = QList<QKeySequence>;

/// Ready-made sets for people who come from other programs.
enum class KeyPreset { KiriSim, Oriedita, Orimath };
/// What differs from the actions' own keys, by the names of the actions.
QMap<QString, Keys> keysOfPreset(KeyPreset preset);

/// For each action (by name) whose keys are also those of others, the names of the others. A key
/// that is the beginning of another one clashes too.
QMap<QString, QStringList> clashesIn(const QMap<QString, Keys>& keys);

}  // namespace kiri::desktop
