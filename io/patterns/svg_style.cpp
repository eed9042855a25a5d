// The little of CSS that says how lines of an SVG drawing look.
// SPDX-License-Identifier: MIT
#include "io/patterns/svg_style.h"

#include <algorithm>
#include <optional>
#include <pugixml.hpp>
#include <utility>

namespace kiri {

namespace {

bool isCssBlank(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\n' || c == '\f'; }

std::string_view cssTrimmed(std::string_view text) {
  while (!text.empty() && isCssBlank(text.front())) text.remove_prefix(1);
  while (!text.empty() && isCssBlank(text.back())) text.remove_suffix(1);
  return text;
}

std::optional<SvgProperty> propertyOf(std::string_view name) {
  constexpr std::array<std::pair<std::string_view, SvgProperty>, kSvgProperties> kNames{{
      {"stroke", SvgProperty::Stroke},
      {"stroke-opacity", SvgProperty::StrokeOpacity},
      {"opacity", SvgProperty::Opacity},
      {"fill", SvgProperty::Fill},
      {"display", SvgProperty::Display},
      {"visibility", SvgProperty::Visibility},
      {"color", SvgProperty::Colour},
  }};
  for (const auto& [word, property] : kNames) {
    if (word == name) return property;
  }
  return std::nullopt;
}

struct Declaration {
  SvgProperty property;
  std::string_view value;
  bool isImportant = false;
};

/// "stroke: red; opacity: .5 !important"
std::vector<Declaration> declarationsOf(std::string_view text) {
  std::vector<Declaration> found;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find(';'), text.size());
    const std::string_view one = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    const std::size_t colon = one.find(':');
    if (colon == std::string_view::npos) continue;
    const std::optional<SvgProperty> property = propertyOf(cssTrimmed(one.substr(0, colon)));
    if (!property) continue;
    std::string_view value = cssTrimmed(one.substr(colon + 1));
    const std::size_t mark = value.find('!');
    const bool isImportant =
        mark != std::string_view::npos && cssTrimmed(value.substr(mark + 1)) == "important";
    if (mark != std::string_view::npos) value = cssTrimmed(value.substr(0, mark));
    if (value.empty()) continue;
    const auto same = std::find_if(found.begin(), found.end(), [&](const Declaration& other) {
      return other.property == *property && other.isImportant == isImportant;
    });
    if (same == found.end()) {
      found.push_back({*property, value, isImportant});
    } else {
      same->value = value;
    }
  }
  return found;
}

/// One part of a selector: "line.mountain#m1".
struct Compound {
  std::string_view tag;
  std::string_view id;
  std::vector<std::string_view> classes;
  bool isDirect = false;  ///< a child of the part before it, not just within it
};

bool isNameLetter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' ||
         c == '_' || (static_cast<unsigned char>(c) & 0x80) != 0;
}

std::string_view takeName(std::string_view& text) {
  std::size_t length = 0;
  while (length < text.size() && isNameLetter(text[length])) ++length;
  const std::string_view name = text.substr(0, length);
  text.remove_prefix(length);
  return name;
}

std::optional<Compound> takeCompound(std::string_view& text) {
  Compound part;
  bool isEmpty = true;
  while (!text.empty() && !isCssBlank(text.front()) && text.front() != '>') {
    const char mark = text.front();
    if (mark == '*' && isEmpty) {
      text.remove_prefix(1);
    } else if (mark == '.' || mark == '#') {
      text.remove_prefix(1);
      const std::string_view name = takeName(text);
      if (name.empty()) return std::nullopt;
      if (mark == '#') {
        part.id = name;
      } else {
        part.classes.push_back(name);
      }
    } else if (isEmpty && isNameLetter(mark)) {
      part.tag = takeName(text);
    } else {
      return std::nullopt;
    }
    isEmpty = false;
  }
  if (isEmpty) return std::nullopt;
  return part;
}

