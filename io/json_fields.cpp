// Typed reading of JSON objects: every mistake gets a sentence with its place, every unknown field
// is kept. SPDX-License-Identifier: MIT
#include "io/json_fields.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <utility>

namespace kiri {

namespace {

using Kind = JsonValue::Kind;

std::string kindName(const JsonValue& value) {
  switch (value.kind) {
    case Kind::Null:
      return "null";
    case Kind::Bool:
      return value.boolean ? "true" : "false";
    case Kind::Number:
      return value.text;
    case Kind::String: {
      constexpr std::size_t kLong = 40;
      return value.text.size() <= kLong ? jsonString(value.text) : "a long text";
    }
    case Kind::Array:
      return value.items.empty() ? "an empty list"
             : value.items.size() == 1
                 ? "a list with 1 item"
                 : "a list with " + std::to_string(value.items.size()) + " items";
    case Kind::Object:
      return "an object";
  }
  return "";
}

/// "line/paper/0" as people write it: line.paper[0].
std::string shown(const std::string& path) {
  std::string out;
  std::size_t at = 0;
  while (at <= path.size()) {
    const std::size_t end = std::min(path.find('/', at), path.size());
    const std::string name = path.substr(at, end - at);
    const bool isIndex = !name.empty() && std::all_of(name.begin(), name.end(),
                                                      [](char c) { return c >= '0' && c <= '9'; });
    if (isIndex && !out.empty()) {
      out += "[" + name + "]";
    } else {
      out += (out.empty() ? "" : ".") + name;
    }
    at = end + 1;
  }
  return "\"" + out + "\"";
}

std::string escaped(std::string_view name) {
  std::string out;
  for (const char c : name) {
    if (c == '~') {
      out += "~0";
    } else if (c == '/') {
      out += "~1";
    } else {
      out += c;
    }
  }
  return out;
}

std::string joined(const std::string& path, std::string_view name) {
  return path.empty() ? escaped(name) : path + "/" + escaped(name);
}

std::string unescaped(std::string_view name) {
  std::string out;
  for (std::size_t i = 0; i < name.size(); ++i) {
    if (name[i] == '~' && i + 1 < name.size() && (name[i + 1] == '0' || name[i + 1] == '1')) {
      out += name[++i] == '0' ? '~' : '/';
    } else {
      out += name[i];
    }
  }
  return out;
}

std::string lowered(std::string_view text) {
  std::string out(text);
  for (char& c : out) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return out;
}

/// Insertions, deletions, replacements and swaps of neighbours that lead from `a` to `b`.
std::size_t editDistance(const std::string& a, const std::string& b) {
  std::vector<std::vector<std::size_t>> d(a.size() + 1, std::vector<std::size_t>(b.size() + 1));
  for (std::size_t i = 0; i <= a.size(); ++i) {
    for (std::size_t j = 0; j <= b.size(); ++j) {
      if (i == 0 || j == 0) {
        d[i][j] = i + j;
        continue;
      }
      const std::size_t replace = d[i - 1][j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
      d[i][j] = std::min({replace, d[i - 1][j] + 1, d[i][j - 1] + 1});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1]) {
        d[i][j] = std::min(d[i][j], d[i - 2][j - 2] + 1);
      }
    }
  }
  return d[a.size()][b.size()];
}

std::string listed(const std::vector<std::string>& choices) {
  std::string out;
  for (std::size_t i = 0; i < choices.size(); ++i) {
    if (i > 0) out += i + 1 == choices.size() ? " or " : ", ";
    out += jsonString(choices[i]);
  }
  return out;
}

JsonValue* stepInto(JsonValue& value, const std::string& name) {
  if (value.is(Kind::Object)) return value.find(name);
  if (!value.is(Kind::Array) || name.empty() || name.size() > 9) return nullptr;
  std::size_t index = 0;
  for (const char c : name) {
    if (c < '0' || c > '9') return nullptr;
    index = index * 10 + static_cast<std::size_t>(c - '0');
  }
  return index < value.items.size() ? &value.items[index] : nullptr;
}

}  // namespace

std::string Findings::sentenceAt(const JsonValue& at, const std::string& sentence) const {
  std::string out = file_;
  if (at.line > 0) out += ":" + std::to_string(at.line) + ":" + std::to_string(at.column);
  out += ": ";
  if (!where_.empty()) out += where_ + ": ";
  return out + sentence;
}

