// An SVG file as a tree, with its style sheet and its names.
// SPDX-License-Identifier: MIT
#include "io/patterns/svg_document.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <pugixml.hpp>
#include <utility>

#include "core/geometry/tolerance.h"
#include "io/patterns/plain_number.h"

namespace kiri {

namespace {

constexpr std::size_t kMostBytes = std::size_t{64} << 20;
constexpr std::ptrdiff_t kMostTags = 3'000'000;
constexpr std::ptrdiff_t kMostAttributes = 12'000'000;

Error badSvg(std::string_view fileName, const std::string& what) {
  return {ErrorCode::BadFile, std::string(fileName) + ": " + what};
}

std::string lineAt(std::string_view text, std::ptrdiff_t offset) {
  const std::size_t end =
      std::min(text.size(), static_cast<std::size_t>(std::max<std::ptrdiff_t>(offset, 0)));
  const auto breaks =
      std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(end), '\n');
  return "line " + std::to_string(breaks + 1);
}

/// The next element in the order of the file, without recursion; none behind the last.
pugi::xml_node nextNode(const pugi::xml_node& node) {
  if (node.first_child()) return node.first_child();
  pugi::xml_node at = node;
  while (at && !at.next_sibling()) at = at.parent();
  return at ? at.next_sibling() : at;
}

std::string textOf(const pugi::xml_node& element) {
  std::string out;
  for (const pugi::xml_node& child : element.children()) out += child.value();
  const auto isBlank = [](char c) { return c == ' ' || c == '\n' || c == '\r' || c == '\t'; };
  while (!out.empty() && isBlank(out.back())) out.pop_back();
  out.erase(out.begin(), std::find_if_not(out.begin(), out.end(), isBlank));
  return out;
}

/// Finds root, names and style sheets in one walk.
void indexTree(SvgDocument& document) {
  for (pugi::xml_node node = *document.tree; node; node = nextNode(node)) {
    if (node.type() != pugi::node_element) continue;
    const std::string_view name = localName(node.name());
    if (name == "svg" && !*document.root) *document.root = node;
    const std::string_view id = node.attribute("id").value();
    if (!id.empty()) document.byId.emplace(id, node);
    if (name == "style") document.styles->add(textOf(node));
  }
}

/// The text of the first element of that name within `around`.
std::string firstText(const pugi::xml_node& around, std::string_view name) {
  const pugi::xml_node found = around.find_node([&](const pugi::xml_node& node) {
    return node.type() == pugi::node_element && localName(node.name()) == name;
  });
  return found ? textOf(found) : std::string();
}

std::optional<SvgLength> lengthAttribute(const pugi::xml_node& element, const char* name) {
  const std::optional<SvgLength> length = svgLengthOf(element.attribute(name).value());
  if (!length || !isDrawable(length->value) || !(length->value > 0)) return std::nullopt;
  return length;
}

/// Millimetres a unit are rarely anything but these.
double rounded(double mmPerUnit) {
  for (const double known : {1.0, 10.0, 25.4, 1000.0, 25.4 / 72, 25.4 / 96}) {
    if (std::fabs(mmPerUnit / known - 1) < kParallel) return known;
  }
  return mmPerUnit;
}

}  // namespace

SvgDocument::SvgDocument()
    : tree(std::make_unique<pugi::xml_document>()),
      root(std::make_unique<pugi::xml_node>()),
      styles(std::make_unique<SvgStyleSheet>()) {}
SvgDocument::~SvgDocument() = default;
SvgDocument::SvgDocument(SvgDocument&&) noexcept = default;

std::optional<pugi::xml_node> SvgDocument::target(const pugi::xml_node& use) const {
  std::string_view href = use.attribute("href").value();
  if (href.empty()) href = use.attribute("xlink:href").value();
  if (href.size() < 2 || href.front() != '#') return std::nullopt;
  const auto found = byId.find(href.substr(1));
  if (found == byId.end()) return std::nullopt;
  return found->second;
}

Result<SvgDocument> parseSvg(std::string_view text, std::string_view fileName) {
  if (text.size() > kMostBytes || std::count(text.begin(), text.end(), '<') > kMostTags ||
      std::count(text.begin(), text.end(), '=') > kMostAttributes) {
    return badSvg(fileName,
                  "the drawing is too large to be read as a crease pattern (more than 64 MB or 3 "
                  "million tags); save only its lines and open that");
  }
  SvgDocument document;
  const pugi::xml_parse_result parsed =
      document.tree->load_buffer(text.data(), text.size(), pugi::parse_default);
  if (!parsed) document.brokenAt = lineAt(text, parsed.offset) + ": " + parsed.description();
  indexTree(document);
  if (*document.root) return document;
  if (!parsed) {
    return badSvg(fileName, "this is no SVG drawing (" + document.brokenAt +
                                "); save it again as SVG and open that");
  }
  return badSvg(fileName, "there is no <svg> element in it; save the drawing again as SVG");
}