std::optional<std::vector<Compound>> selectorOf(std::string_view text) {
  constexpr std::size_t kMostParts = 16;
  std::vector<Compound> parts;
  text = cssTrimmed(text);
  bool isDirect = false;
  while (!text.empty()) {
    if (text.front() == '>') {
      if (parts.empty() || isDirect) return std::nullopt;
      isDirect = true;
      text.remove_prefix(1);
    } else {
      std::optional<Compound> part = takeCompound(text);
      if (!part || parts.size() == kMostParts) return std::nullopt;
      part->isDirect = isDirect;
      isDirect = false;
      parts.push_back(std::move(*part));
    }
    while (!text.empty() && isCssBlank(text.front())) text.remove_prefix(1);
  }
  if (parts.empty() || isDirect) return std::nullopt;
  return parts;
}

bool matchesOne(const Compound& part, const pugi::xml_node& element) {
  if (!part.tag.empty() && part.tag != localName(element.name())) return false;
  if (!part.id.empty() && part.id != element.attribute("id").value()) return false;
  if (part.classes.empty()) return true;
  const std::vector<std::string_view> own = svgClasses(element.attribute("class").value());
  return std::all_of(part.classes.begin(), part.classes.end(), [&](std::string_view name) {
    return std::find(own.begin(), own.end(), name) != own.end();
  });
}

/// Matches the parts before the last against the elements around, nearest first. `effort` counts
/// the elements looked at.
bool matchesAround(const std::vector<Compound>& parts, const pugi::xml_node& element,
                   std::size_t& effort) {
  pugi::xml_node around = element.parent();
  bool isDirect = parts.back().isDirect;
  for (std::size_t i = parts.size() - 1; i-- > 0;) {
    while (around && !matchesOne(parts[i], around)) {
      ++effort;
      if (isDirect) return false;
      around = around.parent();
    }
    if (!around) return false;
    isDirect = parts[i].isDirect;
    around = around.parent();
  }
  return true;
}

/// Also without the marks by which old files hide their rules from old browsers.
std::string withoutComments(const std::string& text) {
  std::string out;
  std::size_t at = 0;
  while (at < text.size()) {
    for (const std::string_view mark : {"<!--", "-->"}) {
      if (text.compare(at, mark.size(), mark) == 0) at += mark.size();
    }
    if (text.compare(at, 2, "/*") != 0) {
      if (at < text.size()) out += text[at++];
      continue;
    }
    const std::size_t close = text.find("*/", at + 2);
    if (close == std::string::npos) break;
    out += ' ';
    at = close + 2;
  }
  return out;
}

/// How strong a declaration is: important, then style attribute, ids, classes, tags, then order.
using Strength = std::array<std::size_t, 6>;

}  // namespace

struct SvgStyleSheet::Rule {
  std::vector<Compound> parts;
  std::vector<Declaration> declarations;
  Strength strength{};
};

SvgStyleSheet::SvgStyleSheet() = default;
SvgStyleSheet::~SvgStyleSheet() = default;

std::string_view localName(std::string_view name) {
  const std::size_t colon = name.find(':');
  return colon == std::string_view::npos ? name : name.substr(colon + 1);
}

std::vector<std::string_view> svgClasses(std::string_view text) {
  constexpr std::size_t kLongest = 4096;  // nobody has more to say; hostile files may
  text = text.substr(0, kLongest);
  std::vector<std::string_view> found;
  while (!(text = cssTrimmed(text)).empty()) {
    std::size_t length = 0;
    while (length < text.size() && !isCssBlank(text[length])) ++length;
    found.push_back(text.substr(0, length));
    text.remove_prefix(length);
  }
  return found;
}

void SvgStyleSheet::add(const std::string& text) {
  texts_.push_back(std::make_unique<std::string>(withoutComments(text)));
  addRules(*texts_.back());
}

