// The little of CSS that says how lines of an SVG drawing look.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace pugi {
class xml_node;
}

namespace kiri {

/// The properties that a reader of crease patterns looks at.
enum class SvgProperty { Stroke, StrokeOpacity, Opacity, Fill, Display, Visibility, Colour };
inline constexpr std::size_t kSvgProperties = 7;

/// Values by property, empty where nothing is said. They point into the document or the sheet.
using SvgValues = std::array<std::string_view, kSvgProperties>;

/// Class names of an attribute `class`.
std::vector<std::string_view> svgClasses(std::string_view text);

/// The rules of all <style> elements of a file: selectors of element, class and id, several
/// together, within others or directly below them.
class SvgStyleSheet {
 public:
  SvgStyleSheet();
  ~SvgStyleSheet();
  SvgStyleSheet(const SvgStyleSheet&) = delete;
  SvgStyleSheet& operator=(const SvgStyleSheet&) = delete;

  void add(const std::string& text);
  /// Rules left out: at-rules, selectors of another kind.
  std::size_t leftOut() const { return leftOut_; }

  /// What attributes, rules and the attribute style say about the element itself, the stronger over
  /// the weaker as CSS has it. `effort` grows by the rules that were tried.
  SvgValues valuesOf(const pugi::xml_node& element, std::size_t& effort) const;

 private:
  struct Rule;
  using Index = std::map<std::string_view, std::vector<std::size_t>, std::less<>>;

  void addRules(std::string_view text);
  void addRule(std::string_view selector, std::string_view body);

  std::vector<std::unique_ptr<std::string>> texts_;
  std::vector<Rule> rules_;
  Index byId_;
  Index byClass_;
  Index byTag_;
  std::vector<std::size_t> forAll_;
  std::size_t leftOut_ = 0;
};

/// The name of an element without its namespace.
std::string_view localName(std::string_view name);

}  // namespace kiri