void Findings::mistake(const JsonValue& at, const std::string& sentence) {
  if (!error_) error_ = Error{ErrorCode::BadFile, sentenceAt(at, sentence)};
}

void Findings::warning(const JsonValue& at, const std::string& sentence) {
  constexpr std::size_t kEnough = 100;
  if (warnings_.size() < kEnough) warnings_.push_back(sentenceAt(at, sentence));
}

void Findings::unknown(const std::string& path, const JsonValue& value) {
  unknown_.add(path, value);
}

std::string Findings::takeUnknown() {
  if (unknown_.members.empty()) return "";
  std::string text = compactText(unknown_);
  unknown_ = JsonValue::object();
  return text;
}

void mergeUnknown(JsonValue& value, const std::string& unknownText) {
  if (unknownText.empty()) return;
  const Result<JsonValue> kept = parseJson(unknownText, "unknown fields");
  if (!kept.isOk()) return;
  for (const JsonMember& member : kept->members) {
    JsonValue* place = &value;
    std::size_t at = 0;
    for (std::size_t slash = member.name.find('/'); place && slash != std::string::npos;
         slash = member.name.find('/', at)) {
      place = stepInto(*place, unescaped(member.name.substr(at, slash - at)));
      at = slash + 1;
    }
    const std::string name = unescaped(member.name.substr(at));
    if (place && place->is(Kind::Object) && !place->find(name)) place->add(name, member.value);
  }
}

std::string nearestName(std::string_view written, const std::vector<std::string>& known) {
  constexpr std::size_t kLongest = 40;
  if (written.size() > kLongest) return "";
  const std::string word = lowered(written);
  std::string best;
  std::size_t bestDistance = 3;
  for (const std::string& name : known) {
    const std::size_t allowed = name.size() <= 3 ? 1 : 2;
    const std::size_t distance = editDistance(word, lowered(name));
    if (distance <= allowed && distance < bestDistance) {
      best = name;
      bestDistance = distance;
    }
  }
  return best;
}

bool Field::looksLikePoint() const {
  return isArray() && size() > 0 && json_->items.front().is(Kind::Number);
}

Field Field::item(std::size_t i) const {
  return {json_->items[i], path_ + "/" + std::to_string(i), *findings_};
}

void Field::mistake(const std::string& sentence) const {
  findings_->mistake(*json_, (path_.empty() ? "this" : shown(path_)) + " " + sentence);
}

void Field::isNot(const std::string& wanted) const {
  mistake("must be " + wanted + ", but is " + kindName(*json_));
}

double Field::number(const Limits& limits) const {
  if (!json_->is(Kind::Number)) {
    isNot("a number");
    return 0;
  }
  const double value = json_->number;
  const bool isLow = value < limits.low || (limits.isOpenBelow && value <= limits.low);
  if (isLow || value > limits.high) {
    const bool isBounded = limits.high < std::numeric_limits<double>::max();
    const std::string low = numberText(limits.low);
    const std::string high = numberText(limits.high);
    const std::string range = limits.isOpenBelow ? "must be above " + low + " and at most " + high
                              : isBounded        ? "must lie between " + low + " and " + high
                                                 : "must be at least " + low;
    mistake("is " + json_->text + ", " + range);
    return limits.high < 0 || limits.low > 0 ? limits.low : 0;
  }
  return value;
}

int Field::count() const {
  constexpr double kMost = 1'000'000;
  const double value = number({1, kMost, false});
  if (std::floor(value) != value) isNot("a whole number");
  return std::max(1, static_cast<int>(value));
}

bool Field::flag() const {
  if (!json_->is(Kind::Bool)) isNot("true or false");
  return json_->boolean;
}

std::string Field::text() const {
  if (!isText()) {
    isNot("a text in quotes");
    return "";
  }
  return json_->text;
}

Vec2 Field::point() const {
  if (!isArray()) {
    isNot("a point [x, y]");
    return {};
  }
  if (size() != 2) {
    mistake("must be a point [x, y] of two numbers, but has " + std::to_string(size()));
    return {};
  }
  const Limits limits{-kLargestLength, kLargestLength, false};
  return {item(0).number(limits), item(1).number(limits)};
}

