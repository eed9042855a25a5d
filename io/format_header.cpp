// The first two fields of our own files: "format" and "version".
// SPDX-License-Identifier: MIT
#include "io/format_header.h"

#include <cmath>
#include <optional>

namespace kiri {

bool readFormatHeader(Fields& fields, const std::string& what, const std::string& format,
                      int newest) {
  Findings& findings = fields.object().findings();
  const std::string quoted = jsonString(format);
  const std::string known = std::to_string(newest);
  if (const std::optional<Field> field = fields.require(
          "format", what + " starts with \"format\": " + quoted + ", \"version\": " + known)) {
    if (field->text() != format) field->isNot(quoted + "; this is another kind of file");
  }
  if (!findings.isGood()) return false;
  if (const std::optional<Field> version =
          fields.require("version", "write \"version\": " + known)) {
    const double number = version->number({1, kLargestLength, false});
    if (std::floor(number) != number) version->isNot("a whole number");
    if (number > newest) {
      version->mistake("is " + version->json().text +
                       ", but this program knows the format up to version " + known +
                       "; use a newer program");
    }
  }
  return findings.isGood();
}

}  // namespace kiri
