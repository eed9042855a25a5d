// Writing .kiri model files (docs/formats/kiri.md).
// SPDX-License-Identifier: MIT
#include "io/kiri_writer.h"

#include "io/json_fields.h"
#include "io/json_tree.h"
#include "io/kiri_reader.h"
#include "io/sheet_json.h"
#include "io/steps_json.h"

namespace kiri {

std::string writeKiri(const Model& model) {
  JsonValue out = JsonValue::object();
  out.add("format", JsonValue::ofText("kiri"));
  out.add("version", JsonValue::ofNumber(kKiriVersion));
  if (!model.title.empty()) out.add("title", JsonValue::ofText(model.title));
  if (!model.notes.empty()) out.add("notes", JsonValue::ofText(model.notes));
  if (model.opening == Sequence::Together) out.add("opens", JsonValue::ofText("together"));
  out.add("sheet", writeSheet(model.sheet));
  out.add("paper", writePaper(model));
  JsonValue& steps = out.add("steps", JsonValue::array());
  steps.items.reserve(model.steps.size());
  for (const Step& step : model.steps) steps.items.push_back(writeStep(step));
  mergeUnknown(out, model.unknown);
  // The document and its list of steps are broken into lines always; a short step stands on one
  // line.
  constexpr std::size_t kDocument = 1;
  return layOut(out, kDocument);
}

}  // namespace kiri
