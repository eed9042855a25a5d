// What FOLD files are made of, for all who write them.
// SPDX-License-Identifier: MIT
#include "io/fold_json.h"

#include <utility>

namespace kiri {

JsonValue jsonPair(JsonValue a, JsonValue b) {
  JsonValue out = JsonValue::array();
  out.items.reserve(2);
  out.items.push_back(std::move(a));
  out.items.push_back(std::move(b));
  return out;
}

JsonValue jsonTexts(const std::vector<std::string>& texts) {
  JsonValue out = JsonValue::array();
  for (const std::string& text : texts) out.items.push_back(JsonValue::ofText(text));
  return out;
}

void addJsonText(JsonValue& out, const char* name, const std::string& text) {
  if (!text.empty()) out.add(name, JsonValue::ofText(text));
}

JsonValue foldAttributes(const char* dimension, bool isConvex, bool hasCuts, bool hasJoins) {
  return jsonTexts({dimension, "manifold", "orientable",
                    isConvex ? "convexFaces" : "nonConvexFaces", hasCuts ? "cuts" : "noCuts",
                    hasJoins ? "joins" : "noJoins"});
}

}  // namespace kiri
