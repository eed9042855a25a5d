// Numbers and choices that a person can set: of a tool at work, or of a step that is done.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "editor/base/phrase.h"

namespace kiri {

/// One thing to set. A window shows it as a box for a number, a row of choices, a switch, a line of
/// text or a button; what it means is known to whoever gave it, by `id`.
struct Field {
  enum class Kind { Number, Choice, Switch, Text, Button };

  std::string id;  ///< "angle", "type", "layers"...
  Phrase label;
  Kind kind = Kind::Number;

  double value = 0;  ///< number; choice: index of the chosen option; switch: 0 or 1
  double least = 0;  ///< number: limits and the step of its arrows
  double most = 0;
  double step = 1;
  std::string unit;             ///< number: "mm", "°" or nothing
  std::vector<Phrase> options;  ///< choice
  std::string text;             ///< text
  bool hasLines = false;        ///< text: of several lines
  bool isEnabled = true;
  Phrase help;  ///< for a tooltip
};

/// What a person set a field to.
struct FieldValue {
  double number = 0;
  std::string text;
};

}  // namespace kiri
