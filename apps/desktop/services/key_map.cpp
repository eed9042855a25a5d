// Sets of keys, and where two actions want the same key.
// SPDX-License-Identifier: MIT
#include "apps/desktop/services/key_map.h"

#include <cstddef>
#include <iterator>

namespace kiri::desktop {

namespace {

bool doClash(const QKeySequence& a, const QKeySequence& b) {
  if (a.isEmpty() || b.isEmpty()) return false;
  return a.matches(b) != QKeySequence::NoMatch || b.matches(a) != QKeySequence::NoMatch;
}

bool doClash(const Keys& a, const Keys& b) {
  for (const QKeySequence& one : a) {
    for (const QKeySequence& other : b) {
      if (doClash(one, other)) return true;
    }
  }
  return false;
}

struct PresetKey {
  const char* action;
  const char* keys;
};

// Oriedita: D draws, E extends, Ctrl+F looks at the other side.
constexpr PresetKey kOriedita[] = {{"line", "D"},        {"add-edge", "E"},
                                   {"mend", "Shift+T"},  {"redo", "Ctrl+Shift+Z; Ctrl+Y"},
                                   {"save-as", "Alt+S"}, {"view-back", "Ctrl+F"}};
// Orimath turns and unfolds with Ctrl.
constexpr PresetKey kOrimath[] = {{"turn-over", "Ctrl+Up"},
                                  {"turn-over-down", "Ctrl+Down"},
                                  {"unfold-all", "Ctrl+E"},
                                  {"export", "Ctrl+Shift+E"},
                                  {"fit", "Ctrl+0"}};

template <std::size_t N>
QMap<QString, Keys> keysIn(const PresetKey (&preset)[N]) {
  QMap<QString, Keys> keys;
  for (const PresetKey& entry : preset)
    keys.insert(entry.action, QKeySequence::listFromString(entry.keys));
  return keys;
}

}  // namespace

QMap<QString, Keys> keysOfPreset(KeyPreset preset) {
  if (preset == KeyPreset::Oriedita) return keysIn(kOriedita);
  if (preset == KeyPreset::Orimath) return keysIn(kOrimath);
  return {};
}

QMap<QString, QStringList> clashesIn(const QMap<QString, Keys>& keys) {
  QMap<QString, QStringList> clashes;
  for (auto one = keys.begin(); one != keys.end(); ++one) {
    for (auto other = std::next(one); other != keys.end(); ++other) {
      if (!doClash(one.value(), other.value())) continue;
      clashes[one.key()].append(other.key());
      clashes[other.key()].append(one.key());
    }
  }
  return clashes;
}

}  // namespace kiri::desktop
