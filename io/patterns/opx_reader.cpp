// Reading .opx files of ORIPA (docs/formats/opx.md).
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <map>
#include <optional>
#include <pugixml.hpp>
#include <string>

#include "io/patterns/opx_format.h"
#include "io/patterns/plain_number.h"
#include "io/patterns/tally.h"
#include "io/patterns/text_lines.h"

namespace kiri {

namespace {

// What pugixml makes of as many tags and attributes stays below 1 GB.
constexpr std::ptrdiff_t kMostOpxTags = 3'000'000;
constexpr std::ptrdiff_t kMostOpxAttributes = 6'000'000;

bool isNamed(const pugi::xml_node& node, std::string_view name) { return node.name() == name; }

bool hasValue(const pugi::xml_node& node, const char* attribute, std::string_view value) {
  return node.attribute(attribute).value() == value;
}

/// The node after `node` in the order of the file, without recursion; none behind the last.
pugi::xml_node following(pugi::xml_node node) {
  if (node.first_child()) return node.first_child();
  while (node && !node.next_sibling()) node = node.parent();
  return node ? node.next_sibling() : node;
}

class OpxReader {
 public:
  explicit OpxReader(PatternFile& file) : file_(file) {}

  void read(const pugi::xml_document& document) {
    std::size_t index = 0;
    for (pugi::xml_node node = document.first_child(); node; node = following(node)) {
      if (isNamed(node, "object") && hasValue(node, "class", "oripa.OriLineProxy")) {
        addLine(node, index++);
      } else if (isNamed(node, "void")) {
        readField(node);
      }
    }
    bad_.tell(file_.notes, "line", "lines", "with numbers that make no sense; left out");
    strange_.tell(file_.notes, "line", "lines",
                  "of a type that is none of 0 to 4; taken as auxiliary");
    file_.title = fields_["title"];
    file_.author = fields_["originalAuthorName"];
    file_.description = fields_["memo"];
    tellField("editorName", "the name of the editor");
    tellField("reference", "the reference");
  }

 private:
  /// The number of a property; 0 where Java left the default out, none where it is no number.
  static std::optional<double> numberIn(const pugi::xml_node& object, std::string_view name) {
    for (const pugi::xml_node& child : object.children("void")) {
      if (!hasValue(child, "property", name)) continue;
      const std::optional<double> value = numberOf(child.first_child().child_value());
      return value && isDrawable(*value) ? value : std::nullopt;
    }
    return 0;
  }

  void addLine(const pugi::xml_node& object, std::size_t index) {
    const std::optional<double> type = numberIn(object, "type");
    const std::optional<double> x0 = numberIn(object, "x0");
    const std::optional<double> y0 = numberIn(object, "y0");
    const std::optional<double> x1 = numberIn(object, "x1");
    const std::optional<double> y1 = numberIn(object, "y1");
    if (!type || !x0 || !y0 || !x1 || !y1) {
      bad_.add(index);
      return;
    }
    // y points down in the file. From zero, so that 0 does not become -0.
    DrawnCrease line{{*x0, 0 - *y0}, {*x1, 0 - *y1}, Assignment::Flat, std::nullopt};
    if (*type == 1) {
      line.assignment = Assignment::Border;
    } else if (*type == 2) {
      line.assignment = Assignment::Mountain;
    } else if (*type == 3) {
      line.assignment = Assignment::Valley;
    } else if (*type == 4) {
      line.assignment = Assignment::Unassigned;
    } else if (*type != 0) {
      strange_.add(index);
    }
    file_.drawing.lines.push_back(line);
  }

  /// Texts stand as <void property="title"><string>..., or as a getField with a set inside.
  void readField(const pugi::xml_node& node) {
    const pugi::xml_node own = node.child("string");
    if (!own) return;
    if (const pugi::xml_attribute property = node.attribute("property")) {
      fields_.emplace(property.value(), own.child_value());
    } else if (hasValue(node, "method", "getField")) {
      for (const pugi::xml_node& inner : node.children("void")) {
        const pugi::xml_node value = inner.child("string");
        if (hasValue(inner, "method", "set") && value) {
          fields_.emplace(own.child_value(), value.child_value());
        }
      }
    }
  }

  void tellField(const char* name, const std::string& what) {
    const std::string text(trimmed(fields_[name]));
    if (!text.empty()) file_.notes.push_back(what + " is not kept: " + text);
  }

  PatternFile& file_;
  std::map<std::string, std::string> fields_;
  Tally bad_;
  Tally strange_;
};

Error opxError(std::string_view fileName, const std::string& sentence) {
  return {ErrorCode::BadFile, std::string(fileName) + ": " + sentence};
}

}  // namespace

Result<PatternFile> readOpxPattern(std::string_view text, std::string_view fileName) {
  if (std::count(text.begin(), text.end(), '<') > kMostOpxTags ||
      std::count(text.begin(), text.end(), '=') > kMostOpxAttributes) {
    return opxError(fileName, "the file has millions of XML tags; is this the right file?");
  }
  pugi::xml_document document;
  const pugi::xml_parse_result parsed =
      document.load_buffer(text.data(), text.size(), pugi::parse_default);
  PatternFile file;
  file.format = PatternFormat::Opx;
  OpxReader(file).read(document);
  std::string broken;
  if (!parsed) {
    const auto end =
        text.begin() + std::min<std::ptrdiff_t>(std::max<std::ptrdiff_t>(parsed.offset, 0),
                                                static_cast<std::ptrdiff_t>(text.size()));
    broken = "the XML is broken at line " + std::to_string(1 + std::count(text.begin(), end, '\n'));
  }
  if (file.drawing.lines.empty()) {
    return opxError(fileName, "the file holds no line of ORIPA (oripa.OriLineProxy)" +
                                  (broken.empty() ? "; is this the right file?" : "; " + broken));
  }
  if (!broken.empty()) file.notes.push_back(broken + "; what follows was left out");
  return file;
}

}  // namespace kiri
