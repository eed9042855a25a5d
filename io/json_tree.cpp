// A JSON document as a tree that remembers where in the text each value stood.
// SPDX-License-Identifier: MIT
#include "io/json_tree.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <utility>

#include "core/base/check.h"

namespace kiri {

JsonValue JsonValue::ofNumber(double value) {
  JsonValue v;
  v.kind = Kind::Number;
  v.number = value;
  v.text = numberText(value);
  return v;
}

JsonValue JsonValue::ofText(std::string value) {
  JsonValue v;
  v.kind = Kind::String;
  v.text = std::move(value);
  return v;
}

JsonValue JsonValue::ofBool(bool value) {
  JsonValue v;
  v.kind = Kind::Bool;
  v.boolean = value;
  return v;
}

JsonValue JsonValue::array() {
  JsonValue v;
  v.kind = Kind::Array;
  return v;
}

JsonValue JsonValue::object() {
  JsonValue v;
  v.kind = Kind::Object;
  return v;
}

const JsonValue* JsonValue::find(std::string_view name) const {
  for (const JsonMember& member : members) {
    if (member.name == name) return &member.value;
  }
  return nullptr;
}

JsonValue* JsonValue::find(std::string_view name) {
  return const_cast<JsonValue*>(std::as_const(*this).find(name));
}

JsonValue& JsonValue::add(std::string name, JsonValue value) {
  KIRI_CHECK(is(Kind::Object), "only an object has members");
  members.push_back({std::move(name), std::move(value)});
  return members.back().value;
}

namespace {

using Kind = JsonValue::Kind;

std::string placeText(std::string_view file, std::size_t line, std::size_t column) {
  return std::string(file) + ":" + std::to_string(line) + ":" + std::to_string(column) + ": ";
}

/// Follows the parser through the text, one token an event, to know where each value stands. It
/// relies on the parser for the grammar: every token that it is told of is well formed.
class TokenFollower {
 public:
  explicit TokenFollower(std::string_view text) : text_(text) {
    if (text_.substr(0, 3) == "\xEF\xBB\xBF") at_ = lineStart_ = 3;
  }

  std::uint32_t line() const { return tokenLine_; }
  std::uint32_t column() const { return tokenColumn_; }

  void next() {
    while (at_ < text_.size() && isBetween(text_[at_])) step();
    tokenLine_ = line_;
    tokenColumn_ = static_cast<std::uint32_t>(at_ - lineStart_ + 1);
    tokenStart_ = at_;
    if (at_ == text_.size()) return;
    if (text_[at_] == '"') {
      skipString();
    } else if (isBracket(text_[at_])) {
      step();
    } else {
      while (at_ < text_.size() && !isBetween(text_[at_]) && !isBracket(text_[at_])) step();
    }
  }

  std::string_view token() const { return text_.substr(tokenStart_, at_ - tokenStart_); }

 private:
  static bool isBetween(char c) {
    return c == ' ' || c == '\t' || c == '\n' || c == '\r' || c == ',' || c == ':';
  }
  static bool isBracket(char c) { return c == '{' || c == '}' || c == '[' || c == ']'; }

  void step() {
    if (text_[at_] == '\n') {
      ++line_;
      lineStart_ = at_ + 1;
    }
    ++at_;
  }

  void skipString() {
    step();
    while (at_ < text_.size() && text_[at_] != '"') {
      if (text_[at_] == '\\') step();
      if (at_ < text_.size()) step();
    }
    if (at_ < text_.size()) step();
  }

