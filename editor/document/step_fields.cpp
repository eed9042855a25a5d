// SPDX-License-Identifier: MIT
#include "editor/document/step_fields.h"

#include <algorithm>
#include <cmath>

#include "core/base/text.h"
#include "editor/document/step_slots.h"

namespace kiri {
namespace {

Error refused(const Field& field, const std::string& allowed) {
  return {ErrorCode::BadValue, "\"" + inEnglish(field.label) + "\" takes " + allowed, {}};
}

bool isWhole(double number) { return number == std::floor(number); }

Status checkNumber(const Field& field, double number) {
  if (number >= field.least && number <= field.most) return std::monostate{};
  const std::string unit = field.unit.empty() ? "" : (field.unit == "°" ? "°" : " " + field.unit);
  return refused(field,
                 text(field.least) + " to " + text(field.most) + unit + ", not " + text(number));
}

Status checkChoice(const Field& field, double number) {
  const bool isOne = number >= 0 && number <= field.most && isWhole(number);
  if (isOne) return std::monostate{};
  std::string names;
  for (const Phrase& option : field.options)
    names += (names.empty() ? "\"" : ", \"") + inEnglish(option) + "\"";
  return refused(field, "one of " + names);
}

/// Notes may have lines; whatever else is typed is one line of text.
Status checkText(const Field& field, const std::string& text) {
  const bool isPlain = std::all_of(text.begin(), text.end(), [hasLines = field.hasLines](char c) {
    const auto code = static_cast<unsigned char>(c);
    return (code >= ' ' && code != 127) || (hasLines && (c == '\n' || c == '\t'));
  });
  if (!isPlain) return refused(field, field.hasLines ? "lines of text" : "one line of text");
  if (field.id == "line" && text.empty()) return refused(field, "the name of a fold");
  return std::monostate{};
}

Status check(const Field& field, const FieldValue& value) {
  switch (field.kind) {
    case Field::Kind::Number:
      return checkNumber(field, value.number);
    case Field::Kind::Choice:
      return checkChoice(field, value.number);
    case Field::Kind::Text:
      return checkText(field, value.text);
    case Field::Kind::Switch:
    case Field::Kind::Button:
      break;
  }
  return std::monostate{};
}

}  // namespace

std::vector<Field> fieldsOf(const Step& step) {
  std::vector<Field> fields;
  for (StepSlot& slot : slotsOf(step)) fields.push_back(std::move(slot.field));
  return fields;
}

Result<Step> withField(const Step& step, const std::string& id, const FieldValue& value) {
  const std::vector<StepSlot> slots = slotsOf(step);
  const auto slot = std::find_if(slots.begin(), slots.end(),
                                 [&id](const StepSlot& one) { return one.field.id == id; });
  if (slot == slots.end())
    return Error{ErrorCode::NotFound, "this step has nothing named \"" + id + "\" to set", {}};
  const Status checked = check(slot->field, value);
  if (!checked) return checked.error();
  Step changed = step;
  slot->set(changed, value);
  return changed;
}

}  // namespace kiri
