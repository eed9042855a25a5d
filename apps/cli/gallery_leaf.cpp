// What the gallery shows of leaves beside other models: their measures.
// SPDX-License-Identifier: MIT
#include "apps/cli/gallery_leaf.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <variant>

#include "apps/cli/gallery_scenes.h"
#include "apps/cli/measure_names.h"
#include "core/base/text.h"
#include "core/paper/contours.h"
#include "render/scene/measure_scene.h"

namespace kiri::cli {

namespace {

bool hasCurvedCut(const Model& model) {
  return std::any_of(model.steps.begin(), model.steps.end(), [](const Step& step) {
    return std::holds_alternative<CurveCutStep>(step.action);
  });
}

/// The most creases that end in one place of the outer contour.
std::size_t largestFan(const CreasePattern& pattern) {
  std::vector<std::size_t> ends(pattern.vertices.size(), 0);
  for (const Edge& edge : pattern.edges) {
    if (edge.kind != EdgeKind::Hinge) continue;
    ++ends[edge.from.index];
    ++ends[edge.to.index];
  }
  std::size_t largest = 0;
  for (const std::vector<EdgeUse>& contour : contoursOf(pattern)) {
    for (const EdgeUse use : contour) {
      largest = std::max(largest, ends[pattern[use.edge].from.index]);
      largest = std::max(largest, ends[pattern[use.edge].to.index]);
    }
  }
  return largest;
}

/// Superscripts as people write them.
std::string unitInWords(const std::string& unit) {
  if (unit.empty() || unit == "deg") return unit.empty() ? "" : "°";
  return unit == "mm2" ? " mm²" : " " + unit;
}

std::string rounded(double value) {
  constexpr double kSteps = 1000;
  return text(std::round(value * kSteps) / kSteps);
}

}  // namespace

std::optional<LeafMeasures> galleryLeafOf(const Model& model, const FoldedState& finished,
                                          bool isOpen) {
  constexpr std::size_t kLeastFan = 3;
  if (!isOpen || !hasCurvedCut(model) || largestFan(finished.pattern) < kLeastFan) return {};
  const Result<LeafMeasures> measures = measuresOf(finished.pattern);
  if (!measures) return {};
  return *measures;
}

std::vector<GalleryMeasure> galleryMeasuresOf(const LeafMeasures& measures) {
  std::vector<GalleryMeasure> rows;
  for (const NamedMeasure& measure : namedMeasures(measures)) {
    if (!measure.value) continue;
    rows.push_back({measure.words, rounded(*measure.value) + unitInWords(measure.unit)});
  }
  return rows;
}

std::vector<GalleryMeasure> galleryMarginOf(const LeafMeasures& measures) {
  std::vector<GalleryMeasure> rows;
  for (const MarginPoint& point : measures.margin) {
    rows.push_back(
        {std::string(point.isLobe ? "lobe" : "sinus") + " at " + rounded(point.angle) + "°",
         rounded(point.length) + " mm"});
  }
  return rows;
}

Scene galleryMeasureScene(const FoldedState& finished, const LeafMeasures& measures,
                          const Appearance& appearance) {
  PatternSceneOptions options;
  const Scene plain = measureScene(finished, measures, appearance, options);
  const double larger = std::max(plain.width, plain.height);
  if (larger > 0) options.scale = kGalleryPage / larger;
  return measureScene(finished, measures, appearance, options);
}

}  // namespace kiri::cli