  std::string_view text_;
  std::size_t at_ = 0;
  std::size_t lineStart_ = 0;
  std::uint32_t line_ = 1;
  std::size_t tokenStart_ = 0;
  std::uint32_t tokenLine_ = 1;
  std::uint32_t tokenColumn_ = 1;
};

/// Turns the parser's complaint into what a person would say. Empty when the complaint has to do as
/// it is.
std::string hintFor(std::string_view complaint, std::string_view before) {
  const auto says = [&](const char* words) {
    return complaint.find(words) != std::string_view::npos;
  };
  while (!before.empty() && (before.back() == ' ' || before.back() == '\n' ||
                             before.back() == '\r' || before.back() == '\t')) {
    before.remove_suffix(1);
  }
  if (says("unexpected end of input"))
    return "the text ends too early; a bracket or quote is not closed";
  if (says("UTF-8")) return "the text is not UTF-8; save the file as UTF-8";
  if (says("control character")) {
    return "a text must end on the line on which it starts; close it with \", or write \\n for a "
           "break";
  }
  if (says("invalid literal; last read: ") && !before.empty() && before.back() == '/') {
    return "JSON has no comments; use a \"notes\" field";
  }
  if (says("missing closing quote")) return "a text is not closed; put \" after it";
  if (says("expected end of input"))
    return "there is more text after the end of the document; take it out";
  if (says("unexpected string literal; expected '}'") ||
      says("unexpected string literal; expected ']'") || says("unexpected '['; expected ']'") ||
      says("unexpected '{'; expected ']'") || says("unexpected number literal; expected ']'")) {
    return "a comma is missing before this";
  }
  if (says("unexpected ']'") || says("unexpected '}'")) {
    before.remove_suffix(before.empty() ? 0 : 1);
    while (!before.empty() && (before.back() == ' ' || before.back() == '\n' ||
                               before.back() == '\r' || before.back() == '\t')) {
      before.remove_suffix(1);
    }
    if (!before.empty() && before.back() == ',') {
      return "a comma stands before the closing bracket; take it out";
    }
  }
  if (says("while parsing object key")) return "a field name in quotes is expected here";
  if (says("while parsing object separator")) return "a colon is missing between name and value";
  if (says("invalid literal")) {
    return "this is no number, no text in quotes, and not true, false or null";
  }
  return "";
}

/// The part of the parser's message that says what is wrong, without its codes and places.
std::string bareComplaint(std::string_view message) {
  for (const std::string_view marker : {std::string_view("column "), std::string_view("] ")}) {
    const std::size_t at = message.find(marker);
    if (at == std::string_view::npos) continue;
    std::string_view rest = message.substr(at + marker.size());
    if (marker == "column ") {
      const std::size_t colon = rest.find(": ");
      if (colon == std::string_view::npos) continue;
      rest = rest.substr(colon + 2);
    }
    return std::string(rest);
  }
  return std::string(message);
}

/// Builds the tree from the parser's events.
class TreeBuilder {
 public:
  TreeBuilder(std::string_view text, std::string_view file, const JsonLimits& limits)
      : text_(text), file_(file), limits_(limits), follower_(text) {}

  bool null() { return put(Kind::Null) != nullptr; }
  bool boolean(bool value) {
    JsonValue* v = put(Kind::Bool);
    if (v != nullptr) v->boolean = value;
    return v != nullptr;
  }
  bool number_integer(std::int64_t value) { return putNumber(static_cast<double>(value)); }
  bool number_unsigned(std::uint64_t value) { return putNumber(static_cast<double>(value)); }
  bool number_float(double value, const std::string&) { return putNumber(value); }
  bool string(std::string& value) {
    JsonValue* v = put(Kind::String);
    if (v != nullptr) v->text = std::move(value);
    return v != nullptr;
  }
  bool binary(std::vector<std::uint8_t>&) { return false; }

  bool start_object(std::size_t) { return open(Kind::Object); }
  bool start_array(std::size_t) { return open(Kind::Array); }
  bool end_object() { return close(); }
  bool end_array() { return close(); }

  bool key(std::string& name) {
    follower_.next();
    if (!names_.back().insert(name).second) {
      return fail("the field " + jsonString(name) + " is there twice; keep one of the two");
    }
    key_ = std::move(name);
    return true;
  }

