// Reading .kiri model files (docs/formats/kiri.md).
// SPDX-License-Identifier: MIT
#include "io/kiri_reader.h"

#include <map>
#include <optional>
#include <utility>

#include "io/format_header.h"
#include "io/json_fields.h"
#include "io/sheet_json.h"
#include "io/steps_json.h"

namespace kiri {

namespace {

/// The name of the fold line that a step makes; empty when it makes none.
std::string foldNameOf(const Step& step, std::size_t number) {
  const auto* fold = std::get_if<FoldStep>(&step.action);
  if (fold == nullptr) return "";
  return fold->name.empty() ? "fold " + std::to_string(number) : fold->name;
}

void readSteps(const Field& field, Model& model) {
  if (!field.isArray()) {
    field.isNot("a list of steps [{\"do\": ...}, ...]");
    return;
  }
  std::map<std::string, std::size_t> names;
  model.steps.reserve(field.size());
  for (std::size_t i = 0; i < field.size() && field.findings().isGood(); ++i) {
    const Field item(field.item(i).json(), "", field.findings());
    model.steps.push_back(readStep(item, i + 1));
    const std::string name = foldNameOf(model.steps.back(), i + 1);
    if (name.empty()) continue;
    const auto [entry, isNew] = names.emplace(name, i + 1);
    if (!isNew) {
      field.findings().mistake(item.json(), "step " + std::to_string(entry->second) +
                                                " has a fold named " + jsonString(name) +
                                                " already; give one of the two another name");
    }
  }
}

}  // namespace

Result<LoadedModel> readKiri(std::string_view text, std::string_view fileName) {
  const Result<JsonValue> json = parseJson(text, fileName);
  if (!json.isOk()) return json.error();

  Findings findings{std::string(fileName)};
  const Field top(*json, "", findings);
  if (!top.isObject()) {
    findings.mistake(*json, "a model file is one JSON object { \"format\": \"kiri\", ... }");
    return *findings.error();
  }
  Fields fields(top);
  LoadedModel loaded;
  Model& model = loaded.model;
  if (!readFormatHeader(fields, "a model file", "kiri", kKiriVersion)) return *findings.error();
  model.title = fields.text("title");
  model.notes = fields.text("notes");
  if (fields.oneOf("opens", {"in order", "together"}, 0) == 1) model.opening = Sequence::Together;
  const std::optional<Field> sheet =
      fields.require("sheet", "the paper, such as {\"shape\": \"square\", \"side\": 150}");
  if (const std::optional<Field> paper = fields.find("paper")) readPaper(*paper, model);
  const std::optional<Field> steps =
      fields.require("steps", "the list of steps, [] when there are none");
  fields.finish();
  model.unknown = findings.takeUnknown();
  if (sheet && findings.isGood()) {
    findings.enter("sheet");
    model.sheet = readSheet(Field(sheet->json(), "", findings));
  }
  if (steps && findings.isGood()) {
    findings.enter("");
    readSteps(*steps, model);
  }
  if (!findings.isGood()) return *findings.error();
  loaded.warnings = findings.warnings();
  return loaded;
}

}  // namespace kiri
