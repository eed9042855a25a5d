// How an element of an SVG drawing looks, and what that makes of its lines.
// SPDX-License-Identifier: MIT
#include "io/patterns/svg_look.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <pugixml.hpp>
#include <utility>

#include "io/patterns/plain_number.h"

namespace kiri {

namespace {

std::string_view valueOf(const SvgValues& values, SvgProperty property) {
  return values[static_cast<std::size_t>(property)];
}

/// "0.5" or "50%".
std::optional<double> shareOf(std::string_view text) {
  const std::optional<double> number = takeNumber(text);
  if (!number || (!text.empty() && text != "%")) return std::nullopt;
  return std::clamp(text.empty() ? *number : *number / 100, 0.0, 1.0);
}

void takePaint(std::string_view text, SvgLook& look) {
  if (text.empty() || text == "inherit") return;
  if (text.substr(0, 4) == "url(") {
    // A gradient: what CSS falls back to, if anything.
    look.hasStroke = true;
    look.stroke = svgColourOf(text.substr(std::min(text.find(')'), text.size() - 1) + 1));
    return;
  }
  if (text == "none" || text == "transparent") {
    look.hasStroke = true;
    look.stroke.reset();
  } else if (text == "currentColor" || text == "currentcolor") {
    look.hasStroke = true;
    look.stroke = look.current;
  } else if (const std::optional<SvgColour> colour = svgColourOf(text)) {
    look.hasStroke = true;
    look.stroke = colour;
  }
}

std::optional<Assignment> assignmentOfLetter(std::string_view text) {
  constexpr std::string_view kLetters = "BMVFUCJbmvfucj";
  constexpr std::array<Assignment, 7> kAssignments{
      Assignment::Border,     Assignment::Mountain, Assignment::Valley, Assignment::Flat,
      Assignment::Unassigned, Assignment::Cut,      Assignment::Join};
  while (!text.empty() && text.front() == ' ') text.remove_prefix(1);
  if (text.empty()) return std::nullopt;
  const std::size_t at = kLetters.find(text.front());
  if (at == std::string_view::npos) return std::nullopt;
  return kAssignments[at % kAssignments.size()];
}

std::optional<Assignment> assignmentOfClass(std::string_view name) {
  constexpr std::array<std::pair<std::string_view, Assignment>, 8> kClasses{{
      {"mountain", Assignment::Mountain},
      {"valley", Assignment::Valley},
      {"boundary", Assignment::Border},
      {"border", Assignment::Border},
      {"flat", Assignment::Flat},
      {"unassigned", Assignment::Unassigned},
      {"cut", Assignment::Cut},
      {"join", Assignment::Join},
  }};
  for (const auto& [word, assignment] : kClasses) {
    if (word == name) return assignment;
  }
  return std::nullopt;
}

bool folds(Assignment assignment) {
  return assignment == Assignment::Mountain || assignment == Assignment::Valley;
}

}  // namespace

SvgLook svgLookOf(const pugi::xml_node& element, const SvgValues& values, const SvgLook& around) {
  SvgLook look = around;
  if (const auto colour = svgColourOf(valueOf(values, SvgProperty::Colour))) look.current = *colour;
  takePaint(valueOf(values, SvgProperty::Stroke), look);
  if (const auto share = shareOf(valueOf(values, SvgProperty::StrokeOpacity))) {
    look.strokeOpacity = *share;
  }
  if (const auto share = shareOf(valueOf(values, SvgProperty::Opacity))) look.opacity *= *share;
  const std::string_view fill = valueOf(values, SvgProperty::Fill);
  if (!fill.empty() && fill != "inherit") look.isFilled = fill != "none" && fill != "transparent";
  const std::string_view visibility = valueOf(values, SvgProperty::Visibility);
  if (!visibility.empty() && visibility != "inherit") look.isVisible = visibility == "visible";
  look.isDisplayed = valueOf(values, SvgProperty::Display) != "none";
  if (const auto stated = assignmentOfLetter(element.attribute("data-assignment").value())) {
    look.stated = stated;
  }
  const std::optional<double> angle = numberOf(element.attribute("data-foldAngle").value());
  constexpr double kMostDegrees = 180;
  if (angle && std::fabs(*angle) <= kMostDegrees) look.angle = angle;
  for (const std::string_view name : svgClasses(element.attribute("class").value())) {
    if (const auto named = assignmentOfClass(name)) look.named = named;
  }
  return look;
}

LineMeaning meaningOf(const SvgLook& look) {
  using Source = LineMeaning::Source;
  LineMeaning meaning;
  if (look.stated) {
    meaning.assignment = *look.stated;
    meaning.source = Source::Stated;
  } else if (look.stroke) {
    const ColourMeaning colour = meaningOf(*look.stroke);
    meaning.assignment = colour.assignment;
    meaning.source = colour.isExact ? Source::Colour : Source::Nearest;
  } else if (look.named) {
    meaning.assignment = *look.named;
    meaning.source = Source::Named;
  } else if (look.angle && *look.angle != 0) {
    meaning.assignment = *look.angle > 0 ? Assignment::Valley : Assignment::Mountain;
    meaning.source = Source::Stated;
  }
  const bool isMountain = meaning.assignment == Assignment::Mountain;
  if (look.angle) {
    meaning.angle = look.angle;
    if (folds(meaning.assignment) && *look.angle != 0 && isMountain != (*look.angle < 0)) {
      meaning.isContradicted = true;
      meaning.angle = -*look.angle;
    }
    return meaning;
  }
  const double share = look.opacity * look.strokeOpacity * (look.stroke ? look.stroke->alpha : 1);
  constexpr double kHalfTurn = 180;
  if (folds(meaning.assignment) && share < 1) {
    meaning.isPartial = true;
    meaning.angle = isMountain ? -share * kHalfTurn : share * kHalfTurn;
  }
  return meaning;
}

}  // namespace kiri
