// Leaf recipes as files (docs/formats/leaf.md).
// SPDX-License-Identifier: MIT
#include "io/leaf_recipe_reader.h"

#include <cmath>
#include <optional>
#include <utility>

#include "io/json_fields.h"
#include "io/sheet_json.h"

namespace kiri {
namespace {

constexpr double kHalfTurn = 180;
/// Lengths are parts of the mid-vein's; a ray may be longer, within reason.
constexpr double kLongestRay = 10;
constexpr double kMostLobes = 1000;

LeafRay readRay(const Field& field) {
  Fields fields(field);
  LeafRay ray;
  if (const auto angle = fields.require("angle", "degrees from the mid-vein")) {
    ray.angle = angle->number({0, kHalfTurn, true});
  }
  if (const auto length = fields.require("length", "as part of the mid-vein's length")) {
    const double number = length->number({0, kLargestLength, true});
    if (number > kLongestRay) {
      length->mistake("is " + length->json().text +
                      ", but lengths are parts of the mid-vein's: 0.5 is half of it; divide by its "
                      "millimetres");
    }
    ray.length = number;
  }
  fields.finish();
  return ray;
}

std::vector<LeafRay> readRays(const std::optional<Field>& field) {
  std::vector<LeafRay> rays;
  if (!field) return rays;
  if (!field->isArray()) {
    field->isNot("a list of rays [{\"angle\": 42, \"length\": 0.88}, ...]");
    return rays;
  }
  for (std::size_t i = 0; i < field->size(); ++i) rays.push_back(readRay(field->item(i)));
  return rays;
}

SecondaryLobes readPair(const Field& field) {
  Fields fields(field);
  SecondaryLobes lobes;
  for (const char* name : {"side", "sides"}) {
    if (const auto side = fields.find(name)) {
      side->mistake(
          "cannot be chosen: secondary lobes come in pairs, one on either side of a vein, for "
          "only mirror images fold flat while the vein is straight; leave it out");
    }
  }
  if (const auto lobe = fields.find("lobe")) {
    const double number = lobe->number({0, kMostLobes, false});
    if (std::floor(number) != number) lobe->isNot("a whole number");
    lobes.lobe = static_cast<std::size_t>(number);
  }
  if (const auto at = fields.require("at", "where they leave the vein of their lobe, 0 to 1")) {
    lobes.at = at->number({0, 1, true});
  }
  if (const auto antiVein = fields.require("antiVein", "from the junction to the sinus")) {
    lobes.antiVein = readRay(*antiVein);
  }
  if (const auto vein = fields.require("vein", "from the junction to the tip")) {
    lobes.vein = readRay(*vein);
  }
  lobes.isTorn = fields.flag("torn", false);
  fields.finish();
  return lobes;
}

/// One pair, or a list of them.
std::vector<SecondaryLobes> readSecondary(const Field& field) {
  if (!field.isArray()) return {readPair(field)};
  std::vector<SecondaryLobes> pairs;
  for (std::size_t i = 0; i < field.size(); ++i) pairs.push_back(readPair(field.item(i)));
  return pairs;
}

void readBody(Fields& fields, LeafRecipe& recipe) {
  recipe.title = fields.text("title");
  recipe.notes = fields.text("notes");
  recipe.midVein = fields.number("midVein", recipe.midVein, {0, kLargestLength, true});
  if (fields.oneOf("petiole", {"inside", "edge"}, 0) == 1) {
    recipe.petiole = Petiole::OnEdge;
    recipe.base.angle = kHalfTurn / 2;
  }
  recipe.veins =
      readRays(fields.require("veins", "the veins beside the mid-vein, outward; [] for none"));
  recipe.antiVeins =
      readRays(fields.require("antiVeins", "one before each vein, outward; [] for none"));
  if (const auto base = fields.require("base", "the basal edge, {\"angle\": .., \"length\": ..}")) {
    recipe.base = readRay(*base);
  }
  recipe.margin = readRays(fields.find("margin"));
  if (const auto secondary = fields.find("secondary")) {
    recipe.secondary = readSecondary(*secondary);
  }
  if (const auto paper = fields.find("paper")) {
    Model model;
    model.front = recipe.front;
    model.back = recipe.back;
    readPaper(*paper, model);
    recipe.front = model.front;
    recipe.back = model.back;
  }
}

}  // namespace

Result<LoadedRecipe> readLeafRecipe(std::string_view text, std::string_view fileName) {
  const Result<JsonValue> json = parseJson(text, fileName);
  if (!json) return json.error();
  Findings findings{std::string(fileName), UnknownFields::AreLost};
  const Field top(*json, "", findings);
  if (!top.isObject()) {
    findings.mistake(*json, "a leaf recipe is one JSON object { \"format\": \"kiri leaf\", ... }");
    return *findings.error();
  }
  Fields fields(top);
  LoadedRecipe loaded;
  const auto format =
      fields.require("format", "a leaf recipe starts with \"format\": \"kiri leaf\"");
  if (format && format->text() != "kiri leaf") {
    format->isNot("\"kiri leaf\"; this is another kind of file");
  }
  if (findings.isGood()) readBody(fields, loaded.recipe);
  fields.finish();
  if (!findings.isGood()) return *findings.error();
  loaded.warnings = findings.warnings();
  return loaded;
}

}  // namespace kiri
