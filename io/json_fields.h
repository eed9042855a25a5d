// Typed reading of JSON objects: every mistake gets a sentence with its place, every unknown field
// is kept. SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <initializer_list>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/base/vec.h"
#include "io/json_tree.h"

namespace kiri {

/// What becomes of fields that the reader does not know.
enum class UnknownFields {
  AreKept,  ///< for the writer; there is a warning when one looks like a typing error
  AreLost,  ///< the document is never written again; there is a warning for each
};

/// What is wrong in a document, and what looks odd. Only the first mistake counts; reading goes on
/// after it with harmless values, so that readers need no branches.
class Findings {
 public:
  explicit Findings(std::string file, UnknownFields unknownFields = UnknownFields::AreKept)
      : file_(std::move(file)), unknownFields_(unknownFields) {}

  /// Says in which part of the document readers are ("step 3 (fold)"); part of every sentence.
  void enter(std::string where) { where_ = std::move(where); }

  void mistake(const JsonValue& at, const std::string& sentence);
  void warning(const JsonValue& at, const std::string& sentence);
  /// Keeps a field that nobody knows under its path ("line/colour"). A "/" in a name is written
  /// "~1", "~" is "~0".
  void unknown(const std::string& path, const JsonValue& value);
  UnknownFields unknownFields() const { return unknownFields_; }

  /// The fields kept since the last call, as JSON text; empty when there are none.
  std::string takeUnknown();

  bool isGood() const { return !error_; }
  const std::optional<Error>& error() const { return error_; }
  const std::vector<std::string>& warnings() const { return warnings_; }

 private:
  std::string sentenceAt(const JsonValue& at, const std::string& sentence) const;

  std::string file_;
  UnknownFields unknownFields_;
  std::string where_;
  std::optional<Error> error_;
  std::vector<std::string> warnings_;
  JsonValue unknown_ = JsonValue::object();
};

/// Puts the unknown fields that `unknownText` holds (see Findings::unknown) back into `value`.
/// Those whose object is no longer there are left out.
void mergeUnknown(JsonValue& value, const std::string& unknownText);

/// The known name that `written` was probably meant to be; empty when none is near.
std::string nearestName(std::string_view written, const std::vector<std::string>& known);

struct Limits {
  double low = std::numeric_limits<double>::lowest();
  double high = std::numeric_limits<double>::max();
  bool isOpenBelow = false;  ///< the lower limit itself is not allowed
};

/// The largest coordinate or length that a model may have, mm: a kilometre of paper.
inline constexpr double kLargestLength = 1e6;

/// A value of the document and the path by which messages name it ("line/paper/0").
class Field {
 public:
  Field(const JsonValue& json, std::string path, Findings& findings)
      : json_(&json), path_(std::move(path)), findings_(&findings) {}

  const JsonValue& json() const { return *json_; }
  const std::string& path() const { return path_; }
  /// The last part of the path.
  std::string_view name() const {
    const std::size_t slash = path_.rfind('/');
    return std::string_view(path_).substr(slash == std::string::npos ? 0 : slash + 1);
  }
  Findings& findings() const { return *findings_; }

  bool isText() const { return json_->is(JsonValue::Kind::String); }
  bool isArray() const { return json_->is(JsonValue::Kind::Array); }
  bool isObject() const { return json_->is(JsonValue::Kind::Object); }
  /// True for an array that starts with a number: a point, right or wrong.
  bool looksLikePoint() const;

  std::size_t size() const { return json_->items.size(); }
  Field item(std::size_t i) const;

  double number(const Limits& limits) const;
  int count() const;
  bool flag() const;
  std::string text() const;
  Vec2 point() const;
  /// A list of at least `atLeast` points.
  std::vector<Vec2> points(std::size_t atLeast) const;
  /// The position of the text among `choices`; a mistake names all of them.
  std::size_t oneOf(const std::vector<std::string>& choices) const;

  /// Reports `"path" sentence`.
  void mistake(const std::string& sentence) const;
  /// Reports that the value is not what it must be.
  void isNot(const std::string& wanted) const;

 private:
  const JsonValue* json_;
  std::string path_;
  Findings* findings_;
};

/// The fields of one object. What is asked for is known; finish() keeps the rest and warns of
/// typing errors.
class Fields {
 public:
  /// Reports a mistake when the value is no object; every field is missing then, without further
  /// reports.
  explicit Fields(const Field& object);

  std::optional<Field> find(std::string_view name);
  /// Reports a mistake when the field is missing; `meaning` says what it would be ("the line to
  /// fold along").
  std::optional<Field> require(std::string_view name, std::string_view meaning);
  /// The only one of `names` that is there. Reports a mistake when none or several are.
  std::optional<Field> requireOneOf(const std::vector<std::string>& names,
                                    std::string_view meaning);

  double number(std::string_view name, double fallback, const Limits& limits);
  bool flag(std::string_view name, bool fallback);
  std::string text(std::string_view name);
  std::size_t oneOf(std::string_view name, const std::vector<std::string>& choices,
                    std::size_t fallback);

  /// To be called when all known fields were asked for.
  void finish();

  const Field& object() const { return object_; }

 private:
  void markKnown(std::string_view name);
  std::string missing(std::string_view name, std::string_view meaning) const;

  Field object_;
  std::vector<std::string> known_;
};

}  // namespace kiri
