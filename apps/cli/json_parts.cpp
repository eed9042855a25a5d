// Counts, points and lists of texts as JSON.
// SPDX-License-Identifier: MIT
#include "apps/cli/json_parts.h"

namespace kiri::cli {

JsonValue countJson(std::size_t count) { return JsonValue::ofNumber(static_cast<double>(count)); }

JsonValue pointJson(Vec2 point) {
  JsonValue out = JsonValue::array();
  out.items = {JsonValue::ofNumber(point.x), JsonValue::ofNumber(point.y)};
  return out;
}

JsonValue pointJson(Vec3 point) {
  JsonValue out = JsonValue::array();
  out.items = {JsonValue::ofNumber(point.x), JsonValue::ofNumber(point.y),
               JsonValue::ofNumber(point.z)};
  return out;
}

JsonValue textsJson(const std::vector<std::string>& texts) {
  JsonValue out = JsonValue::array();
  for (const std::string& text : texts) out.items.push_back(JsonValue::ofText(text));
  return out;
}

}  // namespace kiri::cli
