// The marks of a pattern's faults, repairs, components and conflicts.
// SPDX-License-Identifier: MIT
#include "editor/session/pattern_view.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace kiri {

namespace {

constexpr std::size_t kMostFaults = 2000;
/// More words than that hide the pattern.
constexpr std::size_t kMostWords = 12;
constexpr std::size_t kMostOutlines = 400;

std::string shortNumber(double value) {
  char text[32];
  const char* format = std::abs(value) < 1 ? "%.2g" : "%.3g";
  std::snprintf(text, sizeof text, format, value);
  return text;
}

MarkPlace onSheet(const PaneMap& sheet, Vec2 paper) {
  return PixelPlace{Pane::Sheet, sheet.toPixels(Vec3{paper.x, paper.y, 0})};
}

const std::vector<FacetId>* facetsOf(const PatternAnalysis& analysis, const PatternEntry& entry) {
  if (!analysis.folding) return nullptr;
  if (entry.kind == PatternEntry::Kind::Component &&
      entry.index < analysis.componentFacets.size()) {
    return &analysis.componentFacets[entry.index];
  }
  if (entry.kind == PatternEntry::Kind::Conflict && !analysis.folding->states.exist()) {
    return &analysis.folding->states.conflict().facets;
  }
  return nullptr;
}

void addOutlines(const CreasePattern& pattern, const std::vector<FacetId>& facets, MarkRole role,
                 const PaneMap& sheet, Marks& marks) {
  for (std::size_t i = 0; i < std::min(facets.size(), kMostOutlines); ++i) {
    PathMark outline{role, {}, true, false};
    const Facet& facet = pattern[facets[i]];
    const std::size_t outer =
        facet.holeStarts.empty() ? facet.border.size() : facet.holeStarts.front();
    for (std::size_t k = 0; k < outer; ++k)
      outline.places.push_back(onSheet(sheet, pattern[startOf(pattern, facet.border[k])]));
    marks.push_back(std::move(outline));
  }
}

void addFaults(const PatternView& view, const PatternEntry& entry, const PaneMap& sheet,
               Marks& marks) {
  const std::size_t count = std::min(view.faults.size(), kMostFaults);
  for (std::size_t i = 0; i < count; ++i) {
    const MarkPlace at = onSheet(sheet, view.faultPlaces[i]);
    marks.push_back(PointMark{MarkRole::Fault, at});
    const bool isMeant = entry == PatternEntry{PatternEntry::Kind::Fault, i};
    const bool isAgain = i > 0 && view.faults[i - 1].vertex == view.faults[i].vertex;
    if (isMeant || (count <= kMostWords && !isAgain)) {
      marks.push_back(TextMark{MarkRole::Fault, at, labelOf(view.faults[i])});
    }
  }
}

}  // namespace

Phrase labelOf(const VertexFault& fault) {
  const std::string amount = shortNumber(fault.amount);
  switch (fault.rule) {
    case VertexRule::EvenDegree:
      return {KIRI_TEXT("editor/session", "Odd number of creases: %1"), {amount}};
    case VertexRule::Kawasaki:
      return {KIRI_TEXT("editor/session", "Kawasaki: %1°"), {amount}};
    case VertexRule::Maekawa:
      return {KIRI_TEXT("editor/session", "Maekawa: %1"), {amount}};
    case VertexRule::BigLittleBig:
      return {KIRI_TEXT("editor/session", "Big-little-big"), {}};
    case VertexRule::SelfCrossing:
      return {KIRI_TEXT("editor/session", "Paper through paper"), {}};
  }
  return {};
}

std::vector<Vec2> placesOf(const PatternView& view, const PatternAnalysis* analysis,
                           const PatternEntry& entry) {
  if (entry.kind == PatternEntry::Kind::Repair && entry.index < view.report.repairs.size())
    return view.report.repairs[entry.index].places;
  if (entry.kind == PatternEntry::Kind::Fault && entry.index < view.faultPlaces.size())
    return {view.faultPlaces[entry.index]};
  std::vector<Vec2> places;
  if (!analysis) return places;
  if (const std::vector<FacetId>* facets = facetsOf(*analysis, entry)) {
    for (const FacetId facet : *facets)
      places.push_back(interiorPointOf(analysis->creases.pattern, facet));
  }
  return places;
}

Marks patternMarks(const PatternView& view, const PatternAnalysis* analysis,
                   const PatternEntry& entry, bool showsFaults, const PaneMap& sheet) {
  Marks marks;
  if (!view.step) return marks;
  if (analysis) {
    if (const std::vector<FacetId>* facets = facetsOf(*analysis, entry)) {
      const bool isConflict = entry.kind == PatternEntry::Kind::Conflict;
      addOutlines(analysis->creases.pattern, *facets,
                  isConflict ? MarkRole::Fault : MarkRole::Selected, sheet, marks);
    }
  }
  if (showsFaults) addFaults(view, entry, sheet, marks);
  if (entry.kind == PatternEntry::Kind::Repair) {
    for (const Vec2 place : placesOf(view, analysis, entry))
      marks.push_back(PointMark{MarkRole::Snap, onSheet(sheet, place)});
  }
  return marks;
}

}  // namespace kiri