std::vector<Vec2> Field::points(std::size_t atLeast) const {
  std::vector<Vec2> out;
  if (!isArray()) {
    isNot("a list of points [[x, y], ...]");
    return out;
  }
  if (looksLikePoint()) {
    mistake(
        "must be a list of points [[x, y], ...], but is a list of numbers; put each point in "
        "brackets");
    return out;
  }
  if (size() < atLeast) {
    mistake("has " + std::to_string(size()) + (size() == 1 ? " point" : " points") + ", at least " +
            std::to_string(atLeast) + " are needed");
  }
  out.reserve(size());
  for (std::size_t i = 0; i < size(); ++i) out.push_back(item(i).point());
  return out;
}

std::size_t Field::oneOf(const std::vector<std::string>& choices) const {
  if (isText()) {
    const auto at = std::find(choices.begin(), choices.end(), json_->text);
    if (at != choices.end()) return static_cast<std::size_t>(at - choices.begin());
    const std::string meant = nearestName(json_->text, choices);
    if (!meant.empty()) {
      mistake("is " + kindName(*json_) + "; did you mean " + jsonString(meant) + "?");
      return 0;
    }
  }
  isNot(listed(choices));
  return 0;
}

Fields::Fields(const Field& object) : object_(object) {
  if (!object.isObject()) object.isNot("an object in braces { }");
}

void Fields::markKnown(std::string_view name) { known_.emplace_back(name); }

std::optional<Field> Fields::find(std::string_view name) {
  markKnown(name);
  const JsonValue* value = object_.json().find(name);
  if (value == nullptr) return std::nullopt;
  return Field(*value, joined(object_.path(), name), object_.findings());
}

std::string Fields::missing(std::string_view name, std::string_view meaning) const {
  std::vector<std::string> candidates;
  for (const JsonMember& member : object_.json().members) {
    if (std::find(known_.begin(), known_.end(), member.name) == known_.end()) {
      candidates.push_back(member.name);
    }
  }
  std::string sentence =
      shown(joined(object_.path(), name)) + " is missing: " + std::string(meaning);
  const std::string meant = nearestName(name, candidates);
  if (!meant.empty()) sentence += "; did you mean it by " + jsonString(meant) + "?";
  return sentence;
}

std::optional<Field> Fields::require(std::string_view name, std::string_view meaning) {
  std::optional<Field> field = find(name);
  if (!field && object_.isObject()) {
    object_.findings().mistake(object_.json(), missing(name, meaning));
  }
  return field;
}

std::optional<Field> Fields::requireOneOf(const std::vector<std::string>& names,
                                          std::string_view meaning) {
  std::optional<Field> found;
  for (const std::string& name : names) {
    std::optional<Field> field = find(name);
    if (!field) continue;
    if (found) {
      object_.mistake("has several of " + listed(names) + "; keep one");
      return found;
    }
    found = field;
  }
  if (!found && object_.isObject()) {
    object_.mistake("needs " + listed(names) + ": " + std::string(meaning));
  }
  return found;
}

double Fields::number(std::string_view name, double fallback, const Limits& limits) {
  const std::optional<Field> field = find(name);
  return field ? field->number(limits) : fallback;
}

bool Fields::flag(std::string_view name, bool fallback) {
  const std::optional<Field> field = find(name);
  return field ? field->flag() : fallback;
}

std::string Fields::text(std::string_view name) {
  const std::optional<Field> field = find(name);
  return field ? field->text() : "";
}

std::size_t Fields::oneOf(std::string_view name, const std::vector<std::string>& choices,
                          std::size_t fallback) {
  const std::optional<Field> field = find(name);
  return field ? field->oneOf(choices) : fallback;
}

void Fields::finish() {
  std::vector<std::string> absent;
  for (const std::string& name : known_) {
    if (object_.json().find(name) == nullptr) absent.push_back(name);
  }
  for (const JsonMember& member : object_.json().members) {
    if (std::find(known_.begin(), known_.end(), member.name) != known_.end()) continue;
    const std::string path = joined(object_.path(), member.name);
    const std::string meant = nearestName(member.name, absent);
    const bool isKept = object_.findings().unknownFields() == UnknownFields::AreKept;
    if (!meant.empty() || !isKept) {
      object_.findings().warning(
          member.value,
          shown(path) + " is not a field that is known here" +
              (meant.empty() ? "; it" : "; did you mean " + jsonString(meant) + "? It") +
              (isKept ? " is kept, but does nothing" : " does nothing"));
    }
    object_.findings().unknown(path, member.value);
  }
}

}  // namespace kiri