void SvgStyleSheet::addRules(std::string_view text) {
  while (!(text = cssTrimmed(text)).empty()) {
    const std::size_t stop = text.find_first_of("{;");
    if (stop == std::string_view::npos) return;
    const bool isAtRule = text.front() == '@';
    if (text[stop] == ';') {
      // A rule of one line, like @import.
      if (isAtRule) ++leftOut_;
      text.remove_prefix(stop + 1);
      continue;
    }
    std::size_t depth = 1;
    std::size_t end = stop + 1;
    for (; end < text.size() && depth > 0; ++end) {
      if (text[end] == '{') ++depth;
      if (text[end] == '}') --depth;
    }
    const std::string_view selectors = text.substr(0, stop);
    const std::string_view body = text.substr(stop + 1, end - stop - (depth == 0 ? 2 : 1));
    if (isAtRule) {
      ++leftOut_;
    } else {
      addRule(selectors, body);
    }
    text.remove_prefix(end);
  }
}

void SvgStyleSheet::addRule(std::string_view selectors, std::string_view body) {
  const std::vector<Declaration> declarations = declarationsOf(body);
  if (declarations.empty()) return;
  while (!selectors.empty()) {
    const std::size_t end = std::min(selectors.find(','), selectors.size());
    std::optional<std::vector<Compound>> parts = selectorOf(selectors.substr(0, end));
    selectors.remove_prefix(std::min(end + 1, selectors.size()));
    constexpr std::size_t kMostRules = 20'000;
    if (!parts || rules_.size() == kMostRules) {
      ++leftOut_;
      continue;
    }
    Rule rule{std::move(*parts), declarations, {}};
    for (const Compound& part : rule.parts) {
      rule.strength[2] += part.id.empty() ? 0U : 1U;
      rule.strength[3] += part.classes.size();
      rule.strength[4] += part.tag.empty() ? 0U : 1U;
    }
    rule.strength[5] = rules_.size() + 1;
    const Compound& last = rule.parts.back();
    if (!last.id.empty()) {
      byId_[last.id].push_back(rules_.size());
    } else if (!last.classes.empty()) {
      byClass_[last.classes.front()].push_back(rules_.size());
    } else if (!last.tag.empty()) {
      byTag_[last.tag].push_back(rules_.size());
    } else {
      forAll_.push_back(rules_.size());
    }
    rules_.push_back(std::move(rule));
  }
}

SvgValues SvgStyleSheet::valuesOf(const pugi::xml_node& element, std::size_t& effort) const {
  SvgValues values;
  std::array<Strength, kSvgProperties> strengths{};
  const auto apply = [&](const Declaration& declaration, Strength strength) {
    const auto i = static_cast<std::size_t>(declaration.property);
    strength[0] = declaration.isImportant ? 1 : 0;
    if (!values[i].empty() && strength < strengths[i]) return;
    values[i] = declaration.value;
    strengths[i] = strength;
  };
  for (const pugi::xml_attribute& attribute : element.attributes()) {
    const std::optional<SvgProperty> property = propertyOf(attribute.name());
    const std::string_view value = cssTrimmed(attribute.value());
    if (property && !value.empty()) apply({*property, value, false}, {});
  }
  const std::string_view classText = element.attribute("class").value();
  const auto tryRules = [&](const std::vector<std::size_t>& rules) {
    effort += rules.size() * (1 + std::min<std::size_t>(classText.size(), 4096) / 16);
    for (const std::size_t r : rules) {
      const Rule& rule = rules_[r];
      if (!matchesOne(rule.parts.back(), element) || !matchesAround(rule.parts, element, effort)) {
        continue;
      }
      for (const Declaration& one : rule.declarations) apply(one, rule.strength);
    }
  };
  const auto tryIndex = [&](const Index& index, std::string_view key) {
    const auto found = index.find(key);
    if (found != index.end()) tryRules(found->second);
  };
  if (!rules_.empty()) {
    tryRules(forAll_);
    tryIndex(byTag_, localName(element.name()));
    std::vector<std::string_view> classes = svgClasses(classText);
    std::sort(classes.begin(), classes.end());
    classes.erase(std::unique(classes.begin(), classes.end()), classes.end());
    for (const std::string_view name : classes) tryIndex(byClass_, name);
    tryIndex(byId_, element.attribute("id").value());
  }
  for (const Declaration& one : declarationsOf(element.attribute("style").value())) {
    apply(one, {0, 1, 0, 0, 0, 0});
  }
  return values;
}

}  // namespace kiri
