// Short ways to write fields down.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "editor/base/field.h"

namespace kiri {

struct NumberRange {
  double least = 0;
  double most = 0;
  double step = 1;
  std::string unit = "";
};

inline Field numberField(std::string id, Phrase label, double value, NumberRange range,
                         Phrase help) {
  Field field;
  field.id = std::move(id);
  field.label = std::move(label);
  field.value = value;
  field.least = range.least;
  field.most = range.most;
  field.step = range.step;
  field.unit = std::move(range.unit);
  field.help = std::move(help);
  return field;
}

inline Field choiceField(std::string id, Phrase label, std::vector<Phrase> options, int chosen,
                         Phrase help) {
  Field field;
  field.id = std::move(id);
  field.label = std::move(label);
  field.kind = Field::Kind::Choice;
  field.options = std::move(options);
  field.value = chosen;
  field.help = std::move(help);
  return field;
}

inline Field buttonField(std::string id, Phrase label, Phrase help) {
  Field field;
  field.id = std::move(id);
  field.label = std::move(label);
  field.kind = Field::Kind::Button;
  field.help = std::move(help);
  return field;
}

inline Field switchField(std::string id, Phrase label, bool isOn, Phrase help) {
  Field field;
  field.id = std::move(id);
  field.label = std::move(label);
  field.kind = Field::Kind::Switch;
  field.value = isOn ? 1 : 0;
  field.help = std::move(help);
  return field;
}

inline Field textField(std::string id, Phrase label, std::string text, Phrase help) {
  Field field;
  field.id = std::move(id);
  field.label = std::move(label);
  field.kind = Field::Kind::Text;
  field.text = std::move(text);
  field.help = std::move(help);
  return field;
}

/// A number that is told, not set.
inline Field shownNumber(std::string id, Phrase label, double value, std::string unit) {
  Field field;
  field.id = std::move(id);
  field.label = std::move(label);
  field.value = value;
  field.least = field.most = value;
  field.unit = std::move(unit);
  field.isEnabled = false;
  return field;
}

}  // namespace kiri