  bool parse_error(std::size_t position, const std::string&,
                   const nlohmann::detail::exception& problem) {
    const std::string complaint = bareComplaint(problem.what());
    const std::size_t end = std::min(position, text_.size());
    std::string hint = hintFor(complaint, text_.substr(0, end));
    if (complaint.find("number overflow") != std::string::npos) {
      hint = "the number is too large to be held; write one that means something in mm or degrees";
    }
    const bool isAtEnd = complaint.find("unexpected end of input") != std::string::npos;
    const std::string_view before = text_.substr(0, end == 0 || isAtEnd ? end : end - 1);
    const std::size_t line =
        1 + static_cast<std::size_t>(std::count(before.begin(), before.end(), '\n'));
    const std::size_t lineBreak = before.rfind('\n');
    const std::size_t column =
        before.size() - (lineBreak == std::string_view::npos ? 0 : lineBreak + 1) + 1;
    error_ = Error{ErrorCode::BadFile, placeText(file_, line, column) + "this is not valid JSON: " +
                                           (hint.empty() ? complaint : hint)};
    return false;
  }

  JsonValue takeRoot() { return std::move(root_); }
  const std::optional<Error>& error() const { return error_; }

 private:
  bool fail(const std::string& sentence) {
    error_ = Error{ErrorCode::BadFile,
                   placeText(file_, follower_.line(), follower_.column()) + sentence};
    return false;
  }

  JsonValue* put(Kind kind) {
    follower_.next();
    if (++count_ > limits_.values) {
      fail("the file holds more than " + std::to_string(limits_.values) +
           " values; a model is never that large");
      return nullptr;
    }
    JsonValue* place = &root_;
    if (!open_.empty()) {
      JsonValue& parent = *open_.back();
      if (parent.is(Kind::Array)) {
        place = &parent.items.emplace_back();
      } else {
        parent.members.push_back({std::move(key_), {}});
        place = &parent.members.back().value;
      }
    }
    place->kind = kind;
    place->line = follower_.line();
    place->column = follower_.column();
    return place;
  }

  bool putNumber(double value) {
    JsonValue* v = put(Kind::Number);
    if (v == nullptr) return false;
    v->number = value;
    v->text = std::string(follower_.token());
    return true;
  }

  bool open(Kind kind) {
    if (open_.size() >= limits_.depth) {
      follower_.next();
      return fail("brackets are nested more than " + std::to_string(limits_.depth) +
                  " deep; a model never needs that");
    }
    JsonValue* v = put(kind);
    if (v == nullptr) return false;
    open_.push_back(v);
    names_.emplace_back();
    return true;
  }

  bool close() {
    follower_.next();
    open_.pop_back();
    names_.pop_back();
    return true;
  }

  std::string_view text_;
  std::string_view file_;
  JsonLimits limits_;
  TokenFollower follower_;
  JsonValue root_;
  std::vector<JsonValue*> open_;              // from the root to the value being filled
  std::vector<std::set<std::string>> names_;  // the member names seen in each of them
  std::string key_;
  std::size_t count_ = 0;
  std::optional<Error> error_;
};

}  // namespace

Result<JsonValue> parseJson(std::string_view text, std::string_view file,
                            const JsonLimits& limits) {
  if (text.size() > limits.bytes) {
    return Error{ErrorCode::BadFile, std::string(file) + ": the file has " +
                                         std::to_string(text.size() >> 20) + " MB, at most " +
                                         std::to_string(limits.bytes >> 20) +
                                         " MB are read; is this the right file?"};
  }
  if (text.find_first_not_of(" \t\r\n") == std::string_view::npos) {
    return Error{ErrorCode::BadFile, std::string(file) + ": the file is empty"};
  }
  TreeBuilder builder(text, file, limits);
  if (!nlohmann::json::sax_parse(text.begin(), text.end(), &builder)) {
    if (builder.error()) return *builder.error();
    return Error{ErrorCode::BadFile, std::string(file) + ": this is not valid JSON"};
  }
  return builder.takeRoot();
}

std::string numberText(double value) {
  KIRI_CHECK(std::isfinite(value), "only finite numbers are written");
  constexpr double kExactInteger = 9007199254740992.0;  // 2^53
  if (std::fabs(value) < kExactInteger && std::floor(value) == value) {
    return std::to_string(static_cast<std::int64_t>(value));
  }
  return nlohmann::json(value).dump();
}

std::string jsonString(std::string_view text) {
  return nlohmann::json(std::string(text))
      .dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

}  // namespace kiri
