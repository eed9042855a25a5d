// A JSON document as a tree that remembers where in the text each value stood.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"

namespace kiri {

struct JsonMember;

/// One JSON value. Members keep the order in which they were written.
struct JsonValue {
  enum class Kind : std::uint8_t { Null, Bool, Number, String, Array, Object };

  Kind kind = Kind::Null;
  bool boolean = false;
  std::uint32_t line = 0;    ///< where the value starts, from 1; 0 for a value that was not read
  std::uint32_t column = 0;  ///< in bytes, from 1
  double number = 0;
  std::string text;  ///< a string's content; a number as it was written
  std::vector<JsonValue> items;
  std::vector<JsonMember> members;

  static JsonValue ofNumber(double value);
  static JsonValue ofText(std::string value);
  static JsonValue ofBool(bool value);
  static JsonValue array();
  static JsonValue object();

  bool is(Kind k) const { return kind == k; }
  /// The member of that name; none when there is none or this is no object.
  const JsonValue* find(std::string_view name) const;
  JsonValue* find(std::string_view name);
  /// Appends a member. Requires an object.
  JsonValue& add(std::string name, JsonValue value);
};

struct JsonMember {
  std::string name;
  JsonValue value;
};

/// What a document may hold at most, so that a hostile file ends in a sentence and not in a crash.
struct JsonLimits {
  std::size_t bytes = std::size_t{64} << 20;
  std::size_t values = 2'000'000;
  std::size_t depth = 64;
};

/// Reads JSON text (UTF-8). Errors: BadFile - with `file`, line, column, what is wrong there and,
/// where it can be told, what to do. A name that an object holds twice is an error.
Result<JsonValue> parseJson(std::string_view text, std::string_view file,
                            const JsonLimits& limits = {});

/// The shortest text that reads back as the same number; the same in every locale. Requires a
/// finite number.
std::string numberText(double value);

/// The string as a JSON string with its quotes.
std::string jsonString(std::string_view text);

/// All on one line.
std::string compactText(const JsonValue& value);

/// Laid out for people: what fits in `width` columns stands on one line, points, numbers, nulls and
/// single letters are packed into lines, everything else is broken with two spaces of indent.
/// Objects and arrays whose depth is below `alwaysBroken` are broken in any case. Ends with a line
/// break.
std::string layOut(const JsonValue& value, std::size_t alwaysBroken, std::size_t width = 96);

}  // namespace kiri