std::optional<SvgWindow> svgWindowOf(const pugi::xml_node& element) {
  std::string_view text = element.attribute("viewBox").value();
  const std::optional<double> x = takeListed(text);
  const std::optional<double> y = x ? takeListed(text) : std::nullopt;
  const std::optional<double> width = y ? takeListed(text) : std::nullopt;
  const std::optional<double> height = width ? takeListed(text) : std::nullopt;
  if (!height || !(*width > 0) || !(*height > 0)) return std::nullopt;
  for (const double v : {*x, *y, *width, *height}) {
    if (!isDrawable(v)) return std::nullopt;
  }
  return SvgWindow{{*x, *y}, {*width, *height}};
}

SvgMatrix svgWindowMatrix(const pugi::xml_node& element, Vec2 corner, Vec2 size) {
  const std::optional<SvgWindow> window = svgWindowOf(element);
  if (!window || !(size.x > 0) || !(size.y > 0)) return {1, 0, 0, 1, corner.x, corner.y};
  Vec2 scale{size.x / window->size.x, size.y / window->size.y};
  const std::string_view kept = element.attribute("preserveAspectRatio").value();
  Vec2 at = corner;
  if (kept.substr(0, 4) != "none") {
    const bool isCovering = kept.find("slice") != std::string_view::npos;
    const double one = isCovering ? std::max(scale.x, scale.y) : std::min(scale.x, scale.y);
    const auto share = [&](std::string_view low, std::string_view high) {
      if (kept.find(low) != std::string_view::npos) return 0.0;
      return kept.find(high) != std::string_view::npos ? 1.0 : 0.5;
    };
    at = corner + Vec2{(size.x - window->size.x * one) * share("xMin", "xMax"),
                       (size.y - window->size.y * one) * share("YMin", "YMax")};
    scale = {one, one};
  }
  return {
      scale.x, 0, 0, scale.y, at.x - window->corner.x * scale.x, at.y - window->corner.y * scale.y};
}

SvgHead svgHeadOf(const SvgDocument& document) {
  const pugi::xml_node& root = *document.root;
  SvgHead head;
  for (const pugi::xml_node& child : root.children()) {
    const std::string_view name = localName(child.name());
    if (name == "title" && head.title.empty()) head.title = textOf(child);
    if (name == "desc" && head.description.empty()) head.description = textOf(child);
    if (name != "metadata") continue;
    if (head.title.empty()) head.title = firstText(child, "title");
    if (head.description.empty()) head.description = firstText(child, "description");
    const pugi::xml_node creator = child.find_node([](const pugi::xml_node& node) {
      return node.type() == pugi::node_element && localName(node.name()) == "creator";
    });
    if (!creator) continue;
    head.author = textOf(creator);
    if (head.author.empty()) head.author = firstText(creator, "title");
  }
  const std::optional<SvgLength> width = lengthAttribute(root, "width");
  const std::optional<SvgLength> height = lengthAttribute(root, "height");
  const std::optional<SvgWindow> window = svgWindowOf(root);
  const std::optional<double> wide = width ? width->inMm() : std::nullopt;
  const std::optional<double> high = height ? height->inMm() : std::nullopt;
  constexpr double kMmPerPixel = 25.4 / 96;
  if (!window) {
    head.size = {width ? width->inUser(0) : 0, height ? height->inUser(0) : 0};
    if (wide || high) head.mmPerUnit = kMmPerPixel;
    return head;
  }
  head.size = window->size;
  const std::string_view kept = root.attribute("preserveAspectRatio").value();
  if (kept.substr(0, 4) == "none" && width && height) {
    const double x = width->inUser(window->size.x) / window->size.x;
    const double y = height->inUser(window->size.y) / window->size.y;
    if (x > 0 && y > 0) head.stretch = y / x;
    if (wide) head.mmPerUnit = rounded(*wide / window->size.x);
  } else if (wide && high) {
    head.mmPerUnit = rounded(std::min(*wide / window->size.x, *high / window->size.y));
  } else if (wide || high) {
    head.mmPerUnit = rounded(wide ? *wide / window->size.x : *high / window->size.y);
  }
  return head;
}

}  // namespace kiri
