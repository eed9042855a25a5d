// A gallery: which models are shown, in which groups and order (docs/formats/gallery.md).
// SPDX-License-Identifier: MIT
#include "io/gallery.h"

#include <map>
#include <optional>
#include <utility>

#include "io/format_header.h"
#include "io/json_fields.h"

namespace kiri {

namespace {

constexpr std::string_view kModelEnding = ".kiri";

/// Which group holds a model.
using Places = std::map<std::string, std::string>;

bool isModelName(std::string_view name) {
  return name.size() > kModelEnding.size() &&
         name.substr(name.size() - kModelEnding.size()) == kModelEnding;
}

void readModel(const Field& field, GalleryGroup& group, Places& places) {
  const std::string name = field.text();
  if (!field.isText()) return;
  if (name.find_first_of("/\\") != std::string::npos) {
    field.mistake("is " + jsonString(name) +
                  ", but models stand beside the gallery's file: write the name without a path");
  } else if (!isModelName(name)) {
    field.isNot("the name of a .kiri file");
  }
  const auto [place, isNew] = places.emplace(name, group.title);
  if (!isNew) {
    field.mistake("is " + jsonString(name) + ", which stands in " + jsonString(place->second) +
                  " already; a model is shown once");
  }
  group.models.push_back(name);
}

GalleryGroup readGroup(const Field& field, Places& places) {
  Fields fields(field);
  GalleryGroup group;
  if (const auto title = fields.require("title", "what stands above the group")) {
    group.title = title->text();
  }
  group.notes = fields.text("notes");
  if (const auto models = fields.require("models", "names of .kiri files, [\"ship.kiri\", ...]")) {
    if (!models->isArray()) models->isNot("a list of names [\"ship.kiri\", ...]");
    for (std::size_t i = 0; i < models->size(); ++i) readModel(models->item(i), group, places);
  }
  fields.finish();
  return group;
}

void readGroups(const Field& field, Gallery& gallery) {
  if (!field.isArray()) {
    field.isNot("a list of groups [{\"title\": ..., \"models\": [...]}, ...]");
    return;
  }
  Places places;
  for (std::size_t i = 0; i < field.size() && field.findings().isGood(); ++i) {
    GalleryGroup group = readGroup(field.item(i), places);
    if (!group.models.empty()) gallery.groups.push_back(std::move(group));
  }
}

}  // namespace

Result<Gallery> readGallery(std::string_view text, std::string_view fileName) {
  const Result<JsonValue> json = parseJson(text, fileName);
  if (!json) return json.error();
  Findings findings{std::string(fileName)};
  const Field top(*json, "", findings);
  if (!top.isObject()) {
    findings.mistake(*json, "a gallery is one JSON object { \"format\": \"kiri gallery\", ... }");
    return *findings.error();
  }
  Fields fields(top);
  Gallery gallery;
  if (!readFormatHeader(fields, "a gallery", "kiri gallery", kGalleryVersion)) {
    return *findings.error();
  }
  gallery.title = fields.text("title");
  if (const auto groups = fields.require("groups", "what is shown, group by group")) {
    readGroups(*groups, gallery);
  }
  fields.finish();
  if (!findings.isGood()) return *findings.error();
  gallery.warnings = findings.warnings();
  return gallery;
}

}  // namespace kiri
