// An SVG file as a tree, with its style sheet and its names.
// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "core/base/result.h"
#include "io/patterns/pattern_file.h"
#include "io/patterns/svg_numbers.h"
#include "io/patterns/svg_style.h"

namespace pugi {
class xml_document;
class xml_node;
}  // namespace pugi

namespace kiri {

struct SvgDocument {
  SvgDocument();
  ~SvgDocument();
  SvgDocument(SvgDocument&&) noexcept;
  SvgDocument& operator=(SvgDocument&&) = delete;

  std::unique_ptr<pugi::xml_document> tree;
  std::unique_ptr<pugi::xml_node> root;  ///< the outermost <svg>
  std::unique_ptr<SvgStyleSheet> styles;
  std::map<std::string_view, pugi::xml_node, std::less<>> byId;  ///< the first of each name
  std::string brokenAt;  ///< "line 12: ..."; empty when the XML is whole

  /// The element that `href` of a <use> means.
  std::optional<pugi::xml_node> target(const pugi::xml_node& use) const;
};

/// Errors: BadFile - too large, no XML at all, no <svg> in it.
Result<SvgDocument> parseSvg(std::string_view text, std::string_view fileName);

/// The window of an <svg> or <symbol>: x, y, width, height of viewBox; none where it has none.
struct SvgWindow {
  Vec2 corner;
  Vec2 size;
};
std::optional<SvgWindow> svgWindowOf(const pugi::xml_node& element);

/// How the inside of an <svg> or <symbol> lies outside, when it is shown at `corner` in `size`
/// (viewBox and preserveAspectRatio).
SvgMatrix svgWindowMatrix(const pugi::xml_node& element, Vec2 corner, Vec2 size);

/// Title, description and author, and millimetres a unit where width or height have a true size.
/// `stretch` is what the root does to y beside x (1 but for preserveAspectRatio="none").
struct SvgHead {
  std::string title;
  std::string author;
  std::string description;
  std::optional<double> mmPerUnit;
  double stretch = 1;
  Vec2 size;  ///< of the window, user units; what percentages are of
};
SvgHead svgHeadOf(const SvgDocument& document);

}  // namespace kiri
